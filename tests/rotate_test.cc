// SPDX-License-Identifier: MIT
// Batches, arguments and bits of rotation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gaunt/gaunt.h"
#include "rotate/rotate_reference.h"
#include "tests/rotate_tolerance.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

enum class By { kQuaternion, kMatrix };

auto RotateFunction(By by) { return by == By::kQuaternion ? &gaunt_rotate : &gaunt_rotate_matrix; }
size_t RotationPlanes(By by) { return by == By::kQuaternion ? 4 : 9; }

std::string Name(By by, uint32_t n, uint32_t channels) {
  return std::string(by == By::kQuaternion ? "rotate" : "rotate_matrix") + "/n" +
         std::to_string(n) + "/channels" + std::to_string(channels);
}

// Lengths far from 1, tilts near the poles, right angles, mirrors, and no rotation at all.
void MakeRotation(Random& random, By by, float* out) {
  float q[4];
  random.Fill(q, 4, -1.0, 1.0);
  const float scale = std::ldexp(1.0f, static_cast<int>(random.Bits() % 41) - 20);
  const double kind = random.Uniform();
  if (kind < 0.1) q[0] *= 1e-4f, q[1] *= 1e-4f;
  if (kind > 0.1 && kind < 0.2) q[2] *= 1e-7f, q[3] *= 1e-7f;
  if (kind > 0.2 && kind < 0.3) q[0] = q[1] = 0.0f;
  if (kind > 0.3 && kind < 0.4) q[2] = q[3] = 0.0f;
  if (kind > 0.4 && kind < 0.5) std::for_each(q, q + 4, [](float& x) { x = std::round(x); });
  if (kind > 0.9) std::fill(q, q + 4, 0.0f);
  if (by == By::kQuaternion) {
    for (int k = 0; k < 4; ++k) out[k] = q[k] * scale;
    return;
  }
  const double exact[4] = {q[0], q[1], q[2], q[3]};
  double matrix[9];
  rotate::MatrixReference(exact, matrix);
  const double mirror = random.Uniform() < 0.3 ? -1.0 : 1.0;
  for (int k = 0; k < 9; ++k) out[k] = static_cast<float>(mirror * matrix[k]);
}

// Some at the corners of [-1, 1], where errors are largest.
void MakeCoefficients(Random& random, size_t planes, float* out) {
  random.Fill(out, planes, -1.0, 1.0);
  if (random.Uniform() > 0.3) return;
  for (size_t p = 0; p < planes; ++p) out[p] = out[p] < 0.0f ? -1.0f : 1.0f;
}

void Reference(By by, uint32_t n, uint32_t channels, const double* rotation, const double* in,
               double* out) {
  double matrix[9];
  if (by == By::kQuaternion) {
    rotate::MatrixReference(rotation, matrix);
  } else {
    std::copy(rotation, rotation + 9, matrix);
  }
  rotate::RotateReference(static_cast<int>(n), channels, matrix, in, out);
}

Operation RotateOperation(uint32_t n, uint32_t channels, By by) {
  const size_t planes = channels * n * n;
  Operation operation;
  operation.name = Name(by, n, channels);
  operation.inputs = {RotationPlanes(by), planes};
  operation.outputs = {planes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return RotateFunction(by)(n, channels, count, in[0], in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    if (side == 1) return MakeCoefficients(random, planes, out);
    MakeRotation(random, by, out);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    Reference(by, n, channels, in[0].data(), in[1].data(), out[0].data());
  };
  operation.tolerance = [n](const Operation::Item&, const Operation::Item&, size_t, size_t) {
    return RotateTolerance(n);
  };
  operation.in_place = {1};
  operation.broadcast_rounds_alike = false;
  return operation;
}

// The same rotation for many items.
Operation RotateOneOperation(uint32_t n, uint32_t channels, By by) {
  Operation operation = RotateOperation(n, channels, by);
  operation.name += "/one";
  operation.inputs = {operation.inputs[1]};
  Random random(n + 100 * channels);
  std::vector<float> rotation(RotationPlanes(by));
  MakeRotation(random, by, rotation.data());
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    std::vector<float> data = rotation;
    gaunt_view one;
    gaunt_view_broadcast(data.data(), &one);
    return RotateFunction(by)(n, channels, count, &one, in[0], out[0]);
  };
  operation.make = [planes = operation.inputs[0]](Random& values, size_t, float* out) {
    MakeCoefficients(values, planes, out);
  };
  // The matrix of the rotation, column by column.
  const size_t coefficients = n * n;
  const std::vector<double> exact(rotation.begin(), rotation.end());
  std::vector<double> columns(coefficients * coefficients), unit(coefficients);
  for (size_t i = 0; i < coefficients; ++i) {
    unit[i] = 1.0;
    Reference(by, n, 1, exact.data(), unit.data(), columns.data() + i * coefficients);
    unit[i] = 0.0;
  }
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    std::fill(out[0].begin(), out[0].end(), 0.0);
    for (size_t p = 0; p < in[0].size(); ++p) {
      double* const channel = out[0].data() + p / coefficients * coefficients;
      const double* const column = columns.data() + p % coefficients * coefficients;
      for (size_t i = 0; i < coefficients; ++i) channel[i] += in[0][p] * column[i];
    }
  };
  // A matrix of floats is not quite orthonormal, and the reference takes it as it is.
  const double tolerance = by == By::kQuaternion ? RotateOneTolerance(n) : RotateTolerance(n);
  operation.tolerance = [tolerance](const Operation::Item&, const Operation::Item&, size_t,
                                    size_t) { return tolerance; };
  operation.in_place = {0};
  operation.extra_items = LeastPlannedItems(n);
  return operation;
}

