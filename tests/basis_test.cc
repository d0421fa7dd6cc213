// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "simd/order.h"
#include "tests/support/buffer.h"
#include "tests/support/designs.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

// As gaunt.h states them, for band l of order n on the target in use.
double EvalTolerance(int n, int l) {
  if (n <= 3) return 4e-7;
  if (n <= 6) return HasFma(gaunt_target_name()) ? 1.2e-6 : 1.3e-6;
  return 2e-8 * std::pow(l + 1, 2.5);
}
double GradientTolerance(int l) { return 3e-8 * std::pow(l + 1, 3.5); }

Operation EvalOperation(uint32_t n) {
  Operation operation;
  operation.name = "basis_eval/n" + std::to_string(n);
  operation.inputs = {3};
  operation.outputs = {n * n};
  operation.call = [n](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_basis_eval(n, count, in[0], out[0]);
  };
  operation.make = [](Random& random, size_t, float* d) { random.Direction(d); };
  operation.reference = [n](const Operation::Item& in, Operation::Item& out) {
    basis::EvalReference(static_cast<int>(n), in[0].data(), out[0].data());
  };
  operation.tolerance = [n](const Operation::Item&, const Operation::Item&, size_t, size_t plane) {
    return EvalTolerance(static_cast<int>(n), BandOf(static_cast<int>(plane)));
  };
  return operation;
}

Operation GradientOperation(uint32_t n) {
  Operation operation = EvalOperation(n);
  operation.name = "basis_gradient/n" + std::to_string(n);
  operation.outputs = {n * n, n * n, n * n};
  operation.call = [n](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_basis_gradient(n, count, in[0], out[0], out[1], out[2]);
  };
  operation.reference = [n](const Operation::Item& in, Operation::Item& out) {
    std::vector<double> gradient(3 * n * n);
    basis::GradientReference(static_cast<int>(n), in[0].data(), gradient.data());
    for (size_t i = 0; i < gradient.size(); ++i) out[i / (n * n)][i % (n * n)] = gradient[i];
  };
  operation.tolerance = [](const Operation::Item&, const Operation::Item&, size_t, size_t plane) {
    return GradientTolerance(BandOf(static_cast<int>(plane)));
  };
  return operation;
}

Operation NormalizeOperation() {
  Operation operation;
  operation.name = "directions_normalize";
  operation.inputs = {3};
  operation.outputs = {3};
  operation.call = [](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_directions_normalize(count, in[0], out[0]);
  };
  operation.make = [](Random& random, size_t, float* d) {
    random.Direction(d);
    const float length = std::ldexp(1.0f, static_cast<int>(random.Between(-60.0, 60.0)));
    for (int k = 0; k < 3; ++k) d[k] *= length;
  };
  operation.reference = [](const Operation::Item& in, Operation::Item& out) {
    const double length = std::hypot(in[0][0], in[0][1], in[0][2]);
    for (size_t k = 0; k < 3; ++k) out[0][k] = in[0][k] / length;
  };
  operation.tolerance = [](const Operation::Item&, const Operation::Item&, size_t, size_t) {
    return 1.2e-7;
  };
  operation.in_place = {0};
  return operation;
}

// Every unrolled order, and orders of the loops over bands around the lanes and up to the end.
const std::vector<uint32_t> kOrders = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 23};
const std::vector<uint32_t> kGradientOrders = {1, 2, 3, 4, 6, 10, 17, 18};

// What a call says of one direction.
std::vector<float> EvalOne(uint32_t n, const float direction[3]) {
  float d[3] = {direction[0], direction[1], direction[2]};
  std::vector<float> y(n * n);
  gaunt_view in, out;
  gaunt_view_interleaved(d, 3, &in);
  gaunt_view_interleaved(y.data(), n * n, &out);
  EXPECT_EQ(gaunt_basis_eval(n, 1, &in, &out), GAUNT_OK);
  return y;
}

class Basis : public TargetTest {};

TEST_P(Basis, MatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kOrders) TestBatches(EvalOperation(n));
}

TEST_P(Basis, GradientMatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kGradientOrders) TestBatches(GradientOperation(n));
}

TEST_P(Basis, NormalizeMatchesTheDefinitionInEveryLayout) { TestBatches(NormalizeOperation()); }

