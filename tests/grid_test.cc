// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "grid/grid_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/guarded.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr size_t kTaps = 8;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr size_t kCounts[] = {0, 1, 3, 7, 8, 9, 15, 16, 17, 33, 70};

bool All(uint32_t) { return true; }

// A bit of each index, by chance.
struct Mask {
  Mask(Random& random, uint32_t probes, double share) : words((probes + 31) / 32, 0u) {
    for (uint32_t j = 0; j < probes; ++j) {
      if (random.Uniform() < share) words[j / 32] |= 1u << j % 32;
    }
    // Bits after the last are of no probe.
    if (probes % 32 != 0) words.back() |= random.Bits() << probes % 32;
  }
  bool operator()(uint32_t index) const { return (words[index / 32] >> index % 32 & 1) != 0; }

  std::vector<uint32_t> words;
};

// Outputs with canaries on both sides.
struct Taps {
  explicit Taps(size_t items)
      : count(items * kTaps),
        indices_(count + 2 * kMargin, kCanary),
        weights_(count + 2 * kMargin) {
    std::fill(weights_.begin(), weights_.end(), -7.0f);
  }
  uint32_t* indices() { return indices_.data() + kMargin; }
  float* weights() { return weights_.data() + kMargin; }
  void ExpectCanaries() const {
    for (size_t k = 0; k < kMargin; ++k) {
      ASSERT_EQ(indices_[k], kCanary);
      ASSERT_EQ(weights_[k], -7.0f);
      ASSERT_EQ(indices_[kMargin + count + k], kCanary);
      ASSERT_EQ(weights_[kMargin + count + k], -7.0f);
    }
  }
  bool Untouched() const {
    return std::count(indices_.begin(), indices_.end(), kCanary) ==
               static_cast<ptrdiff_t>(indices_.size()) &&
           std::count(weights_.begin(), weights_.end(), -7.0f) ==
               static_cast<ptrdiff_t>(weights_.size());
  }

  static constexpr size_t kMargin = 16;
  static constexpr uint32_t kCanary = 0xCA9A71E5u;
  size_t count;

 private:
  std::vector<uint32_t> indices_;
  std::vector<float> weights_;
};

// Weights of an item by index; checks what is true of every item.
grid::WeightsReference WeightsOf(const uint32_t* indices, const float* weights, uint64_t probes,
                                 double sum_tolerance) {
  grid::WeightsReference result;
  double sum = 0.0;
  for (size_t t = 0; t < kTaps; ++t) {
    EXPECT_GE(weights[t], 0.0f);  // and not NaN
    if (indices[t] == GAUNT_NO_PROBE) {
      EXPECT_EQ(weights[t], 0.0f);
      continue;
    }
    EXPECT_LT(indices[t], probes);
    sum += double{weights[t]};
    if (weights[t] > 0.0f) result[indices[t]] += double{weights[t]};
  }
  EXPECT_NEAR(sum, result.empty() ? 0.0 : 1.0, sum_tolerance);
  return result;
}

void ExpectWeights(const grid::WeightsReference& got, const grid::WeightsReference& wanted,
                   double tolerance) {
  ASSERT_EQ(got.empty(), wanted.empty());
  const auto compare = [&](const grid::WeightsReference& a, const grid::WeightsReference& b) {
    for (const auto& [index, weight] : a) {
      const auto other = b.find(index);
      ASSERT_NEAR(weight, other == b.end() ? 0.0 : other->second, tolerance) << "index " << index;
    }
  };
  compare(got, wanted);
  compare(wanted, got);
}

gaunt_grid MakeGrid(Random& random) {
  gaunt_grid grid = {};
  grid.struct_size = sizeof(grid);
  for (int a = 0; a < 3; ++a) {
    grid.size[a] = 1 + static_cast<uint32_t>(random.Bits() % 9);
    grid.origin[a] = random.Between(-50.0, 50.0);
    grid.spacing[a] = random.Between(0.1, 4.0) * (random.Bits() % 3 == 0 ? -1.0f : 1.0f);
  }
  grid.first = static_cast<uint32_t>(random.Bits() % 100);
  if (random.Bits() % 2 == 0) {  // z fastest, with gaps
    grid.strides[2] = 2;
    grid.strides[1] = 2 * grid.size[2] + 1;
    grid.strides[0] = grid.strides[1] * grid.size[1];
  }
  return grid;
}

uint64_t ProbesOf(const gaunt_grid& grid) {
  uint64_t strides[3] = {grid.strides[0], grid.strides[1], grid.strides[2]};
  if (strides[0] + strides[1] + strides[2] == 0) {
    strides[0] = 1, strides[1] = grid.size[0], strides[2] = grid.size[0] * grid.size[1];
  }
  uint64_t last = grid.first;
  for (int a = 0; a < 3; ++a) last += (grid.size[a] - 1) * strides[a];
  return last + 1;
}

// Inside, outside, and on the lattice.
void MakePosition(Random& random, const float* origin, const float* spacing, const uint32_t* size,
                  float* position) {
  for (int a = 0; a < 3; ++a) {
    const double u = random.Between(-1.0, size[a] + 1.0);
    position[a] =
        static_cast<float>(origin[a] + spacing[a] * (random.Bits() % 8 == 0 ? std::floor(u) : u));
  }
}

// Close to the lattice: by up to 1e-5 or 1e-3 of a cell, along some of the axes.
void MakePositionNearProbes(Random& random, const float* origin, const float* spacing,
                            const uint32_t* size, double probes_per_cell, float* position) {
  for (int a = 0; a < 3; ++a) {
    const double reach[4] = {1e-5, 1e-3, 1e-3, 1.0};
    const double probe = std::floor(random.Between(0.0, size[a] * probes_per_cell));
    const double u = probe + random.Between(-1.0, 1.0) * reach[random.Bits() % 4];
    position[a] = static_cast<float>(origin[a] + spacing[a] * u / probes_per_cell);
  }
}

// The bound of the manual.
double BoundOf(const grid::TapsReference& taps) {
  const double e = 2.5e-7 + 1.8e-7 * taps.coordinates;
  return taps.all_valid ? e : 2.0 * e / taps.sum;
}

// The largest error, as a share of the bound.
double ShareOfBound(const grid::WeightsReference& got, const grid::TapsReference& wanted) {
  if (got.empty() || wanted.weights.empty()) {
    return got.empty() == wanted.weights.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  }
  grid::WeightsReference errors = got;
  for (const auto& [index, weight] : wanted.weights) errors[index] -= weight;
  double largest = 0.0;
  for (const auto& [index, error] : errors) largest = std::max(largest, std::abs(error));
  return largest / BoundOf(wanted);
}

