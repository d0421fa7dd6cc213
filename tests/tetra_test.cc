// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "tests/support/buffer.h"
#include "tests/support/guarded.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"
#include "tetra/tetra_reference.h"

namespace gaunt::test {
namespace {

using tetra::MeshReference;
using Point = std::array<double, 3>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// A mesh as callers have it, and for the reference.
struct Scene {
  MeshReference reference;
  std::vector<float> vertices;       // interleaved
  std::vector<uint32_t> corners;     // of tetrahedra
  std::vector<uint32_t> neighbours;  // given, or empty
  std::vector<uint8_t> bytes;

  void AddVertex(const Point& p) {
    Point rounded;
    for (size_t a = 0; a < 3; ++a) {
      vertices.push_back(static_cast<float>(p[a]));
      rounded[a] = double{vertices.back()};
    }
    reference.vertices.push_back(rounded);
  }
  void AddTetrahedron(const std::array<uint32_t, 4>& own) {
    corners.insert(corners.end(), own.begin(), own.end());
    reference.tetrahedra.push_back(own);
  }
  size_t size() const { return corners.size() / 4; }
  gaunt_status Prepare() {
    gaunt_view view;
    gaunt_view_interleaved(vertices.data(), 3, &view);
    size_t wanted = 0;
    const size_t vertex_count = vertices.size() / 3;
    EXPECT_EQ(
        gaunt_tetrahedra_prepare(vertex_count, nullptr, size(), nullptr, nullptr, nullptr, &wanted),
        GAUNT_OK);
    EXPECT_EQ(wanted, 64 + 80 * size() + 12 * vertex_count);
    bytes.assign(wanted, 0xA5);
    return gaunt_tetrahedra_prepare(vertex_count, &view, size(), corners.data(),
                                    neighbours.empty() ? nullptr : neighbours.data(), bytes.data(),
                                    &wanted);
  }
};

// A box of n^3 cubes of six tetrahedra each, whose inner vertices are moved by up to `jitter`.
// `flat`: diagonals of neighbouring cubes do not meet, and flat tetrahedra lie between them.
Scene MakeBox(Random& random, uint32_t n, double jitter, bool flat, double scale = 1.0,
              const Point& origin = {0.0, 0.0, 0.0}) {
  Scene scene;
  const uint32_t side = n + 1;
  const auto at = [&](uint32_t x, uint32_t y, uint32_t z) { return x + side * (y + side * z); };
  for (uint32_t z = 0; z < side; ++z) {
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        const uint32_t whole[3] = {x, y, z};
        Point p;
        for (size_t a = 0; a < 3; ++a) {
          const bool inner = whole[a] > 0 && whole[a] < n;
          p[a] = origin[a] + scale * (whole[a] + (inner ? jitter * random.Between(-1, 1) : 0.0));
        }
        scene.AddVertex(p);
      }
    }
  }
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (uint32_t z = 0; z < n; ++z) {
    for (uint32_t y = 0; y < n; ++y) {
      for (uint32_t x = 0; x < n; ++x) {
        // Mirrored along an axis, the diagonals of the faces along the other two turn.
        const uint32_t mirror[3] = {flat ? z % 2 : 0, flat ? x % 2 : 0, 0};
        for (const auto& order : kOrders) {
          std::array<uint32_t, 4> own;
          uint32_t corner[3] = {0, 0, 0};
          for (size_t k = 0; k < 4; ++k) {
            own[k] = at(x + (corner[0] ^ mirror[0]), y + (corner[1] ^ mirror[1]),
                        z + (corner[2] ^ mirror[2]));
            if (k < 3) corner[order[k]] = 1;
          }
          std::swap(own[random.Bits() % 4], own[random.Bits() % 4]);
          scene.AddTetrahedron(own);
        }
        if (!flat) continue;
        if (x + 1 < n) {
          scene.AddTetrahedron(
              {at(x + 1, y, z), at(x + 1, y + 1, z), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1)});
        }
        if (z + 1 < n) {
          scene.AddTetrahedron(
              {at(x, y, z + 1), at(x + 1, y, z + 1), at(x, y + 1, z + 1), at(x + 1, y + 1, z + 1)});
        }
      }
    }
  }
  return scene;
}

struct Result {
  std::vector<uint32_t> tetrahedra, indices;
  std::vector<float> weights;
};

