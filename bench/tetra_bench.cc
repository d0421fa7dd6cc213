// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "bench/support.h"
#include "bench/tetra_baseline.h"

namespace gaunt::bench {
namespace {

constexpr uint32_t kCubes = 12;

// 12^3 cubes of six tetrahedra, whose inner corners are moved.
struct Volume {
  std::vector<float> vertices;
  std::vector<uint32_t> corners, neighbours;
  std::vector<uint8_t> mesh;
  std::vector<EngineTetrahedron> engine;
  // Where items are, and their taps.
  std::vector<uint32_t> tetrahedra = std::vector<uint32_t>(kLarge);
  std::vector<uint32_t> indices = std::vector<uint32_t>(4 * kLarge);
  std::vector<float> weights = std::vector<float>(4 * kLarge);
  size_t calls = 0;

  Volume() {
    constexpr uint32_t kSide = kCubes + 1;
    for (uint32_t i = 0; i < kSide * kSide * kSide; ++i) {
      const uint32_t whole[3] = {i % kSide, i / kSide % kSide, i / kSide / kSide};
      float noise[3];
      MakeNoise(i, 0, 3, noise);
      for (int a = 0; a < 3; ++a) {
        const bool inner = whole[a] > 0 && whole[a] < kCubes;
        vertices.push_back(static_cast<float>(whole[a]) + (inner ? 0.15f * noise[a] : 0.0f));
      }
    }
    constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    constexpr uint32_t kSteps[3] = {1, kSide, kSide * kSide};
    for (uint32_t i = 0; i < kCubes * kCubes * kCubes; ++i) {
      const uint32_t first =
          i % kCubes + kSide * (i / kCubes % kCubes + kSide * (i / kCubes / kCubes));
      for (const auto& order : kOrders) {
        uint32_t corner = first;
        corners.push_back(corner);
        for (const int axis : order) corners.push_back(corner += kSteps[axis]);
      }
    }
    const size_t count = corners.size() / 4, vertex_count = vertices.size() / 3;
    gaunt_view view;
    gaunt_view_interleaved(vertices.data(), 3, &view);
    size_t size = 0;
    gaunt_tetrahedra_prepare(vertex_count, nullptr, count, nullptr, nullptr, nullptr, &size);
    mesh.resize(size);
    gaunt_tetrahedra_prepare(vertex_count, &view, count, corners.data(), nullptr, mesh.data(),
                             &size);
    neighbours = NeighboursOf(count);
    engine = EngineMesh(vertices, corners, neighbours);
  }

  // The tetrahedra that share three corners.
  std::vector<uint32_t> NeighboursOf(size_t count) const {
    struct Face {
      uint32_t corners[3];
      uint32_t side;
    };
    std::vector<Face> faces;
    for (uint32_t side = 0; side < 4 * count; ++side) {
      Face face = {{}, side};
      for (uint32_t k = 0, n = 0; k < 4; ++k) {
        if (k != side % 4) face.corners[n++] = corners[side / 4 * 4 + k];
      }
      std::sort(face.corners, face.corners + 3);
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
      return std::lexicographical_compare(a.corners, a.corners + 3, b.corners, b.corners + 3);
    });
    std::vector<uint32_t> result(4 * count, UINT32_MAX);
    for (size_t i = 0; i + 1 < faces.size(); ++i) {
      if (std::memcmp(faces[i].corners, faces[i + 1].corners, sizeof(faces[i].corners)) != 0) {
        continue;
      }
      result[faces[i].side] = faces[i + 1].side / 4;
      result[faces[i + 1].side] = faces[i].side / 4;
    }
    return result;
  }
};

// Side 0: anywhere in the box. Side 1: half an edge, at most, further along each axis.
void MakePosition(size_t item, size_t side, float* planes) {
  MakeNoise(item, 0, 3, planes);
  float moved[3];
  MakeNoise(item, 1, 3, moved);
  for (int a = 0; a < 3; ++a) {
    planes[a] = 5.4f * planes[a] + 6.0f + (side == 1 ? 0.5f * moved[a] : 0.0f);
  }
}

}  // namespace

GAUNT_BENCHMARKS(tetra) {
  const auto volume = std::make_shared<Volume>();
  for (const bool moving : {false, true}) {
    const std::string name = moving ? "tetra/taps_moving/n1" : "tetra/taps_still/n1";
    BatchBenchmark batch;
    batch.name = name;
    batch.operations = OperationsOf("tetrahedra_taps", "1", "step") +
                       OperationsOf("tetrahedra_taps", "1", "weights");
    batch.inputs = {3, 3};
    batch.make = MakePosition;
    batch.more_read = 64 + 16 + sizeof(uint32_t);
    batch.more_written = sizeof(uint32_t) + 4 * (sizeof(uint32_t) + sizeof(float));
    batch.call = [=](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views&) {
      return gaunt_tetrahedra_taps(volume->mesh.data(), volume->mesh.size(), count,
                                   in[moving ? ++volume->calls % 2 : 0], volume->tetrahedra.data(),
                                   volume->indices.data(), volume->weights.data());
    };
    RegisterBatch(batch);
    ScalarBenchmark scalar;
    scalar.name = name;
    scalar.baseline = "engine";
    scalar.inputs = {3, 3};
    scalar.output = 1;
    scalar.make = MakePosition;
    scalar.call = [=](size_t count, const std::vector<const float*>& in, float*) {
      TetrahedraEngine(volume->engine, count, in[moving ? ++volume->calls % 2 : 0],
                       volume->tetrahedra.data(), volume->indices.data(), volume->weights.data());
    };
    RegisterScalar(scalar);
  }
}

}  // namespace gaunt::bench