// Weights within the bound, of the cell or of one beside it whose border the position is on but for
// rounding. wanted: the reference of a nudge; rounding: the relative error of coordinates.
template <class Wanted>
void ExpectWithinBound(const grid::WeightsReference& got, const Wanted& wanted, double rounding) {
  const grid::TapsReference here = wanted(grid::Nudge{});
  double share = ShareOfBound(got, here);
  for (int k = 0; share > 1.0 && k < 27; ++k) {
    const grid::TapsReference beside =
        wanted({rounding * (k % 3 - 1.0), rounding * (k / 3 % 3 - 1.0), rounding * (k / 9 - 1.0)});
    if (beside.corner != here.corner) share = std::min(share, ShareOfBound(got, beside));
  }
  ASSERT_LE(share, 1.0);
}

void ExpectWithinBound(const grid::WeightsReference& got, const gaunt_grid& grid,
                       const float* position, const grid::IsValid& is_valid) {
  const auto wanted = [&](const grid::Nudge& nudge) {
    return grid::GridReference(grid, position, is_valid, nudge);
  };
  ExpectWithinBound(got, wanted, 1.8e-7);
}

void ExpectWithinBound(const grid::WeightsReference& got, const gaunt_bricks& bricks,
                       const gaunt_brick_cell* cells, const float* position,
                       const grid::IsValid& is_valid) {
  const auto wanted = [&](const grid::Nudge& nudge) {
    return grid::BricksReference(bricks, cells, position, is_valid, nudge);
  };
  ExpectWithinBound(got, wanted, 3.6e-7);  // of u, and again of v, which is less
}

class Grid : public TargetTest {};
class Bricks : public TargetTest {};

TEST_P(Grid, AgreeWithTheDefinitionInEveryLayout) {
  Random random(1);
  for (const size_t count : kCounts) {
    std::vector<Layout> layouts = Layouts();
    layouts.push_back(Layout::kBroadcast);
    for (const Layout layout : layouts) {
      SCOPED_TRACE(Name(layout) + " " + std::to_string(count));
      const gaunt_grid grid = MakeGrid(random);
      Buffer positions(layout, count, 3);
      for (size_t i = 0; i < count; ++i) {
        float p[3];
        MakePosition(random, grid.origin, grid.spacing, grid.size, p);
        for (size_t a = 0; a < 3; ++a) positions.Set(i, a, p[a]);
      }
      const std::vector<float> before = positions.memory();
      Taps taps(count);
      ASSERT_EQ(
          gaunt_grid_taps(&grid, count, positions.view(), nullptr, taps.indices(), taps.weights()),
          GAUNT_OK);
      taps.ExpectCanaries();
      ASSERT_EQ(std::memcmp(before.data(), positions.memory().data(), 4 * before.size()), 0);
      for (size_t i = 0; i < count; ++i) {
        const float p[3] = {positions.Get(i, 0), positions.Get(i, 1), positions.Get(i, 2)};
        const auto got =
            WeightsOf(taps.indices() + i * kTaps, taps.weights() + i * kTaps, ProbesOf(grid), 2e-7);
        ExpectWithinBound(got, grid, p, All);
      }
    }
  }
}

// Tap t is the corner whose bits t has, along x, y and z.
TEST_P(Grid, AreInTheOrderOfTheManual) {
  gaunt_grid grid = {sizeof(grid), {4, 5, 6}, {0, 0, 0}, {1, 1, 1}, 1000, {1, 10, 100}};
  const float p[3] = {1.25f, 2.5f, 3.125f};
  uint32_t indices[8];
  float weights[8];
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(p), 3, &view);
  ASSERT_EQ(gaunt_grid_taps(&grid, 1, &view, nullptr, indices, weights), GAUNT_OK);
  for (uint32_t t = 0; t < 8; ++t) {
    const uint32_t x = t & 1, y = t >> 1 & 1, z = t >> 2;
    EXPECT_EQ(indices[t], 1000 + (1 + x) + 10 * (2 + y) + 100 * (3 + z));
    EXPECT_EQ(weights[t], (x ? 0.25f : 0.75f) * 0.5f * (z ? 0.125f : 0.875f));
  }
}