TEST_P(Basis, RejectsWrongArguments) {
  for (const uint32_t n : kOrders) TestErrors(EvalOperation(n));
  for (const uint32_t n : kGradientOrders) TestErrors(GradientOperation(n));
  TestErrors(NormalizeOperation());
  const float direction[3] = {0, 0, 1};
  float out[1] = {5.0f};
  gaunt_view in_view, out_view;
  gaunt_view_interleaved(const_cast<float*>(direction), 3, &in_view);
  gaunt_view_interleaved(out, 1, &out_view);
  for (const uint32_t n : {0, GAUNT_MAX_ORDER + 1}) {
    EXPECT_EQ(gaunt_basis_eval(n, 1, &in_view, &out_view), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_basis_eval(n, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_basis_gradient(n, 1, &in_view, &out_view, &out_view, &out_view),
              GAUNT_ERROR_ORDER);
  }
  EXPECT_EQ(out[0], 5.0f);
}

// Random directions, axes, and directions at 1e-45 .. 0.1 from the poles and from the equator.
std::vector<std::array<float, 3>> HardDirections() {
  std::vector<std::array<float, 3>> directions;
  Random random(3);
  for (int i = 0; i < 200; ++i) random.Direction(directions.emplace_back().data());
  for (const float denormal : {1e-45f, -1e-40f}) {
    directions.push_back({denormal, -denormal, 1.0f});
    directions.push_back({1.0f, denormal, denormal});
  }
  for (const float sign : {-1.0f, 1.0f}) {
    directions.push_back({sign, 0.0f, 0.0f});
    directions.push_back({0.0f, sign, 0.0f});
    directions.push_back({0.0f, 0.0f, sign});
    for (double tilt = 1e-7; tilt < 0.5; tilt *= 10.0) {
      const float small = static_cast<float>(0.6 * tilt), other = static_cast<float>(0.8 * tilt);
      const float large = static_cast<float>(std::sqrt(1.0 - tilt * tilt));
      directions.push_back({small, other, sign * large});
      directions.push_back({sign * large, other, small});
      directions.push_back({small, sign * large, -other});
    }
  }
  return directions;
}

TEST_P(Basis, IsAccurateAtPolesAndAxesUpToOrder64) {
  for (const auto& direction : HardDirections()) {
    const double d[3] = {direction[0], direction[1], direction[2]};
    for (const uint32_t n : {6u, 10u, 33u, 64u}) {
      std::vector<double> wanted(n * n);
      basis::EvalReference(static_cast<int>(n), d, wanted.data());
      const std::vector<float> y = EvalOne(n, direction.data());
      for (size_t i = 0; i < y.size(); ++i) {
        const int l = BandOf(static_cast<int>(i));
        ASSERT_NEAR(y[i], wanted[i], EvalTolerance(static_cast<int>(n), l))
            << "order " << n << " coefficient " << i << " at " << d[0] << " " << d[1] << " "
            << d[2];
      }
    }
  }
}

TEST_P(Basis, GradientIsAccurateAtPolesAndAxes) {
  constexpr uint32_t n = 16;
  for (const auto& direction : HardDirections()) {
    float d[3] = {direction[0], direction[1], direction[2]};
    const double exact[3] = {d[0], d[1], d[2]};
    std::vector<float> gradient(3 * n * n);
    std::vector<double> wanted(3 * n * n);
    gaunt_view in, out[3];
    gaunt_view_interleaved(d, 3, &in);
    for (size_t axis = 0; axis < 3; ++axis) {
      gaunt_view_interleaved(gradient.data() + axis * n * n, n * n, &out[axis]);
    }
    ASSERT_EQ(gaunt_basis_gradient(n, 1, &in, &out[0], &out[1], &out[2]), GAUNT_OK);
    basis::GradientReference(n, exact, wanted.data());
    for (size_t i = 0; i < gradient.size(); ++i) {
      const int l = BandOf(static_cast<int>(i % (n * n)));
      ASSERT_NEAR(gradient[i], wanted[i], GradientTolerance(l))
          << "value " << i << " at " << d[0] << " " << d[1] << " " << d[2];
    }
  }
}

// A length of 1 + e may cost as much as the manual says, and no more.
TEST_P(Basis, NonUnitDirectionsCostWhatTheManualSays) {
  const struct {
    uint32_t order;
    double factor;
  } rows[] = {{3, 2.0}, {6, 14.1}, {16, 188.5}};
  Random random(11);
  for (const auto& row : rows) {
    for (const double e : {1e-6, 1e-4, 1e-3, -1e-3}) {
      double worst = 0.0;
      for (int trial = 0; trial < 100; ++trial) {
        float d[3] = {0.0f, 0.0f, 1.0f};  // the pole is the worst
        if (trial > 0) random.Direction(d);
        for (float& component : d) component *= static_cast<float>(1.0 + e);
        const double exact[3] = {d[0], d[1], d[2]};
        std::vector<double> wanted(row.order * row.order);
        basis::EvalReference(static_cast<int>(row.order), exact, wanted.data());
        const std::vector<float> y = EvalOne(row.order, d);
        for (size_t i = 0; i < y.size(); ++i) {
          worst = std::max(worst, std::abs(y[i] - wanted[i]));
        }
      }
      const double floor =
          EvalTolerance(static_cast<int>(row.order), static_cast<int>(row.order) - 1);
      // The factor is that of the first order in e.
      const double second_order = 1.0 + 60.0 * row.order * std::abs(e);
      EXPECT_LE(worst, second_order * row.factor * std::abs(e) + floor) << row.order << " " << e;
      if (std::abs(e) > 1e-5) {
        EXPECT_GE(worst, 0.7 * row.factor * std::abs(e)) << row.order << " " << e;
      }
    }
  }
}

// Near the poles, where errors are largest, and with lengths that only normalisation gives.
TEST_P(Basis, NormalizedDirectionsAreGoodEnough) {
  constexpr size_t kCount = 20000;
  Random random(21);
  Buffer in(Layout::kTiled, kCount, 3), d(Layout::kTiled, kCount, 3), y(Layout::kTiled, kCount, 36);
  for (size_t i = 0; i < kCount; ++i) {
    float v[3];
    random.Direction(v);
    const float tilt = i % 2 == 0 ? 1.0f : std::ldexp(1.0f, -static_cast<int>(i % 19));
    in.Set(i, 0, 7.3f * v[0] * tilt);
    in.Set(i, 1, 7.3f * v[1] * tilt);
    in.Set(i, 2, 7.3f * v[2]);
  }
  ASSERT_EQ(gaunt_directions_normalize(kCount, in.view(), d.view()), GAUNT_OK);
  ASSERT_EQ(gaunt_basis_eval(6, kCount, d.view(), y.view()), GAUNT_OK);
  for (size_t i = 0; i < kCount; ++i) {
    const double direction[3] = {d.Get(i, 0), d.Get(i, 1), d.Get(i, 2)};
    ASSERT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1.0, 9e-8);
    double wanted[36];
    basis::EvalReference(6, direction, wanted);
    for (size_t p = 0; p < 36; ++p) ASSERT_NEAR(y.Get(i, p), wanted[p], EvalTolerance(6, 5));
  }
}

