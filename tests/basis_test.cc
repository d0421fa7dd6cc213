// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "tests/support/designs.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

// As gaunt.h states it: 1.2e-6 at order 6, 4e-7 at order 3.
double BasisTolerance(int n) { return n <= 3 ? 4e-7 : 1.2e-6; }

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
  operation.tolerance = [n](const Operation::Item&, size_t) {
    return BasisTolerance(static_cast<int>(n));
  };
  return operation;
}

class Basis : public TargetTest {};

TEST_P(Basis, MatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) TestBatches(EvalOperation(n));
}

TEST_P(Basis, RejectsWrongArguments) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) TestErrors(EvalOperation(n));
  const float direction[3] = {0, 0, 1};
  float out[1] = {5.0f};
  gaunt_view in_view, out_view;
  gaunt_view_interleaved(const_cast<float*>(direction), 3, &in_view);
  gaunt_view_interleaved(out, 1, &out_view);
  EXPECT_EQ(gaunt_basis_eval(0, 1, &in_view, &out_view), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_basis_eval(GAUNT_MAX_ORDER + 1, 1, &in_view, &out_view), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_basis_eval(0, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(out[0], 5.0f);
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

void ExpectGolden(const std::string& file, bool normalise) {
  for (const auto& row : ReadGolden(file)) {
    double d[3];
    for (int k = 0; k < 3; ++k) d[k] = std::stod(row[static_cast<size_t>(k)]);
    const double length = normalise ? std::hypot(d[0], d[1], d[2]) : 1.0;
    float direction[3], y[36];
    for (int k = 0; k < 3; ++k) direction[k] = static_cast<float>(d[k] / length);
    gaunt_view in, out;
    gaunt_view_interleaved(direction, 3, &in);
    gaunt_view_interleaved(y, 36, &out);
    ASSERT_EQ(gaunt_basis_eval(6, 1, &in, &out), GAUNT_OK);
    double reference[36];
    basis::EvalReference(6, d, reference);
    for (size_t i = 0; i < 36; ++i) {
      const double golden = std::stod(row[3 + i]);
      EXPECT_NEAR(reference[i], golden, 1e-14);
      // Rounding the golden direction to float moves y by up to |grad y| 6e-8.
      EXPECT_NEAR(y[i], golden, 2.4e-6) << file << " coefficient " << i;
    }
  }
}

TEST_P(Basis, MatchesGoldenValues) {
  ExpectGolden("basis_order6.csv", false);
  ExpectGolden("basis_special_order16.csv", true);
}

TEST(BasisBits, AreTheSameOnTargetsOfAClass) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) TestSameBits(EvalOperation(n));
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