TEST_P(Grid, ReproduceLinearFunctionsAndAreContinuous) {
  Random random(2);
  for (int round = 0; round < 50; ++round) {
    gaunt_grid grid = MakeGrid(random);
    for (uint32_t& n : grid.size) n += 1;
    grid.strides[0] = grid.strides[1] = grid.strides[2] = 0;
    grid.first = 0;
    const double slope[3] = {random.Between(-1, 1), random.Between(-1, 1), random.Between(-1, 1)};
    const auto value = [&](uint32_t index) {
      const uint32_t x = index % grid.size[0], y = index / grid.size[0] % grid.size[1],
                     z = index / grid.size[0] / grid.size[1];
      return slope[0] * x + slope[1] * y + slope[2] * z;
    };
    std::vector<double> values(ProbesOf(grid));  // in 0 .. 1, of which no blend is steeper than 1
    for (double& v : values) v = random.Uniform();
    double before = 0.0;
    // A line through the grid, in small steps.
    constexpr size_t kSteps = 333;
    std::vector<float> positions(3 * kSteps);
    for (size_t i = 0; i < kSteps; ++i) {
      for (int a = 0; a < 3; ++a) {
        const double share = static_cast<double>(i) / (kSteps - 1) * (a == round % 3 ? 1.0 : 0.7);
        positions[3 * i + static_cast<size_t>(a)] =
            static_cast<float>(grid.origin[a] + grid.spacing[a] * (grid.size[a] - 1.0) * share);
      }
    }
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    Taps taps(kSteps);
    ASSERT_EQ(gaunt_grid_taps(&grid, kSteps, &view, nullptr, taps.indices(), taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < kSteps; ++i) {
      double got = 0.0, wanted = 0.0, blend = 0.0, steps = 0.0;
      for (size_t t = 0; t < kTaps; ++t) {
        got += double{taps.weights()[8 * i + t]} * value(taps.indices()[8 * i + t]);
        blend += double{taps.weights()[8 * i + t]} * values[taps.indices()[8 * i + t]];
      }
      for (int a = 0; a < 3; ++a) {
        wanted += slope[a] * grid::CoordinateReference(positions[3 * i + static_cast<size_t>(a)],
                                                       grid.origin[a], grid.spacing[a],
                                                       grid.size[a] - 1.0);
      }
      ASSERT_NEAR(got, wanted, 4e-6);
      for (size_t a = 0; i > 0 && a < 3; ++a) {
        steps += std::abs(double{positions[3 * i + a]} - double{positions[3 * i + a - 3]}) /
                 std::abs(double{grid.spacing[a]});
      }
      ASSERT_TRUE(i == 0 || std::abs(blend - before) <= steps + 4e-6);
      before = blend;
    }
  }
}

// What they are for: a linear field of coefficients, gathered.
TEST_P(Grid, TapsAreWhatGatherTakes) {
  const gaunt_grid grid = {sizeof(grid), {4, 5, 6}, {1, 2, 3}, {0.5f, 0.5f, 2.0f}, 0, {}};
  constexpr size_t kProbes = 120, kItems = 37;
  std::vector<float> probes(27 * kProbes);
  const auto field = [](double x, double y, double z, size_t plane) {
    return 1.0 + x + 2.0 * y + 3.0 * z + 0.1 * static_cast<double>(plane);
  };
  for (size_t i = 0; i < kProbes; ++i) {
    const double x = 1.0 + 0.5 * static_cast<double>(i % 4);
    const double y = 2.0 + 0.5 * static_cast<double>(i / 4 % 5);
    const double z = 3.0 + 2.0 * static_cast<double>(i / 20);
    for (size_t p = 0; p < 27; ++p) probes[27 * i + p] = static_cast<float>(field(x, y, z, p));
  }
  Random random(10);
  Buffer positions(Layout::kPlanar, kItems, 3), out(Layout::kTiled, kItems, 27);
  for (size_t i = 0; i < kItems; ++i) {
    positions.Set(i, 0, random.Between(1.0, 2.5));
    positions.Set(i, 1, random.Between(2.0, 4.0));
    positions.Set(i, 2, random.Between(3.0, 13.0));
  }
  Taps taps(kItems);
  ASSERT_EQ(
      gaunt_grid_taps(&grid, kItems, positions.view(), nullptr, taps.indices(), taps.weights()),
      GAUNT_OK);
  ASSERT_EQ(gaunt_probe_gather(GAUNT_FORMAT_SH3_F32, 3, kItems, 8, taps.indices(), taps.weights(),
                               probes.data(), kProbes, 27 * sizeof(float), out.view()),
            GAUNT_OK);
  for (size_t i = 0; i < kItems; ++i) {
    for (size_t p = 0; p < 27; ++p) {
      ASSERT_NEAR(out.Get(i, p),
                  field(positions.Get(i, 0), positions.Get(i, 1), positions.Get(i, 2), p), 1e-4);
    }
  }
}

// Where the three coordinates are the same, so are their errors, and they add up.
TEST_P(Grid, HoldTheBoundOnDiagonals) {
  Random random(11);
  for (int round = 0; round < 100; ++round) {
    gaunt_grid grid = {sizeof(grid), {65, 65, 65}, {}, {}, 0, {}};
    std::fill_n(grid.origin, 3, random.Between(-1.0, 1.0));
    std::fill_n(grid.spacing, 3, random.Between(0.1, 4.0));
    constexpr size_t kItems = 200;
    std::vector<float> positions;
    for (size_t i = 0; i < kItems; ++i) {
      const double u = std::floor(random.Between(1.0, 65.0)) + random.Between(-1e-3, 1e-3);
      positions.insert(positions.end(), 3,
                       static_cast<float>(grid.origin[0] + double{grid.spacing[0]} * u));
    }
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    Taps taps(kItems);
    ASSERT_EQ(gaunt_grid_taps(&grid, kItems, &view, nullptr, taps.indices(), taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < kItems; ++i) {
      const auto got =
          WeightsOf(taps.indices() + i * kTaps, taps.weights() + i * kTaps, ProbesOf(grid), 2e-7);
      ExpectWithinBound(got, grid, &positions[3 * i], All);
    }
  }
}

// Both probes along an axis of size 1 are the same, whatever its stride is, and whether they are valid.
TEST_P(Grid, OfSizeOneRepeatTheirProbes) {
  Random random(12);
  for (uint32_t flat = 1; flat < 8; ++flat) {
    gaunt_grid grid = {sizeof(grid), {3, 4, 5}, {0.1f, 0.2f, 0.3f}, {0.7f, 1.3f, 0.9f}, 5, {}};
    for (uint32_t a = 0; a < 3; ++a) {
      if ((flat >> a & 1) != 0) grid.size[a] = 1;
    }
    for (const bool is_default : {true, false}) {
      if (!is_default) grid.strides[0] = 2, grid.strides[1] = 7, grid.strides[2] = 30;
      const uint32_t probes = static_cast<uint32_t>(ProbesOf(grid));
      const Mask mask(random, probes, 0.7);
      constexpr size_t kItems = 64;
      std::vector<float> positions(3 * kItems);
      random.Fill(positions.data(), positions.size(), -1.0, 6.0);
      gaunt_view view;
      gaunt_view_interleaved(positions.data(), 3, &view);
      for (const bool masked : {false, true}) {
        Taps taps(kItems);
        ASSERT_EQ(gaunt_grid_taps(&grid, kItems, &view, masked ? mask.words.data() : nullptr,
                                  taps.indices(), taps.weights()),
                  GAUNT_OK);
        for (size_t i = 0; i < kItems; ++i) {
          const uint32_t* const indices = taps.indices() + i * kTaps;
          for (uint32_t t = 0; t < kTaps; ++t) ASSERT_EQ(indices[t], indices[t & ~flat]);
          const auto got = WeightsOf(indices, taps.weights() + i * kTaps, probes, 5e-7);
          ExpectWithinBound(got, grid, &positions[3 * i],
                            masked ? grid::IsValid(mask) : grid::IsValid(All));
        }
      }
    }
  }
}

// Of grids that floats do not hold, near probes that are not valid, where there is little to share.
TEST_P(Grid, ShareWithinTheBound) {
  Random random(13);
  size_t sharp = 0, close = 0;
  for (int round = 0; round < 100; ++round) {
    gaunt_grid grid = MakeGrid(random);
    if (round == 0) {
      grid = {sizeof(grid), {5, 5, 5}, {-2.3f, 7.1f, 0.3f}, {0.7f, 1.3f, 0.9f}, 0, {}};
    }
    const uint32_t probes = static_cast<uint32_t>(ProbesOf(grid));
    Mask mask(random, probes, round % 2 == 0 ? 0.5 : 0.9);
    constexpr size_t kItems = 200;
    std::vector<float> positions(3 * kItems);
    for (size_t i = 0; i < kItems; ++i) {
      MakePositionNearProbes(random, grid.origin, grid.spacing, grid.size, 1.0, &positions[3 * i]);
    }
    if (round == 0) {  // only probe (2, 0, 2), a float beside it
      std::fill(mask.words.begin(), mask.words.end(), UINT32_MAX);
      mask.words[52 / 32] ^= 1u << 52 % 32;
      positions[0] = -0.899999f, positions[1] = 7.1f, positions[2] = 2.1f;
    }
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    Taps taps(kItems);
    ASSERT_EQ(
        gaunt_grid_taps(&grid, kItems, &view, mask.words.data(), taps.indices(), taps.weights()),
        GAUNT_OK);
    for (size_t i = 0; i < kItems; ++i) {
      const float* const p = &positions[3 * i];
      const uint32_t* const indices = taps.indices() + i * kTaps;
      const auto got = WeightsOf(indices, taps.weights() + i * kTaps, probes, 5e-7);
      for (const auto& [index, weight] : got) ASSERT_TRUE(mask(index));
      ExpectWithinBound(got, grid, p, mask);
      const grid::TapsReference wanted = grid::GridReference(grid, p, mask);
      if (got.empty() || wanted.all_valid || wanted.sum > 0.01) continue;
      ++close;
      if (BoundOf(wanted) < 0.01) ++sharp;
    }
  }
  // The bound says something of many that have little to share.
  EXPECT_GT(close, 1000u);
  EXPECT_GT(sharp, 500u);
}

// Fractions that floats hold, so that those of the kernel and of the definition are the same.
TEST_P(Grid, LeaveOutProbesThatAreNotValid) {
  Random random(3);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    for (const size_t count : kCounts) {
      gaunt_grid grid = MakeGrid(random);
      for (int a = 0; a < 3; ++a) grid.origin[a] = -2.0f, grid.spacing[a] = 0.25f;
      const uint32_t probes = static_cast<uint32_t>(ProbesOf(grid));
      const Mask mask(random, probes, share);
      Buffer positions(Layout::kTiled, count, 3);
      for (size_t i = 0; i < count; ++i) {
        for (size_t a = 0; a < 3; ++a) {
          const double step = random.Bits() % 4 == 0 ? 1.0 : 0x1p-12;  // on the lattice too
          const double u = std::floor(random.Between(-1.0, grid.size[a]) / step) * step;
          positions.Set(i, a, static_cast<float>(-2.0 + 0.25 * u));
        }
      }
      Taps taps(count);
      ASSERT_EQ(gaunt_grid_taps(&grid, count, positions.view(), mask.words.data(), taps.indices(),
                                taps.weights()),
                GAUNT_OK);
      taps.ExpectCanaries();
      for (size_t i = 0; i < count; ++i) {
        const float p[3] = {positions.Get(i, 0), positions.Get(i, 1), positions.Get(i, 2)};
        const uint32_t* const indices = taps.indices() + i * kTaps;
        const auto got = WeightsOf(indices, taps.weights() + i * kTaps, probes, 4e-7);
        for (size_t t = 0; t < kTaps; ++t) {
          ASSERT_TRUE(indices[t] == GAUNT_NO_PROBE || mask(indices[t]));
        }
        ExpectWeights(got, grid::GridReference(grid, p, mask).weights, 4e-7);
      }
    }
  }
}

TEST_P(Grid, OfAllValidProbesAreThoseWithoutAMask) {
  Random random(4);
  for (int round = 0; round < 10; ++round) {
    const gaunt_grid grid = MakeGrid(random);
    const Mask mask(random, static_cast<uint32_t>(ProbesOf(grid)), 1.0);
    constexpr size_t kItems = 1000;
    Buffer positions(Layout::kTiled, kItems, 3);
    for (size_t i = 0; i < kItems; ++i) {
      float p[3];
      MakePosition(random, grid.origin, grid.spacing, grid.size, p);
      for (size_t a = 0; a < 3; ++a) positions.Set(i, a, p[a]);
    }
    Taps with(kItems), without(kItems);
    ASSERT_EQ(gaunt_grid_taps(&grid, kItems, positions.view(), mask.words.data(), with.indices(),
                              with.weights()),
              GAUNT_OK);
    ASSERT_EQ(gaunt_grid_taps(&grid, kItems, positions.view(), nullptr, without.indices(),
                              without.weights()),
              GAUNT_OK);
    ASSERT_EQ(std::memcmp(with.indices(), without.indices(), 4 * with.count), 0);
    ASSERT_EQ(std::memcmp(with.weights(), without.weights(), 4 * with.count), 0);
  }
}

TEST_P(Grid, OfPositionsThatAreNoneOrFarAway) {
  const gaunt_grid grid = {sizeof(grid), {3, 4, 5}, {1e4f, -1e4f, 0}, {0.5f, -2.0f, 1e-30f}, 7, {}};
  const float largest = std::numeric_limits<float>::max();
  const uint32_t words[3] = {0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu};
  const std::vector<float> values = {kNaN,     kInfinity, -kInfinity, largest,
                                     -largest, 0.0f,      1e-45f,     -1e-45f};
  std::vector<float> positions;
  for (const float x : values) {
    for (const float y : values) {
      for (const float z : values) positions.insert(positions.end(), {x, y, z});
    }
  }
  const size_t count = positions.size() / 3;
  gaunt_view view;
  gaunt_view_interleaved(positions.data(), 3, &view);
  for (const uint32_t* valid : {static_cast<const uint32_t*>(nullptr), words}) {
    Taps taps(count);
    ASSERT_EQ(gaunt_grid_taps(&grid, count, &view, valid, taps.indices(), taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < count; ++i) {
      const auto got = WeightsOf(taps.indices() + 8 * i, taps.weights() + 8 * i, 67, 4e-7);
      ExpectWeights(got, grid::GridReference(grid, &positions[3 * i], All).weights, 1e-5);
    }
  }
}

TEST_P(Grid, ReachTheLargestIndexAndReadNoBitBeyondIt) {
  gaunt_grid grid = {sizeof(grid), {2, 2, 65536}, {0, 0, 0}, {1, 1, 1}, 0, {0, 0, 65534}};
  grid.first = UINT32_MAX - 1 - 65535u * 65534u;
  float p[3] = {5, 5, 1e9f};
  gaunt_view view;
  gaunt_view_interleaved(p, 3, &view);
  uint32_t indices[8];
  float weights[8];
  ASSERT_EQ(gaunt_grid_taps(&grid, 1, &view, nullptr, indices, weights), GAUNT_OK);
  EXPECT_EQ(indices[7], UINT32_MAX - 1);
  EXPECT_EQ(weights[7], 1.0f);
  grid.first += 1;
  EXPECT_EQ(gaunt_grid_taps(&grid, 1, &view, nullptr, indices, weights), GAUNT_ERROR_RANGE);

  for (uint32_t n = 1; n < 70; ++n) {
    const gaunt_grid row = {sizeof(row), {n, 1, 1}, {0, 0, 0}, {1, 1, 1}, 3, {}};
    const size_t words = (n + 3 + 31) / 32;
    const GuardedBytes bits(4 * words);
    std::memset(bits.data(), 0xFF, 4 * words);
    for (size_t count = 1; count < 20; ++count) {
      const GuardedFloats memory(3 * count), weight(8 * count), index(8 * count);
      for (size_t k = 0; k < 3 * count; ++k) memory.data()[k] = static_cast<float>(k * 7);
      gaunt_view_interleaved(memory.data(), 3, &view);
      ASSERT_EQ(gaunt_grid_taps(&row, count, &view, reinterpret_cast<uint32_t*>(bits.data()),
                                reinterpret_cast<uint32_t*>(index.data()), weight.data()),
                GAUNT_OK);
    }
  }
}

TEST_P(Grid, RejectWrongArguments) {
  const gaunt_grid good = {sizeof(good), {3, 4, 5}, {0, 0, 0}, {1, 1, 1}, 0, {}};
  Buffer positions(Layout::kInterleaved, 8, 3);
  const gaunt_view* const v = positions.view();
  Taps taps(8);
  const uint32_t valid[2] = {};
  const auto call = [&](const gaunt_grid& grid) {
    return gaunt_grid_taps(&grid, 8, v, valid, taps.indices(), taps.weights());
  };
  gaunt_grid bad = good;
  bad.struct_size = 3;
  EXPECT_EQ(call(bad), GAUNT_ERROR_STRUCT);
  for (int a = 0; a < 3; ++a) {
    for (const uint32_t size : {0u, 65537u, UINT32_MAX}) {
      bad = good;
      bad.size[a] = size;
      EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
    }
    for (const float origin : {kNaN, kInfinity, -kInfinity}) {
      bad = good;
      bad.origin[a] = origin;
      EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
    }
    for (const float spacing : {kNaN, kInfinity, 0.0f, 1e-31f, -1e-31f, 1e31f, -kInfinity}) {
      bad = good;
      bad.spacing[a] = spacing;
      EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
    }
    bad = good;
    bad.strides[a] = UINT32_MAX;
    EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
  }
  bad = good;
  bad.first = UINT32_MAX - 59;
  EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_grid_taps(nullptr, 8, v, valid, taps.indices(), taps.weights()),
            GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, nullptr, valid, taps.indices(), taps.weights()),
            GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, v, valid, nullptr, taps.weights()), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, v, valid, taps.indices(), nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_grid_taps(&good, SIZE_MAX / 4, v, valid, taps.indices(), taps.weights()),
            GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, v, valid, taps.indices(), v->data), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, v, valid, taps.indices(),
                            reinterpret_cast<float*>(taps.indices()) + 60),
            GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_grid_taps(&good, 8, v, taps.indices() + 63, taps.indices(), taps.weights()),
            GAUNT_ERROR_OVERLAP);
  gaunt_view odd = *v;
  odd.item_stride = 13;
  EXPECT_EQ(gaunt_grid_taps(&good, 8, &odd, valid, taps.indices(), taps.weights()),
            GAUNT_ERROR_LAYOUT);
  EXPECT_TRUE(taps.Untouched());
  EXPECT_EQ(gaunt_grid_taps(&good, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_OK);
  EXPECT_EQ(call(good), GAUNT_OK);
}