// High orders in every layout: bands of up to 127 planes.
TEST_P(Basis, HighOrdersAreTheSameInEveryLayout) {
  constexpr size_t kCount = 21;
  for (const uint32_t n : {33u, 64u}) {
    for (const Layout layout : Layouts()) {
      SCOPED_TRACE(Name(layout) + " " + std::to_string(n));
      Buffer in(layout, kCount, 3), out(layout, kCount, n * n);
      Random random(n);
      for (size_t i = 0; i < kCount; ++i) {
        float d[3];
        random.Direction(d);
        for (size_t k = 0; k < 3; ++k) in.Set(i, k, d[k]);
      }
      ASSERT_EQ(gaunt_basis_eval(n, kCount, in.view(), out.view()), GAUNT_OK);
      ASSERT_TRUE(out.CanariesIntact());
      for (size_t i = 0; i < kCount; ++i) {
        const float d[3] = {in.Get(i, 0), in.Get(i, 1), in.Get(i, 2)};
        const std::vector<float> wanted = EvalOne(n, d);
        for (size_t p = 0; p < wanted.size(); ++p) ASSERT_EQ(out.Get(i, p), wanted[p]);
      }
    }
  }
}

TEST_P(Basis, NormalizeTakesAnyFloat) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  constexpr float kLeast = std::numeric_limits<float>::denorm_min();
  const float nan = std::nanf("");
  const struct {
    float in[3];
    double out[3];
  } rows[] = {{{0, 0, 0}, {0, 0, 1}},
              {{-0.0f, 0, -0.0f}, {0, 0, 1}},
              {{nan, 0, 1}, {0, 0, 1}},
              {{1, nan, 0}, {0, 0, 1}},
              {{0, 1, nan}, {0, 0, 1}},
              {{kInf, 0, 0}, {0, 0, 1}},
              {{0, -kInf, 5}, {0, 0, 1}},
              {{kInf, kInf, nan}, {0, 0, 1}},
              {{kLeast, 0, 0}, {1, 0, 0}},
              {{0, -kLeast, kLeast}, {0, -std::sqrt(0.5), std::sqrt(0.5)}},
              {{3e-40f, 0, 4e-40f}, {0.6, 0, 0.8}},
              {{kMax, -kMax, 0}, {std::sqrt(0.5), -std::sqrt(0.5), 0}},
              {{kMax, kMax, kMax}, {std::sqrt(1 / 3.), std::sqrt(1 / 3.), std::sqrt(1 / 3.)}},
              {{1e-30f, 1e30f, 1e-30f}, {0, 1, 0}},
              {{-2, 0, 0}, {-1, 0, 0}}};
  for (const auto& row : rows) {
    float in[3] = {row.in[0], row.in[1], row.in[2]}, out[3];
    gaunt_view in_view, out_view;
    gaunt_view_interleaved(in, 3, &in_view);
    gaunt_view_interleaved(out, 3, &out_view);
    ASSERT_EQ(gaunt_directions_normalize(1, &in_view, &out_view), GAUNT_OK);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(out[k], row.out[k], 1e-6) << in[0] << " " << in[1] << " " << in[2];
    }
  }
}

