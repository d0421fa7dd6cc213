// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gaunt/gaunt.h"
#include "rotate/rotate_reference.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

// As gaunt.h states it, for coefficients in [-1, 1].
constexpr double RotateTolerance(uint32_t n) { return n <= 6 ? 3e-6 : 6e-6; }

enum class By { kQuaternion, kMatrix };

Operation RotateOperation(uint32_t n, uint32_t channels, By by) {
  const size_t planes = channels * n * n;
  Operation operation;
  operation.name = std::string(by == By::kQuaternion ? "rotate" : "rotate_matrix") + "/n" +
                   std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {by == By::kQuaternion ? size_t{4} : size_t{9}, planes};
  operation.outputs = {planes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return (by == By::kQuaternion ? gaunt_rotate : gaunt_rotate_matrix)(n, channels, count, in[0],
                                                                        in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    if (side == 1) return random.Fill(out, planes, -1.0, 1.0);
    float q[4];
    random.Fill(q, 4, -1.0, 1.0);
    // Lengths far from 1, near-pole tilts, and no rotation at all are all in the batch.
    const float scale = std::ldexp(1.0f, static_cast<int>(random.Bits() % 41) - 20);
    if (random.Uniform() < 0.2) q[0] *= 1e-4f, q[1] *= 1e-4f;
    if (random.Uniform() < 0.1) q[0] = q[1] = q[2] = q[3] = 0.0f;
    if (by == By::kQuaternion) {
      for (int k = 0; k < 4; ++k) out[k] = q[k] * scale;
      return;
    }
    const double exact[4] = {q[0], q[1], q[2], q[3]};
    double matrix[9];
    rotate::MatrixReference(exact, matrix);
    const double mirror = random.Uniform() < 0.3 ? -1.0 : 1.0;
    for (int k = 0; k < 9; ++k) out[k] = static_cast<float>(mirror * matrix[k]);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    double matrix[9];
    if (by == By::kQuaternion) {
      rotate::MatrixReference(in[0].data(), matrix);
    } else {
      std::copy(in[0].begin(), in[0].end(), matrix);
    }
    for (uint32_t c = 0; c < channels; ++c) {
      rotate::RotateReference(static_cast<int>(n), matrix, in[1].data() + c * n * n,
                              out[0].data() + c * n * n);
    }
  };
  operation.tolerance = [n](const Operation::Item&, const Operation::Item&, size_t, size_t) {
    return RotateTolerance(n);
  };
  operation.in_place = {1};
  operation.broadcast_rounds_alike = false;
  return operation;
}

class Rotate : public TargetTest {};

TEST_P(Rotate, MatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 10u, 11u, 16u}) {
    for (const uint32_t channels : {1u, 3u, 4u}) {
      if (n > 6 && channels == 4) continue;
      TestBatches(RotateOperation(n, channels, By::kQuaternion));
      TestBatches(RotateOperation(n, channels, By::kMatrix));
    }
  }
}

TEST_P(Rotate, RejectsWrongArguments) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    TestErrors(RotateOperation(n, 3, By::kQuaternion));
    TestErrors(RotateOperation(n, 3, By::kMatrix));
  }
  EXPECT_EQ(gaunt_rotate(0, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_rotate(17, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_rotate_matrix(3, 0, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_rotate_matrix(3, 5, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  // A rotation that has as many planes as the output is still no place for it.
  float matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, in[9] = {};
  gaunt_view vm, vi;
  gaunt_view_interleaved(matrix, 9, &vm);
  gaunt_view_interleaved(in, 9, &vi);
  EXPECT_EQ(gaunt_rotate_matrix(3, 1, 1, &vm, &vi, &vm), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(matrix[0], 1.0f);
}

TEST_P(Rotate, MatchesGoldenMatrices) {
  std::map<std::string, std::vector<double>> cases;
  for (const auto& row : ReadGolden("rotation_cases.csv")) {
    for (size_t k = 1; k <= 9; ++k) cases[row[0]].push_back(std::stod(row[k]));
  }
  for (const auto& row : ReadGolden("rotation_order3.csv")) {
    const int l = std::stoi(row[1]), m_out = std::stoi(row[2]), m_in = std::stoi(row[3]);
    float matrix[9], in[9] = {}, out[9];
    for (size_t k = 0; k < 9; ++k) matrix[k] = static_cast<float>(cases.at(row[0])[k]);
    in[l * (l + 1) + m_in] = 1.0f;
    gaunt_view vm, vi, vo;
    gaunt_view_broadcast(matrix, &vm);
    gaunt_view_interleaved(in, 9, &vi);
    gaunt_view_interleaved(out, 9, &vo);
    ASSERT_EQ(gaunt_rotate_matrix(3, 1, 1, &vm, &vi, &vo), GAUNT_OK);
    ASSERT_NEAR(out[l * (l + 1) + m_out], std::stod(row[4]), 4e-7) << row[0] << " band " << l;
  }
}

TEST_P(Rotate, KeepsEnergyAndUndoesItself) {
  Random random(11);
  for (int trial = 0; trial < 500; ++trial) {
    float q[4], inverse[4], f[9], there[9], back[9];
    random.Fill(q, 4, -1.0, 1.0);
    random.Fill(f, 9, -1.0, 1.0);
    for (int k = 0; k < 4; ++k) inverse[k] = k < 3 ? -q[k] : q[k];
    gaunt_view vq, vi, vf, vt, vb;
    gaunt_view_interleaved(q, 4, &vq);
    gaunt_view_interleaved(inverse, 4, &vi);
    gaunt_view_interleaved(f, 9, &vf);
    gaunt_view_interleaved(there, 9, &vt);
    gaunt_view_interleaved(back, 9, &vb);
    ASSERT_EQ(gaunt_rotate(3, 1, 1, &vq, &vf, &vt), GAUNT_OK);
    ASSERT_EQ(gaunt_rotate(3, 1, 1, &vi, &vt, &vb), GAUNT_OK);
    double before = 0.0, after = 0.0;
    for (int i = 0; i < 9; ++i) {
      ASSERT_NEAR(back[i], f[i], 2 * RotateTolerance(3));
      before += double{f[i]} * double{f[i]};
      after += double{there[i]} * double{there[i]};
    }
    ASSERT_NEAR(before, after, 1e-5);
  }
}

TEST_P(Rotate, MovesALobeForwards) {
  // A quarter turn about z takes +x to +y.
  float q[4] = {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)};
  float x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, lobe[9], wanted[9], moved[9];
  gaunt_view vq, vx, vy, vl, vw, vm;
  gaunt_view_interleaved(q, 4, &vq);
  gaunt_view_interleaved(x, 3, &vx);
  gaunt_view_interleaved(y, 3, &vy);
  gaunt_view_interleaved(lobe, 9, &vl);
  gaunt_view_interleaved(wanted, 9, &vw);
  gaunt_view_interleaved(moved, 9, &vm);
  ASSERT_EQ(gaunt_basis_eval(3, 1, &vx, &vl), GAUNT_OK);
  ASSERT_EQ(gaunt_basis_eval(3, 1, &vy, &vw), GAUNT_OK);
  ASSERT_EQ(gaunt_rotate(3, 1, 1, &vq, &vl, &vm), GAUNT_OK);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(moved[i], wanted[i], 5e-7);
}

TEST(RotateBits, AreTheSameOnTargetsOfAClass) {
  TestSameBits(RotateOperation(3, 3, By::kQuaternion));
  TestSameBits(RotateOperation(3, 3, By::kMatrix));
}

GAUNT_INSTANTIATE_TARGETS(Rotate);

}  // namespace
}  // namespace gaunt::test