// Bricks of several sizes, each cell of which names its own; some cells have none.
struct BrickScene {
  gaunt_bricks bricks;
  std::vector<gaunt_brick_cell> cells;
  std::vector<double> values;  // of probes: a linear function of the coordinate among cells
  double slope[3];

  // Blocks of `ratio`^2 cells along each axis, each of one brick, or of bricks `ratio` or 1 cells wide.
  BrickScene(Random& random, uint32_t ratio, uint32_t probes, double missing) {
    const uint32_t block = ratio * ratio;
    bricks = {};
    bricks.struct_size = sizeof(bricks);
    bricks.probes = probes;
    for (int a = 0; a < 3; ++a) {
      bricks.size[a] = block * (1 + static_cast<uint32_t>(random.Bits() % 2));
      bricks.origin[a] = random.Between(-20.0, 20.0);
      bricks.spacing[a] = random.Between(0.5, 2.0) * (random.Bits() % 3 == 0 ? -1.0f : 1.0f);
      slope[a] = random.Between(-1.0, 1.0);
    }
    const uint32_t* const size = bricks.size;
    cells.resize(size_t{size[0]} * size[1] * size[2], {GAUNT_NO_PROBE, 1});
    // An atlas that is one brick high and deep, or bricks back to back.
    const bool atlas = random.Bits() % 2 == 0;
    const uint32_t row = 4096;
    if (atlas) {
      bricks.strides[0] = 1, bricks.strides[1] = row, bricks.strides[2] = row * probes;
      values.resize(size_t{row} * probes * probes);
    }
    uint32_t next = 0;
    const auto add = [&](uint32_t x, uint32_t y, uint32_t z, uint32_t edge) {
      const bool exists = random.Uniform() >= missing;
      const uint32_t first = atlas ? probes * next : probes * probes * probes * next;
      if (exists) ++next;
      for (uint32_t k = 0; k < edge * edge * edge; ++k) {
        const uint32_t cx = x + k % edge, cy = y + k / edge % edge, cz = z + k / edge / edge;
        if (exists) cells[cx + size[0] * (cy + size_t{size[1]} * cz)] = {first, edge};
      }
      for (uint32_t k = 0; exists && k < probes * probes * probes; ++k) {
        const uint32_t p[3] = {k % probes, k / probes % probes, k / probes / probes};
        const size_t at =
            atlas ? first + p[0] + size_t{row} * (p[1] + size_t{probes} * p[2]) : first + k;
        if (at >= values.size()) values.resize(at + 1);
        const double corner[3] = {1.0 * x, 1.0 * y, 1.0 * z};
        values[at] = 0.0;
        for (int a = 0; a < 3; ++a) {
          values[at] += slope[a] * (corner[a] + static_cast<double>(p[a]) * edge / (probes - 1.0));
        }
      }
    };
    for (uint32_t z = 0; z < size[2]; z += block) {
      for (uint32_t y = 0; y < size[1]; y += block) {
        for (uint32_t x = 0; x < size[0]; x += block) {
          const uint32_t edges[3] = {block, ratio, 1};
          const uint32_t edge = edges[random.Bits() % 3], n = block / edge;
          if (atlas && edge == 1) continue;  // too many for the row
          for (uint32_t k = 0; k < n * n * n; ++k) {
            add(x + edge * (k % n), y + edge * (k / n % n), z + edge * (k / n / n), edge);
          }
        }
      }
    }
    const uint32_t span =
        atlas ? (probes - 1) * (1 + row + row * probes) + 1 : probes * probes * probes;
    bricks.probe_count = std::max(static_cast<uint32_t>(values.size()), span);
  }