// Every item from where `start` says.
Result Find(const Scene& scene, std::vector<float> positions, const std::vector<uint32_t>& start) {
  const size_t count = positions.size() / 3;
  Result result = {start, std::vector<uint32_t>(4 * count), std::vector<float>(4 * count)};
  gaunt_view view;
  gaunt_view_interleaved(positions.data(), 3, &view);
  EXPECT_EQ(
      gaunt_tetrahedra_taps(scene.bytes.data(), scene.bytes.size(), count, &view,
                            result.tetrahedra.data(), result.indices.data(), result.weights.data()),
      GAUNT_OK);
  return result;
}

Point PointOf(const float* p) { return {double{p[0]}, double{p[1]}, double{p[2]}}; }

// What is true of every item that has a position; the point that its weights give.
Point ExpectSound(const Scene& scene, const Result& result, size_t i) {
  const uint32_t t = result.tetrahedra[i];
  EXPECT_LT(t, scene.size());
  double sum = 0.0;
  Point point = {0.0, 0.0, 0.0};
  for (size_t k = 0; k < 4; ++k) {
    const double weight = double{result.weights[4 * i + k]};
    EXPECT_GE(weight, 0.0);
    EXPECT_EQ(result.indices[4 * i + k], scene.corners[4 * t + k]);
    sum += weight;
    for (size_t a = 0; a < 3; ++a) {
      point[a] += weight * scene.reference.vertices[scene.corners[4 * t + k]][a];
    }
  }
  EXPECT_NEAR(sum, 1.0, 2e-7);
  return point;
}

// Barycentrics of the definition, where the position is well inside.
void ExpectInside(const Scene& scene, const float* position, const Result& result, size_t i) {
  const Point p = PointOf(position);
  const tetra::FoundReference found = tetra::FindReference(scene.reference, p);
  ASSERT_GE(found.least, -1e-6);
  const uint32_t t = result.tetrahedra[i];
  if (found.least > 1e-4) {
    ASSERT_EQ(t, found.tetrahedron);
  }
  const auto wanted = tetra::BarycentricsReference(scene.reference, t, p);
  const double aspect = tetra::AspectReference(scene.reference, t);
  ASSERT_LE(aspect, 1.001e5);  // flatter ones hold nothing
  const double tolerance = 1e-6 + 2e-6 * aspect;
  for (size_t k = 0; k < 4; ++k) {
    ASSERT_NEAR(result.weights[4 * i + k], wanted[k], tolerance);
  }
}

std::vector<float> MakePositions(Random& random, size_t count, double from, double to) {
  std::vector<float> positions(3 * count);
  random.Fill(positions.data(), positions.size(), from, to);
  return positions;
}

class Tetrahedra : public TargetTest {};

TEST_P(Tetrahedra, HoldThePositionsFromEveryStart) {
  Random random(1);
  for (const bool flat : {false, true}) {
    for (const uint32_t n : {1u, 2u, 4u}) {
      for (const size_t count :
           {size_t{1}, size_t{3}, size_t{15}, size_t{16}, size_t{17}, size_t{300}}) {
        SCOPED_TRACE("n " + std::to_string(n) + " flat " + std::to_string(flat));
        // Some of the flat ones are flat but for 1e-7.
        Scene scene = MakeBox(random, n, !flat ? 0.15 : count % 2 != 0 ? 1e-7 : 0.0, flat);
        ASSERT_EQ(scene.Prepare(), GAUNT_OK);
        std::vector<float> positions = MakePositions(random, count, 0.0, n);
        for (size_t i = 0; i < count; i += 5) {  // on faces, edges and corners too
          for (size_t a = 0; a < i % 4; ++a) {
            positions[3 * i + a] = std::round(2.0f * positions[3 * i + a]) / 2.0f;
          }
        }
        std::vector<uint32_t> start(count);
        for (uint32_t& t : start) t = static_cast<uint32_t>(random.Bits() % scene.size());
        start[0] = GAUNT_NO_PROBE;
        const Result result = Find(scene, positions, start);
        for (size_t i = 0; i < count; ++i) {
          const Point point = ExpectSound(scene, result, i);
          ExpectInside(scene, &positions[3 * i], result, i);
          for (size_t a = 0; a < 3; ++a) ASSERT_NEAR(point[a], positions[3 * i + a], 1e-5);
        }
        // From there no step is taken.
        const Result again = Find(scene, positions, result.tetrahedra);
        EXPECT_EQ(again.tetrahedra, result.tetrahedra);
        EXPECT_EQ(again.weights, result.weights);
      }
    }
  }
}

