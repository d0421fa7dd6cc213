// SPDX-License-Identifier: MIT
#include "bench/grid_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {
namespace {

constexpr gaunt_grid kGrid = {sizeof(kGrid),      {16, 8, 16}, {-8.0f, 0.0f, -8.0f},
                              {1.0f, 0.5f, 1.0f}, 0,           {0, 0, 0}};
constexpr uint32_t kProbes = 16 * 8 * 16;

// Anywhere in the grid, and a little outside.
void MakePosition(size_t item, size_t side, float* planes) {
  MakeNoise(item, side, 3, planes);
  planes[0] = 8.5f * planes[0] - 0.5f;
  planes[1] = 2.0f * planes[1] + 1.75f;
  planes[2] = 8.5f * planes[2] - 0.5f;
}

// 8 x 4 x 8 cells; bricks of 5^3 probes that cover one, or eight, of them.
struct BrickVolume {
  gaunt_bricks bricks = {
      sizeof(gaunt_bricks), {8, 4, 8}, {-8.0f, 0.0f, -8.0f}, {2.0f, 1.0f, 2.0f}, 5, {0, 0, 0}, 0};
  std::vector<gaunt_brick_cell> cells = std::vector<gaunt_brick_cell>(8 * 4 * 8);

  BrickVolume() {
    uint32_t count = 0;
    for (uint32_t z = 0; z < 8; ++z) {
      for (uint32_t y = 0; y < 4; ++y) {
        for (uint32_t x = 0; x < 8; ++x) {
          const bool large = (x / 2 + y / 2 + z / 2) % 2 == 0;
          const gaunt_brick_cell own = {125 * count, 1};
          if (large && (x % 2 != 0 || y % 2 != 0 || z % 2 != 0)) {
            At(x, y, z) = At(x / 2 * 2, y / 2 * 2, z / 2 * 2);
          } else {
            At(x, y, z) = {own.first, large ? 2u : 1u};
            ++count;
          }
        }
      }
    }
    bricks.probe_count = 125 * count;
  }
  gaunt_brick_cell& At(uint32_t x, uint32_t y, uint32_t z) { return cells[x + 8 * (y + 4 * z)]; }
};

// Outputs, as long as the largest batch.
struct TapMemory {
  std::vector<uint32_t> indices = std::vector<uint32_t>(8 * kLarge);
  std::vector<float> weights = std::vector<float>(8 * kLarge);
};

void Register(const std::string& name, const char* op, const char* variant,
              const std::function<gaunt_status(size_t count, const gaunt_view* positions)>& call,
              const std::function<void(size_t count, const float* positions)>& scalar) {
  BatchBenchmark batch;
  batch.name = name;
  batch.operations = OperationsOf(op, "1", variant);
  batch.inputs = {3};
  batch.more_written = 8 * (sizeof(uint32_t) + sizeof(float));
  batch.make = MakePosition;
  batch.large = true;
  batch.call = [=](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views&) {
    return call(count, in[0]);
  };
  RegisterBatch(batch);
  if (!scalar) return;
  ScalarBenchmark loop;
  loop.name = name;
  loop.baseline = "engine";
  loop.inputs = {3};
  loop.output = 1;
  loop.make = MakePosition;
  loop.call = [=](size_t count, const std::vector<const float*>& in, float*) {
    scalar(count, in[0]);
  };
  RegisterScalar(loop);
}

}  // namespace

GAUNT_BENCHMARKS(grid) {
  const auto out = std::make_shared<TapMemory>();
  // Nine of ten take part.
  const auto valid = std::make_shared<std::vector<uint32_t>>(kProbes / 32, 0xFF7FFBFDu);
  const auto volume = std::make_shared<BrickVolume>();
  for (const bool masked : {false, true}) {
    const uint32_t* const bits = masked ? valid->data() : nullptr;
    Register(
        masked ? "grid/taps_valid/n1" : "grid/taps/n1", "grid_taps", masked ? "valid" : "all",
        [=](size_t count, const gaunt_view* positions) {
          return gaunt_grid_taps(&kGrid, count, positions, (void(valid), bits), out->indices.data(),
                                 out->weights.data());
        },
        [=](size_t count, const float* positions) {
          GridEngine(kGrid, count, positions, (void(valid), bits), out->indices.data(),
                     out->weights.data());
        });
  }
  Register(
      "grid/bricks/n1", "brick_taps", "all",
      [=](size_t count, const gaunt_view* positions) {
        return gaunt_brick_taps(&volume->bricks, volume->cells.data(), count, positions, nullptr,
                                out->indices.data(), out->weights.data());
      },
      [=](size_t count, const float* positions) {
        BricksEngine(volume->bricks, volume->cells.data(), count, positions, out->indices.data(),
                     out->weights.data());
      });
}

}  // namespace gaunt::bench