// The same in place, where outputs are inputs.
TEST_P(Basis, LargeOutputsInPlaceAreTheSame) {
  const size_t count = (size_t{33} << 20) / 12 + 21;
  for (const Layout layout : {Layout::kTiled, Layout::kInterleaved, Layout::kPlanar}) {
    SCOPED_TRACE(Name(layout));
    Buffer v(layout, count, 3, Start::kLine);
    for (size_t i = 0; i < count; ++i) {
      for (size_t k = 0; k < 3; ++k) v.Set(i, k, static_cast<float>((i * 7 + k * 5) % 11) - 4.5f);
    }
    ASSERT_EQ(gaunt_directions_normalize(count, v.view(), v.view()), GAUNT_OK);
    ASSERT_TRUE(v.CanariesIntact());
    for (size_t i = 0; i < count; i += i + 50 < count ? 9973 : 1) {
      float one[3];
      for (size_t k = 0; k < 3; ++k) one[k] = static_cast<float>((i * 7 + k * 5) % 11) - 4.5f;
      gaunt_view view;
      gaunt_view_interleaved(one, 3, &view);
      ASSERT_EQ(gaunt_directions_normalize(1, &view, &view), GAUNT_OK);
      for (size_t k = 0; k < 3; ++k) ASSERT_EQ(v.Get(i, k), one[k]) << i;
    }
  }
}

// Outputs that are streamed past the caches are the same, to the bit and to the edge.
TEST_P(Basis, LargeOutputsAreTheSame) {
  for (const uint32_t n : {6u, 16u}) {
    const size_t planes = n * n;
    const size_t count = (size_t{33} << 20) / (planes * sizeof(float)) + 21;
    for (const Layout layout : {Layout::kTiled, Layout::kInterleaved, Layout::kPlanar}) {
      SCOPED_TRACE(Name(layout) + " " + std::to_string(n));
      Buffer in(layout, count, 3), out(layout, count, planes, Start::kLine);
      Random random(5);
      for (size_t i = 0; i < count; ++i) {
        float d[3];
        random.Direction(d);
        for (size_t k = 0; k < 3; ++k) in.Set(i, k, d[k]);
      }
      ASSERT_EQ(gaunt_basis_eval(n, count, in.view(), out.view()), GAUNT_OK);
      ASSERT_TRUE(out.CanariesIntact());
      for (size_t i = 0; i < count; i += i + 50 < count ? 997 : 1) {
        const float d[3] = {in.Get(i, 0), in.Get(i, 1), in.Get(i, 2)};
        const std::vector<float> wanted = EvalOne(n, d);
        for (size_t p = 0; p < planes; ++p) ASSERT_EQ(out.Get(i, p), wanted[p]) << i << " " << p;
      }
    }
  }
}