TEST_P(Tetrahedra, TakePositionsOfEveryLayout) {
  Random random(2);
  Scene scene = MakeBox(random, 3, 0.15, false);
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  for (const size_t count : {0, 1, 3, 7, 8, 9, 15, 16, 17, 33, 70}) {
    std::vector<Layout> layouts = Layouts();
    layouts.push_back(Layout::kBroadcast);
    for (const Layout layout : layouts) {
      SCOPED_TRACE(Name(layout) + " " + std::to_string(count));
      Buffer positions(layout, count, 3);
      std::vector<float> packed(3 * count);
      for (size_t i = 0; i < count; ++i) {
        for (size_t a = 0; a < 3; ++a) positions.Set(i, a, random.Between(-1.0, 4.0));
      }
      for (size_t k = 0; k < packed.size(); ++k) packed[k] = positions.Get(k / 3, k % 3);
      const Result wanted = Find(scene, packed, std::vector<uint32_t>(count, 5));
      // Canaries on both sides.
      std::vector<uint32_t> at(count + 32, 5), indices(4 * count + 32, 77);
      std::vector<float> weights(4 * count + 32, -7.0f);
      ASSERT_EQ(
          gaunt_tetrahedra_taps(scene.bytes.data(), scene.bytes.size(), count, positions.view(),
                                at.data() + 16, indices.data() + 16, weights.data() + 16),
          GAUNT_OK);
      for (size_t k = 0; k < 16; ++k) {
        ASSERT_EQ(at[k] + at[16 + count + k], 10u);
        ASSERT_EQ(indices[k] + indices[16 + 4 * count + k], 154u);
        ASSERT_EQ(weights[k] + weights[16 + 4 * count + k], -14.0f);
      }
      ASSERT_TRUE(std::equal(wanted.tetrahedra.begin(), wanted.tetrahedra.end(), at.data() + 16));
      ASSERT_TRUE(std::equal(wanted.indices.begin(), wanted.indices.end(), indices.data() + 16));
      ASSERT_TRUE(std::equal(wanted.weights.begin(), wanted.weights.end(), weights.data() + 16));
    }
  }
}

// The mesh's far from the origin, small, large, and anisotropic.
TEST_P(Tetrahedra, OfEverySizeAndPlace) {
  Random random(3);
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e9}) {
    for (const double away : {0.0, 30.0}) {
      Scene scene = MakeBox(random, 3, 0.2, false, scale, {away * scale, -away * scale, 0.0});
      ASSERT_EQ(scene.Prepare(), GAUNT_OK);
      std::vector<float> positions = MakePositions(random, 100, 0.001, 2.999);
      for (size_t i = 0; i < positions.size(); ++i) {
        const double moved = i % 3 == 0 ? away : i % 3 == 1 ? -away : 0.0;
        positions[i] = static_cast<float>(scale * (double{positions[i]} + moved));
      }
      const Result result = Find(scene, positions, std::vector<uint32_t>(100, 0));
      for (size_t i = 0; i < 100; ++i) {
        ExpectSound(scene, result, i);
        ExpectInside(scene, &positions[3 * i], result, i);
      }
    }
  }
}

// Weights do not jump where a position goes from one tetrahedron to the next.
TEST_P(Tetrahedra, BlendContinuouslyAndReproduceLinearFunctions) {
  Random random(4);
  Scene scene = MakeBox(random, 4, 0.15, false);
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  std::vector<double> values(scene.reference.vertices.size());
  for (double& value : values) value = random.Uniform();
  constexpr size_t kSteps = 4000;
  std::vector<float> positions(3 * kSteps);
  for (size_t i = 0; i < kSteps; ++i) {
    const double s = static_cast<double>(i) / (kSteps - 1);
    positions[3 * i] = static_cast<float>(4.0 * s);
    positions[3 * i + 1] = static_cast<float>(2.0 + 1.9 * std::sin(7.0 * s));
    positions[3 * i + 2] = static_cast<float>(2.0 + 1.9 * std::cos(9.0 * s));
  }
  const Result result = Find(scene, positions, std::vector<uint32_t>(kSteps, 0));
  double before = 0.0;
  for (size_t i = 0; i < kSteps; ++i) {
    double value = 0.0, linear = 0.0, wanted = 0.0;
    for (size_t k = 0; k < 4; ++k) {
      const uint32_t index = result.indices[4 * i + k];
      const double weight = double{result.weights[4 * i + k]};
      value += weight * values[index];
      for (size_t a = 0; a < 3; ++a) {
        linear += weight * (0.3 + double(a)) * scene.reference.vertices[index][a];
      }
    }
    for (size_t a = 0; a < 3; ++a) wanted += (0.3 + double(a)) * double{positions[3 * i + a]};
    ASSERT_NEAR(linear, wanted, 2e-5);
    // A step is about 1/200 of an edge; gradients are those of edges of 0.4 at least.
    ASSERT_TRUE(i == 0 || std::abs(value - before) < 0.05) << i;
    before = value;
  }
}