class Rotate : public TargetTest {};

// Orders above 6 share one kernel, channel by channel.
std::vector<uint32_t> ChannelsOf(uint32_t n) {
  return n <= 6 ? std::vector<uint32_t>{1, 3, 4} : std::vector<uint32_t>{n % 3 == 0 ? 2u : 1u};
}

TEST_P(Rotate, QuaternionsMatchTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    for (const uint32_t channels : ChannelsOf(n)) {
      TestBatches(RotateOperation(n, channels, By::kQuaternion));
    }
  }
}

TEST_P(Rotate, MatricesMatchTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    for (const uint32_t channels : ChannelsOf(n)) {
      TestBatches(RotateOperation(n, channels, By::kMatrix));
    }
  }
}

TEST_P(Rotate, OneForAllMatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    for (const uint32_t channels : ChannelsOf(n)) {
      TestBatches(RotateOneOperation(n, channels, n % 2 == 0 ? By::kQuaternion : By::kMatrix));
    }
  }
}

TEST_P(Rotate, RejectsWrongArguments) {
  for (const uint32_t n : {1u, 2u, 3u, 4u, 6u, 7u, 16u}) {
    TestErrors(RotateOperation(n, 3, By::kQuaternion));
    TestErrors(RotateOperation(n, 3, By::kMatrix));
  }
  for (const By by : {By::kQuaternion, By::kMatrix}) {
    const auto rotate = RotateFunction(by);
    EXPECT_EQ(rotate(0, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(rotate(17, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(rotate(3, 0, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(rotate(3, 5, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  }
  // A rotation that has as many planes as the output is still no place for it.
  float matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, in[9] = {};
  gaunt_view vm, vi;
  gaunt_view_interleaved(matrix, 9, &vm);
  gaunt_view_interleaved(in, 9, &vi);
  EXPECT_EQ(gaunt_rotate_matrix(3, 1, 1, &vm, &vi, &vm), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(matrix[0], 1.0f);
}

TEST(RotateBits, AreTheSameOnTargetsOfAClass) {
  for (const uint32_t n : {2u, 3u, 4u, 5u, 6u, 7u, 16u}) {
    TestSameBits(RotateOperation(n, 3, By::kQuaternion));
    TestSameBits(RotateOperation(n, 3, By::kMatrix));
    TestSameBits(RotateOneOperation(n, 3, By::kQuaternion));
    TestSameBits(RotateOneOperation(n, 3, By::kMatrix));
  }
}

class RotationCheck : public TargetTest {};

// Of 9 planes of floats, the definition in double.
double DeviationReference(const float* m) {
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double dot = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k) dot += double{m[3 * k + i]} * double{m[3 * k + j]};
      worst = std::max(worst, std::abs(dot));
    }
  }
  return worst;
}

TEST_P(RotationCheck, FindsTheWorstMatrix) {
  Random random(31);
  for (const size_t count : {1u, 3u, 7u, 8u, 9u, 16u, 17u, 127u, 128u, 129u, 400u}) {
    for (const size_t bad : {size_t{0}, count / 2, count - 1}) {
      for (const float size : {1e-6f, 1e-3f, 0.3f, 1e3f}) {
        std::vector<float> matrices(9 * count);
        double wanted = 0.0;
        for (size_t i = 0; i < count; ++i) {
          MakeRotation(random, By::kMatrix, matrices.data() + 9 * i);
          if (i == bad) matrices[9 * i + random.Bits() % 9] += size;
          wanted = std::max(wanted, DeviationReference(matrices.data() + 9 * i));
        }
        gaunt_view view;
        gaunt_view_interleaved(matrices.data(), 9, &view);
        float worst = -1.0f;
        ASSERT_EQ(gaunt_rotation_check(count, &view, &worst), GAUNT_OK);
        ASSERT_NEAR(worst, wanted, 4e-7 * (1.0 + wanted));
        for (const float no_number : {std::numeric_limits<float>::quiet_NaN(),
                                      std::numeric_limits<float>::infinity(), 2e38f}) {
          std::vector<float> spoilt = matrices;
          spoilt[9 * bad + random.Bits() % 9] = no_number;
          gaunt_view_interleaved(spoilt.data(), 9, &view);
          ASSERT_EQ(gaunt_rotation_check(count, &view, &worst), GAUNT_OK);
          ASSERT_EQ(worst, std::numeric_limits<float>::infinity());
        }
      }
    }
  }
}

TEST_P(RotationCheck, RejectsWrongArguments) {
  float matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, worst = 7.0f;
  gaunt_view view;
  gaunt_view_interleaved(matrix, 9, &view);
  EXPECT_EQ(gaunt_rotation_check(1, &view, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_rotation_check(1, nullptr, &worst), GAUNT_ERROR_NULL);
  gaunt_view bad = view;
  bad.data = nullptr;
  EXPECT_EQ(gaunt_rotation_check(1, &bad, &worst), GAUNT_ERROR_NULL);
  bad = view;
  bad.plane_stride = 6;
  EXPECT_EQ(gaunt_rotation_check(1, &bad, &worst), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_rotation_check(SIZE_MAX, &view, &worst), GAUNT_ERROR_RANGE);
  EXPECT_EQ(worst, 7.0f);
  EXPECT_EQ(gaunt_rotation_check(0, nullptr, &worst), GAUNT_OK);
  EXPECT_EQ(worst, 0.0f);
}

GAUNT_INSTANTIATE_TARGETS(Rotate);
GAUNT_INSTANTIATE_TARGETS(RotationCheck);

}  // namespace
}  // namespace gaunt::test