// |d|^2 = 1 makes sum over m of y_lm^2 = (2l+1) / (4 pi): independent of the reference.
TEST_P(Basis, ObeysTheAdditionTheorem) {
  Random random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    float d[3], y[36];
    random.Direction(d);
    gaunt_view in, out;
    gaunt_view_interleaved(d, 3, &in);
    gaunt_view_interleaved(y, 36, &out);
    ASSERT_EQ(gaunt_basis_eval(6, 1, &in, &out), GAUNT_OK);
    for (int l = 0; l < 6; ++l) {
      double sum = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += double{y[i]} * double{y[i]};
      ASSERT_NEAR(sum, (2 * l + 1) / (4 * std::acos(-1.0)), 1e-6 * (2 * l + 1));
    }
  }
}

void ExpectGolden(const std::string& file, uint32_t n, bool normalise) {
  for (const auto& row : ReadGolden(file)) {
    double d[3];
    for (int k = 0; k < 3; ++k) d[k] = std::stod(row[static_cast<size_t>(k)]);
    const double length = normalise ? std::hypot(d[0], d[1], d[2]) : 1.0;
    float direction[3];
    for (int k = 0; k < 3; ++k) direction[k] = static_cast<float>(d[k] / length);
    const std::vector<float> y = EvalOne(n, direction);
    std::vector<double> reference(n * n);
    basis::EvalReference(static_cast<int>(n), d, reference.data());
    for (size_t i = 0; i < y.size(); ++i) {
      const double golden = std::stod(row[3 + i]);
      EXPECT_NEAR(reference[i], golden, 1e-13);
      // Rounding the golden direction to float moves y by up to |grad y| 6e-8.
      const int l = BandOf(static_cast<int>(i));
      EXPECT_NEAR(y[i], golden, 2.0 * EvalTolerance(static_cast<int>(n), l))
          << file << " coefficient " << i;
    }
  }
}

TEST_P(Basis, MatchesGoldenValues) {
  ExpectGolden("basis_order6.csv", 6, false);
  ExpectGolden("basis_order16.csv", 16, false);
  ExpectGolden("basis_special_order16.csv", 6, true);
  ExpectGolden("basis_special_order16.csv", 16, true);
}

TEST(BasisBits, AreTheSameOnTargetsOfAClass) {
  for (const uint32_t n : kOrders) TestSameBits(EvalOperation(n));
  for (const uint32_t n : kGradientOrders) TestSameBits(GradientOperation(n));
  TestSameBits(NormalizeOperation());
}

// sum over a design's points of (4 pi / N) y_a y_b = delta_ab: products of order 6 have degree 10.
TEST_P(Basis, IsOrthonormal) {
  const points::PointSet design = SphericalDesign(10);
  std::vector<double> sums(36 * 36, 0.0);
  for (const points::Point& p : design) {
    float d[3], y[36];
    for (size_t k = 0; k < 3; ++k) d[k] = static_cast<float>(p[k]);
    gaunt_view in, out;
    gaunt_view_interleaved(d, 3, &in);
    gaunt_view_interleaved(y, 36, &out);
    ASSERT_EQ(gaunt_basis_eval(6, 1, &in, &out), GAUNT_OK);
    const double weight = 4.0 * std::acos(-1.0) / static_cast<double>(design.size());
    for (size_t i = 0; i < 36 * 36; ++i) sums[i] += weight * double{y[i / 36]} * double{y[i % 36]};
  }
  for (size_t i = 0; i < 36 * 36; ++i) {
    EXPECT_NEAR(sums[i], i / 36 == i % 36 ? 1.0 : 0.0, 2e-6) << i / 36 << ", " << i % 36;
  }
}

GAUNT_INSTANTIATE_TARGETS(Basis);

}  // namespace
}  // namespace gaunt::test