// Nothing of the tetrahedron is nearer to a position outside than the point that the weights give:
// no corner lies further towards the position than it.
TEST_P(Tetrahedra, TakeTheNearestPointFromOutside) {
  Random random(5);
  for (const bool flat : {false, true}) {
    Scene scene = MakeBox(random, 3, flat ? 0.0 : 0.15, flat);
    ASSERT_EQ(scene.Prepare(), GAUNT_OK);
    std::vector<float> positions = MakePositions(random, 500, -4.0, 7.0);
    std::vector<uint32_t> start(500);
    for (uint32_t& t : start) t = static_cast<uint32_t>(random.Bits() % scene.size());
    const Result result = Find(scene, positions, start);
    size_t outside = 0;
    for (size_t i = 0; i < 500; ++i) {
      const Point p = PointOf(&positions[3 * i]), q = ExpectSound(scene, result, i);
      Point nearest;  // of the box
      bool inside = true;
      for (size_t a = 0; a < 3; ++a) {
        nearest[a] = std::clamp(p[a], 0.0, 3.0);
        inside = inside && nearest[a] == p[a];
      }
      if (inside) continue;
      ++outside;
      double border = 1.0;
      for (size_t k = 0; k < 4; ++k) {
        const Point& v = scene.reference.vertices[result.indices[4 * i + k]];
        double towards = 0.0;
        for (size_t a = 0; a < 3; ++a) towards += (p[a] - q[a]) * (v[a] - q[a]);
        ASSERT_LE(towards, 1e-5);
      }
      for (size_t a = 0; a < 3; ++a) {
        border = std::min({border, std::abs(q[a]), std::abs(q[a] - 3.0)});
      }
      ASSERT_LE(border, 1e-6);
      // Not far from what is nearest of all: one cube or so.
      double distance = 0.0;
      for (size_t a = 0; a < 3; ++a) distance += (q[a] - nearest[a]) * (q[a] - nearest[a]);
      ASSERT_LE(std::sqrt(distance), 3.0);
    }
    EXPECT_GT(outside, 300u);
  }
}

TEST_P(Tetrahedra, AreFoundWithoutTheWalk) {
  Random random(6);
  Scene scene = MakeBox(random, 3, 0.15, false);
  // Three that only lead to each other.
  const uint32_t n = static_cast<uint32_t>(scene.size());
  scene.neighbours.resize(4 * n, GAUNT_NO_PROBE);
  for (uint32_t t = 0; t < 3; ++t) {
    for (uint32_t k = 0; k < 4; ++k) scene.neighbours[4 * t + k] = (t + 1) % 3;
  }
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  const std::vector<float> positions = MakePositions(random, 50, 0.5, 2.999);
  std::vector<uint32_t> start(50);
  for (uint32_t& t : start) t = static_cast<uint32_t>(random.Bits() % 3);
  const Result result = Find(scene, positions, start);
  for (size_t i = 0; i < 50; ++i) {
    ExpectSound(scene, result, i);
    ExpectInside(scene, &positions[3 * i], result, i);
  }
  const Result far = Find(scene, {9.0f, 1.5f, 1.5f}, {0});
  EXPECT_NEAR(ExpectSound(scene, far, 0)[0], 3.0, 1e-6);
}