  double ValueAt(const float* position) const {
    double value = 0.0;
    for (int a = 0; a < 3; ++a) {
      value += slope[a] * grid::CoordinateReference(position[a], bricks.origin[a],
                                                    bricks.spacing[a], bricks.size[a]);
    }
    return value;
  }
};

TEST_P(Bricks, AgreeWithTheDefinitionAndReproduceLinearFunctions) {
  Random random(5);
  size_t found = 0, none = 0;
  for (const uint32_t ratio : {2u, 3u, 4u}) {
    for (const uint32_t probes : {2u, 4u, 5u}) {
      for (const size_t count :
           {size_t{1}, size_t{3}, size_t{15}, size_t{16}, size_t{17}, size_t{200}}) {
        const BrickScene scene(random, ratio, probes, 0.1);
        const gaunt_bricks& bricks = scene.bricks;
        Buffer positions(Layout::kRecord, count, 3);
        for (size_t i = 0; i < count; ++i) {
          float p[3];
          MakePosition(random, bricks.origin, bricks.spacing, bricks.size, p);
          for (size_t a = 0; a < 3; ++a) positions.Set(i, a, p[a]);
        }
        Taps taps(count);
        ASSERT_EQ(gaunt_brick_taps(&bricks, scene.cells.data(), count, positions.view(), nullptr,
                                   taps.indices(), taps.weights()),
                  GAUNT_OK);
        taps.ExpectCanaries();
        for (size_t i = 0; i < count; ++i) {
          const float p[3] = {positions.Get(i, 0), positions.Get(i, 1), positions.Get(i, 2)};
          const auto got = WeightsOf(taps.indices() + i * kTaps, taps.weights() + i * kTaps,
                                     bricks.probe_count, 2e-7);
          ExpectWithinBound(got, bricks, scene.cells.data(), p, All);
          double value = 0.0;
          for (const auto& [index, weight] : got) value += weight * scene.values[index];
          if (got.empty()) {
            ++none;
          } else {
            ++found;
            ASSERT_NEAR(value, scene.ValueAt(p), 2e-5);
          }
        }
      }
    }
  }
  EXPECT_GT(found, 1000u);
  EXPECT_GT(none, 100u);
}