// Two meshes at one place, of which a search would find the first: walks in the second stay there, so
// they get through flat tetrahedra, and on and off faces, without being given up.
TEST_P(Tetrahedra, AreReachedByWalks) {
  struct Case {
    double jitter, squash;
    bool flat;
  };
  // Squashed, barycentrics round by much more than what counts as inside.
  for (const Case& box : {Case{0.15, 1.0, false}, Case{0.0, 1.0, true}, Case{0.15, 3e-4, false}}) {
    Random random(15), again(15);
    Scene scene;
    const Scene first = MakeBox(random, 4, box.jitter, box.flat);
    const Scene second = MakeBox(again, 4, box.jitter, box.flat);
    // Squashed along z, and turned about x and y where that is done.
    const auto turned = [&](const Point& p) -> Point {
      if (box.squash == 1.0) return p;
      const double z = box.squash * p[2], y = 0.8 * p[1] + 0.6 * z, w = 0.8 * z - 0.6 * p[1];
      return {0.96 * p[0] + 0.28 * w, y, 0.96 * w - 0.28 * p[0]};
    };
    const uint32_t n = static_cast<uint32_t>(first.size());
    for (const Scene* part : {&first, &second}) {
      const uint32_t moved = static_cast<uint32_t>(scene.vertices.size() / 3);
      for (const Point& p : part->reference.vertices) scene.AddVertex(turned(p));
      for (const auto& own : part->reference.tetrahedra) {
        scene.AddTetrahedron({own[0] + moved, own[1] + moved, own[2] + moved, own[3] + moved});
      }
    }
    ASSERT_EQ(scene.Prepare(), GAUNT_OK);
    constexpr size_t kItems = 10000;
    std::vector<float> positions = MakePositions(random, kItems, -1.0, 5.0);
    for (size_t k = 0; k < positions.size(); ++k) {
      if (k % 4 == 0) positions[k] = std::round(positions[k]);
      if (k % 101 == 0) positions[k] = (k % 2 == 0 ? 1 : -1) * std::numeric_limits<float>::max();
    }
    for (size_t i = 0; i < kItems; ++i) {
      const Point p = turned(PointOf(&positions[3 * i]));
      for (size_t a = 0; a < 3; ++a) {
        constexpr double kLargest = std::numeric_limits<float>::max();
        positions[3 * i + a] = static_cast<float>(std::clamp(p[a], -kLargest, kLargest));
      }
    }
    std::vector<uint32_t> start(kItems);
    for (uint32_t& t : start) t = n + static_cast<uint32_t>(random.Bits() % n);
    const Result result = Find(scene, positions, start);
    for (const uint32_t t : result.tetrahedra) ASSERT_GE(t, n);
  }
}

// Some tetrahedra are inside out, and lie over others: one that holds the position is found still.
TEST_P(Tetrahedra, OfFoldedMeshesHoldThePositions) {
  Random random(14);
  for (const double jitter : {0.3, 0.4}) {
    for (int round = 0; round < 5; ++round) {
      Scene scene = MakeBox(random, 4, jitter, false);
      ASSERT_EQ(scene.Prepare(), GAUNT_OK);
      constexpr size_t kItems = 1000;
      const std::vector<float> positions = MakePositions(random, kItems, 0.0, 4.0);
      std::vector<uint32_t> start(kItems);
      for (uint32_t& t : start) t = static_cast<uint32_t>(random.Bits() % scene.size());
      const Result result = Find(scene, positions, start);
      for (size_t i = 0; i < kItems; ++i) {
        const Point point = ExpectSound(scene, result, i);
        for (size_t a = 0; a < 3; ++a) ASSERT_NEAR(point[a], positions[3 * i + a], 1e-4);
      }
    }
  }
}

// Whatever neighbours say, walks end, and taps are sound.
TEST_P(Tetrahedra, SurviveAnyNeighbours) {
  Random random(7);
  for (int round = 0; round < 30; ++round) {
    Scene scene = MakeBox(random, 2, round % 2 == 0 ? 0.15 : 0.0, round % 3 == 0);
    for (size_t k = 0; k < scene.corners.size(); ++k) {
      const uint32_t other = static_cast<uint32_t>(random.Bits() % scene.size());
      const bool is_none = random.Bits() % 4 == 0 || other == k / 4;  // its own it must not be
      scene.neighbours.push_back(is_none ? GAUNT_NO_PROBE : other);
    }
    ASSERT_EQ(scene.Prepare(), GAUNT_OK);
    const std::vector<float> positions = MakePositions(random, 40, -1.0, 3.0);
    const Result result = Find(scene, positions, std::vector<uint32_t>(40, 1));
    for (size_t i = 0; i < 40; ++i) ExpectSound(scene, result, i);
  }
}

// A single one: nothing of it is nearer than the point that the weights give.
TEST_P(Tetrahedra, OfEveryShapeHaveNearestPoints) {
  std::vector<std::vector<Point>> shapes = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},        // a square
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},        // a line
      {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}},        // a point
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-7}}  // nearly flat
  };
  Random shape_random(16);
  while (shapes.size() < 30) {
    std::vector<Point> shape(4);
    for (Point& p : shape) {
      for (double& x : p) x = double{shape_random.Between(-1.0, 2.0)};
    }
    shapes.push_back(shape);
  }
  for (const std::vector<Point>& shape : shapes) {
    Scene scene;
    for (const Point& p : shape) scene.AddVertex(p);
    scene.AddTetrahedron({0, 1, 2, 3});
    ASSERT_EQ(scene.Prepare(), GAUNT_OK);
    Random random(8);
    const std::vector<float> positions = MakePositions(random, 100, -2.0, 4.0);
    const Result result = Find(scene, positions, std::vector<uint32_t>(100, 0));
    for (size_t i = 0; i < 100; ++i) {
      const Point p = PointOf(&positions[3 * i]), q = ExpectSound(scene, result, i);
      for (const Point& v : shape) {
        double towards = 0.0;
        for (size_t a = 0; a < 3; ++a) towards += (p[a] - q[a]) * (v[a] - q[a]);
        ASSERT_LE(towards, 2e-6);
      }
    }
  }
}

TEST_P(Tetrahedra, OfPositionsThatAreNoneOrFarAway) {
  Random random(9);
  Scene scene = MakeBox(random, 2, 0.15, true);
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  const float largest = std::numeric_limits<float>::max();
  std::vector<float> positions;
  for (const float x : {kNaN, kInfinity, -kInfinity, largest, -largest, 1.2f, 1e-45f}) {
    for (const float y : {kNaN, kInfinity, largest, 0.3f}) {
      for (const float z : {-kInfinity, -largest, 0.7f}) {
        positions.insert(positions.end(), {x, y, z});
      }
    }
  }
  const size_t count = positions.size() / 3;
  const Result result = Find(scene, positions, std::vector<uint32_t>(count, 3));
  for (size_t i = 0; i < count; ++i) {
    const float* const p = &positions[3 * i];
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) {
      ExpectSound(scene, result, i);
    } else {
      EXPECT_EQ(result.tetrahedra[i], 3u);
      for (size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(result.indices[4 * i + k], GAUNT_NO_PROBE);
        EXPECT_EQ(result.weights[4 * i + k], 0.0f);
      }
    }
  }
}

// Bytes at any alignment, and nothing read around them, even if they were changed.
TEST_P(Tetrahedra, ReadNothingAroundTheBytes) {
  Random random(10);
  Scene scene = MakeBox(random, 2, 0.15, true);
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  const std::vector<float> positions = MakePositions(random, 64, -1.0, 3.0);
  const Result wanted = Find(scene, positions, std::vector<uint32_t>(64, 0));
  const GuardedBytes guarded(scene.bytes.size());
  for (int round = 0; round < 50; ++round) {
    std::memcpy(guarded.data(), scene.bytes.data(), scene.bytes.size());
    for (size_t k = 64; round > 0 && k < scene.bytes.size(); ++k) {
      if (random.Bits() % 8 == 0) guarded.data()[k] = static_cast<char>(random.Bits());
    }
    for (size_t count = 1; count <= 64; count += round == 0 ? 1 : 21) {
      const GuardedFloats p(3 * count), at(count), indices(4 * count), weights(4 * count);
      std::copy_n(positions.data(), 3 * count, p.data());
      std::fill_n(at.data(), count, 0.0f);
      gaunt_view view;
      gaunt_view_interleaved(p.data(), 3, &view);
      ASSERT_EQ(gaunt_tetrahedra_taps(guarded.data(), scene.bytes.size(), count, &view,
                                      reinterpret_cast<uint32_t*>(at.data()),
                                      reinterpret_cast<uint32_t*>(indices.data()), weights.data()),
                GAUNT_OK);
      if (round > 0) continue;
      ASSERT_EQ(std::memcmp(weights.data(), wanted.weights.data(), 16 * count), 0);
    }
  }
}