TEST_P(Bricks, LeaveOutProbesThatAreNotValid) {
  Random random(6);
  for (int round = 0; round < 20; ++round) {
    BrickScene scene(random, 2, 5, 0.1);
    gaunt_bricks& bricks = scene.bricks;
    for (int a = 0; a < 3; ++a) bricks.origin[a] = 4.0f, bricks.spacing[a] = -0.5f;
    const Mask mask(random, bricks.probe_count, 0.5);
    constexpr size_t kItems = 100;
    Buffer positions(Layout::kPlanar, kItems, 3);
    for (size_t i = 0; i < kItems; ++i) {
      for (size_t a = 0; a < 3; ++a) {
        const double u = std::floor(random.Between(-1.0, bricks.size[a] + 1.0) * 4096) / 4096;
        positions.Set(i, a, static_cast<float>(4.0 - 0.5 * u));
      }
    }
    Taps taps(kItems);
    ASSERT_EQ(gaunt_brick_taps(&bricks, scene.cells.data(), kItems, positions.view(),
                               mask.words.data(), taps.indices(), taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < kItems; ++i) {
      const float p[3] = {positions.Get(i, 0), positions.Get(i, 1), positions.Get(i, 2)};
      const auto got = WeightsOf(taps.indices() + i * kTaps, taps.weights() + i * kTaps,
                                 bricks.probe_count, 4e-7);
      for (const auto& [index, weight] : got) ASSERT_TRUE(mask(index));
      ExpectWeights(got, grid::BricksReference(bricks, scene.cells.data(), p, mask).weights, 4e-7);
    }
  }
}

TEST_P(Bricks, ShareWithinTheBound) {
  Random random(14);
  size_t sharp = 0, close = 0;
  for (int round = 0; round < 60; ++round) {
    const uint32_t probes = round % 3 == 0 ? 2 : 4;
    const BrickScene scene(random, 3, probes, 0.1);
    const gaunt_bricks& bricks = scene.bricks;
    const Mask mask(random, bricks.probe_count, round % 2 == 0 ? 0.5 : 0.9);
    constexpr size_t kItems = 200;
    std::vector<float> positions(3 * kItems);
    for (size_t i = 0; i < kItems; ++i) {
      MakePositionNearProbes(random, bricks.origin, bricks.spacing, bricks.size,
                             i % 2 == 0 ? 1.0 : (probes - 1.0) / 3.0, &positions[3 * i]);
    }
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    Taps taps(kItems);
    ASSERT_EQ(gaunt_brick_taps(&bricks, scene.cells.data(), kItems, &view, mask.words.data(),
                               taps.indices(), taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < kItems; ++i) {
      const float* const p = &positions[3 * i];
      const auto got = WeightsOf(taps.indices() + i * kTaps, taps.weights() + i * kTaps,
                                 bricks.probe_count, 5e-7);
      for (const auto& [index, weight] : got) ASSERT_TRUE(mask(index));
      ExpectWithinBound(got, bricks, scene.cells.data(), p, mask);
      const grid::TapsReference wanted = grid::BricksReference(bricks, scene.cells.data(), p, mask);
      if (got.empty() || wanted.all_valid || wanted.sum > 0.01) continue;
      ++close;
      if (BoundOf(wanted) < 0.01) ++sharp;
    }
  }
  EXPECT_GT(close, 500u);
  EXPECT_GT(sharp, 200u);
}

// Of any size: bricks begin where they do, and weights at their ends are not below 0.
TEST_P(Bricks, OfEverySizeBeginAndEndWhereTheyDo) {
  for (uint32_t s = 1; s <= 400; ++s) {
    const gaunt_bricks bricks = {sizeof(bricks), {2 * s, 1, 1}, {0, 0, 0}, {1, 1, 1}, 4, {}, 128};
    std::vector<gaunt_brick_cell> cells(2 * s, {0, s});
    std::fill(cells.begin() + s, cells.end(), gaunt_brick_cell{64, s});
    const float edge = static_cast<float>(s);
    const float positions[9] = {edge - 0.5f, 0, 0, edge, 0, 0, 2.0f * edge, 0, 0};
    gaunt_view view;
    gaunt_view_interleaved(const_cast<float*>(positions), 3, &view);
    Taps taps(3);
    ASSERT_EQ(
        gaunt_brick_taps(&bricks, cells.data(), 3, &view, nullptr, taps.indices(), taps.weights()),
        GAUNT_OK);
    const double wanted[3] = {3.0 - 1.5 / s, 64.0, 67.0};  // the mean index
    for (size_t i = 0; i < 3; ++i) {
      const auto got = WeightsOf(taps.indices() + 8 * i, taps.weights() + 8 * i, 128, 2e-7);
      double mean = 0.0;
      for (const auto& [index, weight] : got) mean += weight * index;
      ASSERT_NEAR(mean, wanted[i], 3e-5) << "size " << s;
    }
  }
}

// Cells that say anything: no index is beyond the probes, and no bit.
TEST_P(Bricks, TrustNoCell) {
  Random random(7);
  gaunt_bricks bricks = {sizeof(bricks), {5, 6, 7}, {0, 0, 0}, {1, 1, 1}, 4, {}, 1000};
  const uint32_t firsts[] = {0, 500, 936, 937, 999, 1000, 0x7FFFFFFF, 0x80000000, GAUNT_NO_PROBE};
  const uint32_t sizes[] = {0, 1, 2, 3, 65536, 65537, 0x7FFFFFFF, 0x80000001, UINT32_MAX};
  std::vector<gaunt_brick_cell> cells(210);
  const GuardedBytes bits(4 * 32);
  std::memset(bits.data(), 0xFF, 4 * 32);
  for (int round = 0; round < 20; ++round) {
    for (gaunt_brick_cell& cell : cells) {
      cell = {firsts[random.Bits() % std::size(firsts)], sizes[random.Bits() % std::size(sizes)]};
    }
    const GuardedBytes guarded(cells.size() * sizeof(cells[0]));
    std::memcpy(guarded.data(), cells.data(), cells.size() * sizeof(cells[0]));
    constexpr size_t kItems = 210;
    std::vector<float> positions(3 * kItems);
    for (size_t i = 0; i < kItems; ++i) {
      MakePosition(random, bricks.origin, bricks.spacing, bricks.size, &positions[3 * i]);
      for (size_t a = 0; a < 3; ++a) positions[3 * i + a] += 0.125f;
      if (i % 11 == 0) positions[3 * i + i % 3] = i % 2 == 0 ? kNaN : kInfinity;
    }
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    for (const bool masked : {false, true}) {
      Taps taps(kItems);
      ASSERT_EQ(gaunt_brick_taps(&bricks, reinterpret_cast<const gaunt_brick_cell*>(guarded.data()),
                                 kItems, &view,
                                 masked ? reinterpret_cast<const uint32_t*>(bits.data()) : nullptr,
                                 taps.indices(), taps.weights()),
                GAUNT_OK);
      for (size_t i = 0; i < kItems; ++i) {
        const auto got = WeightsOf(taps.indices() + 8 * i, taps.weights() + 8 * i, 1000, 4e-7);
        const auto wanted = grid::BricksReference(bricks, cells.data(), &positions[3 * i], All);
        ExpectWeights(got, wanted.weights, 1e-5);
      }
    }
  }
}

TEST_P(Bricks, RejectWrongArguments) {
  const gaunt_bricks good = {sizeof(good), {2, 2, 2}, {0, 0, 0}, {1, 1, 1}, 4, {}, 64};
  const std::vector<gaunt_brick_cell> cells(8, {0, 1});
  Buffer positions(Layout::kInterleaved, 8, 3);
  const gaunt_view* const v = positions.view();
  Taps taps(8);
  const uint32_t valid[2] = {};
  const auto call = [&](const gaunt_bricks& bricks) {
    return gaunt_brick_taps(&bricks, cells.data(), 8, v, valid, taps.indices(), taps.weights());
  };
  gaunt_bricks bad = good;
  bad.struct_size = 0;
  EXPECT_EQ(call(bad), GAUNT_ERROR_STRUCT);
  const auto range = [&](const auto& change) {
    bad = good;
    change(bad);
    EXPECT_EQ(call(bad), GAUNT_ERROR_RANGE);
  };
  for (int a = 0; a < 3; ++a) {
    range([=](gaunt_bricks& b) { b.size[a] = 0; });
    range([=](gaunt_bricks& b) { b.size[a] = 65537; });
    range([=](gaunt_bricks& b) { b.origin[a] = kNaN; });
    range([=](gaunt_bricks& b) { b.spacing[a] = 0.0f; });
    range([=](gaunt_bricks& b) { b.strides[a] = UINT32_MAX; });
  }
  range([](gaunt_bricks& b) { b.size[0] = b.size[1] = 65536; });
  range([](gaunt_bricks& b) { b.probes = 1; });
  range([](gaunt_bricks& b) { b.probes = 257; });
  range([](gaunt_bricks& b) { b.probe_count = 63; });
  const auto status = [&](const gaunt_bricks* b, const gaunt_brick_cell* c, size_t count,
                          const gaunt_view* p, uint32_t* indices, float* weights) {
    return gaunt_brick_taps(b, c, count, p, valid, indices, weights);
  };
  uint32_t* const indices = taps.indices();
  float* const weights = taps.weights();
  EXPECT_EQ(status(nullptr, cells.data(), 8, v, indices, weights), GAUNT_ERROR_NULL);
  EXPECT_EQ(status(&good, nullptr, 8, v, indices, weights), GAUNT_ERROR_NULL);
  EXPECT_EQ(status(&good, cells.data(), 8, nullptr, indices, weights), GAUNT_ERROR_NULL);
  EXPECT_EQ(status(&good, cells.data(), 8, v, nullptr, weights), GAUNT_ERROR_NULL);
  EXPECT_EQ(status(&good, cells.data(), 8, v, indices, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(status(&good, cells.data(), SIZE_MAX / 4, v, indices, weights), GAUNT_ERROR_RANGE);
  EXPECT_EQ(status(&good, reinterpret_cast<gaunt_brick_cell*>(weights), 8, v, indices, weights),
            GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(status(&good, cells.data(), 8, v, indices, v->data), GAUNT_ERROR_OVERLAP);
  EXPECT_TRUE(taps.Untouched());
  EXPECT_EQ(gaunt_brick_taps(&good, nullptr, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_OK);
  EXPECT_EQ(call(good), GAUNT_OK);
}

// What the manual says of Unreal's atlas and of Unity's pool, by the engines' own formulas: where in
// the texture a position is sampled, in texels, of which 1/2 is the centre of the first.
TEST_P(Bricks, SampleWhereTheEnginesDo) {
  Random random(8);
  const uint32_t width = 20, height = 15, depth = 10;  // texels of the texture
  const auto check = [&](uint32_t ratio, uint32_t probes) {
    gaunt_bricks bricks = {
        sizeof(bricks),        {9, 9, 9}, {0, 0, 0}, {1, 1, 1}, probes, {1, width, width * height},
        width * height * depth};
    const uint32_t edge = ratio;  // of one large brick in the corner; all others are 1
    std::vector<gaunt_brick_cell> cells(729);
    std::vector<uint32_t> corners(729 * 3);
    for (uint32_t i = 0; i < 729; ++i) {
      const bool large = i % 9 < edge && i / 9 % 9 < edge && i / 81 < edge;
      const uint32_t brick[3] = {large ? 0 : i % 3, large ? 1 : i % 2, large ? 1u : 0u};
      for (uint32_t a = 0; a < 3; ++a) corners[3 * i + a] = brick[a] * probes;
      cells[i] = {probes * brick[0] + width * (probes * brick[1] + height * probes * brick[2]),
                  large ? edge : 1};
    }
    constexpr size_t kItems = 500;
    std::vector<float> positions(3 * kItems);
    random.Fill(positions.data(), positions.size(), 0.0, 9.0);
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    Taps taps(kItems);
    ASSERT_EQ(gaunt_brick_taps(&bricks, cells.data(), kItems, &view, nullptr, taps.indices(),
                               taps.weights()),
              GAUNT_OK);
    for (size_t i = 0; i < kItems; ++i) {
      const float* const p = &positions[3 * i];
      const size_t cell = static_cast<size_t>(p[0]) + 9 * static_cast<size_t>(p[1]) +
                          81 * static_cast<size_t>(p[2]);
      double texel[3] = {};
      for (size_t t = 0; t < kTaps; ++t) {
        const uint32_t index = taps.indices()[8 * i + t];
        const double weight = double{taps.weights()[8 * i + t]};
        texel[0] += weight * (index % width + 0.5);
        texel[1] += weight * (index / width % height + 0.5);
        texel[2] += weight * (index / width / height + 0.5);
      }
      for (size_t a = 0; a < 3; ++a) {
        const double inside = double{p[a]} / cells[cell].size;
        const double wanted =
            corners[3 * cell + a] + (inside - std::floor(inside)) * (probes - 1.0) + 0.5;
        ASSERT_NEAR(texel[a], wanted, 1e-5);
      }
    }
  };
  check(4, 5);  // Unreal
  check(3, 4);  // Unity
}

// The same bits everywhere: nothing here is fused.
TEST(GridBits, AreEqualOnAllTargets) {
  std::vector<uint32_t> first_indices;
  std::vector<float> first_weights;
  for (const std::string& target : SupportedTargets()) {
    ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    Random random(9);
    const BrickScene scene(random, 3, 4, 0.2);
    const Mask mask(random, scene.bricks.probe_count, 0.8);
    const gaunt_grid grid = MakeGrid(random);
    const Mask grid_mask(random, static_cast<uint32_t>(ProbesOf(grid)), 0.8);
    constexpr size_t kItems = 1000;
    std::vector<float> positions(3 * kItems);
    random.Fill(positions.data(), positions.size(), -30.0, 30.0);
    gaunt_view view;
    gaunt_view_interleaved(positions.data(), 3, &view);
    std::vector<uint32_t> indices(4 * 8 * kItems);
    std::vector<float> weights(4 * 8 * kItems);
    for (size_t k = 0; k < 4; ++k) {
      const bool masked = k % 2 != 0;
      uint32_t* const index = &indices[k * 8 * kItems];
      float* const weight = &weights[k * 8 * kItems];
      if (k < 2) {
        gaunt_grid_taps(&grid, kItems, &view, masked ? grid_mask.words.data() : nullptr, index,
                        weight);
      } else {
        gaunt_brick_taps(&scene.bricks, scene.cells.data(), kItems, &view,
                         masked ? mask.words.data() : nullptr, index, weight);
      }
    }
    if (first_indices.empty()) first_indices = indices, first_weights = weights;
    EXPECT_EQ(indices, first_indices) << target;
    EXPECT_EQ(std::memcmp(weights.data(), first_weights.data(), 4 * weights.size()), 0) << target;
  }
  gaunt_target_select(nullptr);
}

TEST(GridCpp, ThrowsAndFinds) {
  gaunt_grid grid = {sizeof(grid), {3, 4, 5}, {0, 0, 0}, {1, 1, 1}, 0, {}};
  const float p[3] = {1, 2, 3};
  uint32_t indices[8];
  float weights[8];
  GridTaps(grid, 1, Interleaved(p, 3), nullptr, indices, weights);
  EXPECT_EQ(indices[0], 1u + 3 * 2 + 12 * 3);
  EXPECT_EQ(weights[0], 1.0f);
  const gaunt_bricks bricks = {sizeof(bricks), {1, 1, 1}, {0, 0, 0}, {4, 4, 4}, 5, {}, 125};
  const gaunt_brick_cell cell = {0, 1};
  BrickTaps(bricks, &cell, 1, Interleaved(p, 3), nullptr, indices, weights);
  EXPECT_EQ(indices[0], 1u + 5 * 2 + 25 * 3);
  EXPECT_EQ(weights[0], 1.0f);
  grid.struct_size = 0;
  EXPECT_THROW(GridTaps(grid, 1, Interleaved(p, 3), nullptr, indices, weights), Error);
}

GAUNT_INSTANTIATE_TARGETS(Grid);
GAUNT_INSTANTIATE_TARGETS(Bricks);

}  // namespace
}  // namespace gaunt::test