TEST_P(Tetrahedra, RejectWrongArguments) {
  Random random(11);
  Scene scene = MakeBox(random, 1, 0.0, false);
  const size_t count = scene.size(), vertex_count = scene.vertices.size() / 3;
  gaunt_view vertices;
  gaunt_view_interleaved(scene.vertices.data(), 3, &vertices);
  const size_t bytes = 64 + 80 * count + 12 * vertex_count;
  std::vector<uint8_t> mesh(bytes, 0x5A);
  const std::vector<uint8_t> before = mesh;
  size_t size = bytes;
  const auto prepare = [&](const uint32_t* corners, const uint32_t* neighbours) {
    return gaunt_tetrahedra_prepare(vertex_count, &vertices, count, corners, neighbours,
                                    mesh.data(), &size);
  };
  const uint32_t* const good = scene.corners.data();
  for (const uint32_t wrong : {static_cast<uint32_t>(vertex_count), GAUNT_NO_PROBE}) {
    for (const size_t k : {size_t{0}, scene.corners.size() - 1}) {
      std::vector<uint32_t> corners = scene.corners;
      corners[k] = wrong;
      EXPECT_EQ(prepare(corners.data(), nullptr), GAUNT_ERROR_RANGE);
      std::vector<uint32_t> neighbours(4 * count, GAUNT_NO_PROBE);
      neighbours[k] = static_cast<uint32_t>(count) + (wrong == GAUNT_NO_PROBE ? 1000000 : 0);
      EXPECT_EQ(prepare(good, neighbours.data()), GAUNT_ERROR_RANGE);
    }
  }
  for (uint32_t k = 0; k < 4 * count; ++k) {  // its own neighbour
    std::vector<uint32_t> neighbours(4 * count, GAUNT_NO_PROBE);
    neighbours[k] = k / 4;
    EXPECT_EQ(prepare(good, neighbours.data()), GAUNT_ERROR_RANGE);
  }
  for (const float wrong : {kNaN, kInfinity, -kInfinity, 2e15f, -2e15f}) {
    const float kept = scene.vertices.back();
    scene.vertices.back() = wrong;
    EXPECT_EQ(prepare(good, nullptr), GAUNT_ERROR_RANGE);
    scene.vertices.back() = kept;
  }
  EXPECT_EQ(prepare(nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(
      gaunt_tetrahedra_prepare(vertex_count, nullptr, count, good, nullptr, mesh.data(), &size),
      GAUNT_ERROR_NULL);
  EXPECT_EQ(
      gaunt_tetrahedra_prepare(vertex_count, &vertices, count, good, nullptr, mesh.data(), nullptr),
      GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_tetrahedra_prepare(0, &vertices, count, good, nullptr, nullptr, &size),
            GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_tetrahedra_prepare(vertex_count, &vertices, 0, good, nullptr, nullptr, &size),
            GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_tetrahedra_prepare(vertex_count, &vertices, (size_t{1} << 28) + 1, good, nullptr,
                                     nullptr, &size),
            GAUNT_ERROR_RANGE);
  size = bytes - 1;
  EXPECT_EQ(prepare(good, nullptr), GAUNT_ERROR_RANGE);
  size = bytes;
  EXPECT_EQ(gaunt_tetrahedra_prepare(vertex_count, &vertices, count, good, nullptr,
                                     scene.vertices.data(), &size),
            GAUNT_ERROR_OVERLAP);
  gaunt_view odd = vertices;
  odd.item_stride = 13;
  EXPECT_EQ(gaunt_tetrahedra_prepare(vertex_count, &odd, count, good, nullptr, mesh.data(), &size),
            GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(size, bytes);
  EXPECT_EQ(mesh, before);

  size = bytes + 7;  // more than needed
  mesh.resize(size);
  ASSERT_EQ(prepare(good, nullptr), GAUNT_OK);
  EXPECT_EQ(size, bytes);
  Buffer positions(Layout::kInterleaved, 4, 3);
  const gaunt_view* const v = positions.view();
  std::vector<uint32_t> at(4, 9), indices(16, 9);
  std::vector<float> weights(16, 9.0f);
  const auto taps = [&](const void* m, size_t n, const gaunt_view* p, uint32_t* t, uint32_t* i,
                        float* w) { return gaunt_tetrahedra_taps(m, n, 4, p, t, i, w); };
  const void* const m = mesh.data();
  EXPECT_EQ(taps(nullptr, bytes, v, at.data(), indices.data(), weights.data()), GAUNT_ERROR_NULL);
  EXPECT_EQ(taps(m, bytes, nullptr, at.data(), indices.data(), weights.data()), GAUNT_ERROR_NULL);
  EXPECT_EQ(taps(m, bytes, v, nullptr, indices.data(), weights.data()), GAUNT_ERROR_NULL);
  EXPECT_EQ(taps(m, bytes, v, at.data(), nullptr, weights.data()), GAUNT_ERROR_NULL);
  EXPECT_EQ(taps(m, bytes, v, at.data(), indices.data(), nullptr), GAUNT_ERROR_NULL);
  for (const size_t n : {size_t{0}, size_t{63}, bytes - 1, bytes + 1}) {
    EXPECT_EQ(taps(m, n, v, at.data(), indices.data(), weights.data()), GAUNT_ERROR_FORMAT);
  }
  for (size_t k = 0; k < 64; ++k) {
    mesh[k] ^= 1;
    EXPECT_EQ(taps(m, bytes, v, at.data(), indices.data(), weights.data()), GAUNT_ERROR_FORMAT);
    mesh[k] ^= 1;
  }
  EXPECT_EQ(
      gaunt_tetrahedra_taps(m, bytes, SIZE_MAX / 2, v, at.data(), indices.data(), weights.data()),
      GAUNT_ERROR_RANGE);
  EXPECT_EQ(taps(m, bytes, v, at.data(), at.data() + 3, weights.data()), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(taps(m, bytes, v, at.data(), indices.data(), v->data), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(at, std::vector<uint32_t>(4, 9));
  EXPECT_EQ(indices, std::vector<uint32_t>(16, 9));
  EXPECT_EQ(weights, std::vector<float>(16, 9.0f));
  EXPECT_EQ(gaunt_tetrahedra_taps(m, bytes, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_OK);
}

// Neighbours that were found lead to each other, across the same face.
TEST(TetrahedraPrepare, FindsTheNeighbours) {
  Random random(12);
  for (const bool flat : {false, true}) {
    Scene scene = MakeBox(random, 3, 0.15, flat);
    ASSERT_EQ(scene.Prepare(), GAUNT_OK);
    const auto neighbour = [&](size_t t, size_t k) {
      uint32_t value;
      std::memcpy(&value, scene.bytes.data() + 64 + 64 * t + 48 + 4 * k, 4);
      return value;
    };
    const auto face = [&](size_t t, size_t k) {
      std::vector<uint32_t> own(scene.corners.begin() + static_cast<ptrdiff_t>(4 * t),
                                scene.corners.begin() + static_cast<ptrdiff_t>(4 * t + 4));
      own.erase(own.begin() + static_cast<ptrdiff_t>(k));
      std::sort(own.begin(), own.end());
      return own;
    };
    size_t border = 0;
    for (size_t t = 0; t < scene.size(); ++t) {
      for (size_t k = 0; k < 4; ++k) {
        const uint32_t other = neighbour(t, k);
        if (other == GAUNT_NO_PROBE) {
          ++border;
          continue;
        }
        ASSERT_LT(other, scene.size());
        bool leads_back = false;
        for (size_t j = 0; j < 4; ++j) {
          leads_back = leads_back || (neighbour(other, j) == t && face(other, j) == face(t, k));
        }
        ASSERT_TRUE(leads_back);
      }
    }
    EXPECT_EQ(border, 6u * 9 * 2);  // two triangles per square
    // The same bytes from these neighbours.
    Scene given = scene;
    for (size_t k = 0; k < scene.corners.size(); ++k) {
      given.neighbours.push_back(neighbour(k / 4, k % 4));
    }
    ASSERT_EQ(given.Prepare(), GAUNT_OK);
    EXPECT_EQ(given.bytes, scene.bytes);
  }
}

// Equal bits on targets with fused multiply-add, and on the others.
TEST(TetrahedraBits, AreEqualOnTargetsOfAKind) {
  Random random(13);
  Scene scene = MakeBox(random, 4, 0.15, true);
  ASSERT_EQ(scene.Prepare(), GAUNT_OK);
  const std::vector<float> positions = MakePositions(random, 500, -1.0, 5.0);
  Result first[2];
  for (const std::string& target : SupportedTargets()) {
    ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    const Result result = Find(scene, positions, std::vector<uint32_t>(500, 0));
    Result& wanted = first[HasFma(target) ? 1 : 0];
    if (wanted.weights.empty()) wanted = result;
    EXPECT_EQ(result.tetrahedra, wanted.tetrahedra) << target;
    EXPECT_EQ(result.weights, wanted.weights) << target;
  }
  gaunt_target_select(nullptr);
}

TEST(TetrahedraCpp, ThrowsAndFinds) {
  const float vertices[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t corners[4] = {3, 2, 1, 0};
  const std::vector<unsigned char> mesh =
      TetrahedraPrepare(4, Interleaved(vertices, 3), 1, corners, nullptr);
  const float p[3] = {0.125f, 0.25f, 0.5f};
  uint32_t at = GAUNT_NO_PROBE, indices[4];
  float weights[4];
  TetrahedraTaps(mesh.data(), mesh.size(), 1, Interleaved(p, 3), &at, indices, weights);
  EXPECT_EQ(at, 0u);
  const float wanted[4] = {0.5f, 0.25f, 0.125f, 0.125f};
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(indices[k], corners[k]);
    EXPECT_EQ(weights[k], wanted[k]);
  }
  EXPECT_THROW(TetrahedraTaps(mesh.data(), 3, 1, Interleaved(p, 3), &at, indices, weights), Error);
}

GAUNT_INSTANTIATE_TARGETS(Tetrahedra);

}  // namespace
}  // namespace gaunt::test
