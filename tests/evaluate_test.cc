// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evaluate/constants.h"
#include "evaluate/evaluate_reference.h"
#include "gaunt/gaunt.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

double Norm(const double* values, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += values[i] * values[i];
  return std::sqrt(sum);
}

double LargestNorm(const std::vector<double>& coefficients, size_t channels) {
  const size_t n = coefficients.size() / channels;
  double largest = 0.0;
  for (size_t c = 0; c < channels; ++c) {
    largest = std::max(largest, Norm(coefficients.data() + c * n, n));
  }
  return largest;
}

Operation EvaluateOperation(uint32_t n, uint32_t channels, bool irradiance) {
  Operation operation;
  operation.name = std::string(irradiance ? "irradiance_evaluate" : "sh_evaluate") + "/n" +
                   std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {channels * n * n, 3};
  operation.outputs = {channels};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return (irradiance ? gaunt_irradiance_evaluate : gaunt_sh_evaluate)(n, channels, count, in[0],
                                                                        in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* planes) {
    if (side == 1) return random.Direction(planes);
    random.Fill(planes, channels * n * n, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (uint32_t c = 0; c < channels; ++c) {
      const double* f = in[0].data() + c * n * n;
      out[0][c] = (irradiance ? evaluate::IrradianceReference : evaluate::ShReference)(
          static_cast<int>(n), f, in[1].data());
    }
  };
  operation.tolerance = [=](const Operation::Item& in, size_t) {
    return (irradiance ? 1e-6 : 2e-6) * LargestNorm(in[0], channels);
  };
  return operation;
}

Operation ConstantsOperation() {
  Operation operation;
  operation.name = "irradiance_constants";
  operation.inputs = {27};
  operation.outputs = {28};
  operation.call = [](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_irradiance_constants(3, count, in[0], out[0]);
  };
  operation.make = [](Random& random, size_t, float* planes) {
    random.Fill(planes, 27, -1.0, 1.0);
  };
  operation.reference = [](const Operation::Item& in, Operation::Item& out) {
    evaluate::IrradianceConstantsReference(in[0].data(), out[0].data());
  };
  operation.tolerance = [](const Operation::Item& in, size_t) {
    double largest = 0.0;
    for (const double f : in[0]) largest = std::max(largest, std::abs(f));
    return 1e-7 * largest;
  };
  return operation;
}

Operation BlendOperation(uint32_t n, uint32_t channels) {
  const size_t planes = channels * n * n;
  Operation operation;
  operation.name = "sh_blend/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {planes, planes, 1};
  operation.outputs = {planes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_sh_blend(n, channels, count, in[0], in[1], in[2], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    if (side == 2) {
      out[0] = random.Between(0.0, 1.0);
    } else {
      random.Fill(out, planes, -1.0, 1.0);
    }
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t p = 0; p < planes; ++p) {
      out[0][p] = (1.0 - in[2][0]) * in[0][p] + in[2][0] * in[1][p];
    }
  };
  operation.tolerance = [](const Operation::Item&, size_t) { return 1.2e-7 * 2.0; };
  operation.in_place = {0, 1};
  return operation;
}

class Evaluate : public TargetTest {};

TEST_P(Evaluate, MatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) {
    for (const uint32_t channels : {1u, 3u}) {
      TestBatches(EvaluateOperation(n, channels, false));
      TestBatches(EvaluateOperation(n, channels, true));
    }
  }
  TestBatches(EvaluateOperation(3, 4, false));
}

TEST_P(Evaluate, ConstantsMatchTheDefinitionInEveryLayout) { TestBatches(ConstantsOperation()); }

TEST_P(Evaluate, BlendMatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : {1u, 3u, 6u}) {
    for (const uint32_t channels : {1u, 3u}) TestBatches(BlendOperation(n, channels));
  }
  TestBatches(BlendOperation(2, 4));
  TestBatches(BlendOperation(11, 1));
}

TEST_P(Evaluate, RejectsWrongArguments) {
  TestErrors(EvaluateOperation(3, 3, false));
  TestErrors(EvaluateOperation(6, 1, true));
  TestErrors(ConstantsOperation());
  TestErrors(BlendOperation(3, 3));
  EXPECT_EQ(gaunt_sh_evaluate(0, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_sh_evaluate(7, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_irradiance_evaluate(3, 0, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_irradiance_evaluate(3, 5, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_irradiance_constants(2, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_sh_blend(65, 1, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_sh_blend(3, 5, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
}

TEST_P(Evaluate, BlendIsExactAtItsEnds) {
  Random random(3);
  std::vector<float> a(27), b(27), out(27);
  random.Fill(a.data(), 27, -1e3, 1e3);
  random.Fill(b.data(), 27, -1e-3, 1e-3);
  gaunt_view va, vb, vt, vo;
  gaunt_view_interleaved(a.data(), 27, &va);
  gaunt_view_interleaved(b.data(), 27, &vb);
  gaunt_view_interleaved(out.data(), 27, &vo);
  for (float t : {0.0f, 1.0f}) {
    gaunt_view_broadcast(&t, &vt);
    ASSERT_EQ(gaunt_sh_blend(3, 3, 1, &va, &vb, &vt, &vo), GAUNT_OK);
    EXPECT_EQ(out, t == 0.0f ? a : b);
  }
}

// The 7 float4 and the band factors say the same, by way of the shader's polynomial.
TEST_P(Evaluate, ConstantsEvaluateToTheIrradiance) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    float radiance[27], k[28], n[3], e[3];
    random.Fill(radiance, 27, -1.0, 1.0);
    random.Direction(n);
    gaunt_view vr, vk, vn, ve;
    gaunt_view_interleaved(radiance, 27, &vr);
    gaunt_view_interleaved(k, 28, &vk);
    gaunt_view_interleaved(n, 3, &vn);
    gaunt_view_interleaved(e, 3, &ve);
    ASSERT_EQ(gaunt_irradiance_constants(3, 1, &vr, &vk), GAUNT_OK);
    ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, 1, &vr, &vn, &ve), GAUNT_OK);
    const float x = n[0], y = n[1], z = n[2];
    for (int c = 0; c < 3; ++c) {
      const float *A = k + 4 * c, *B = k + 12 + 4 * c;
      const float shader = A[0] * x + A[1] * y + A[2] * z + A[3] + B[0] * x * y + B[1] * y * z +
                           B[2] * z * z + B[3] * z * x + k[24 + c] * (x * x - y * y);
      ASSERT_NEAR(shader, e[c], 1e-6);
    }
    EXPECT_EQ(k[27], 1.0f);
  }
}

TEST(EvaluateConstants, MatchGoldenValues) {
  const double wanted[5] = {evaluate::kC0, evaluate::kC1, evaluate::kC2, evaluate::kC3,
                            evaluate::kC4};
  int found = 0;
  for (const auto& row : ReadGolden("irradiance_constants.csv")) {
    if (row[0].size() == 3 && row[0].compare(0, 2, "fC") == 0) {
      EXPECT_NEAR(wanted[row[0][2] - '0'], std::stod(row[1]), 1e-16);
      ++found;
    }
  }
  EXPECT_EQ(found, 5);
  for (const auto& row : ReadGolden("zh_clamped_cosine.csv")) {
    const int l = std::stoi(row[0]);
    EXPECT_NEAR(evaluate::CosineBand(l), std::stod(row[2]), 1e-15);
    EXPECT_NEAR(evaluate::CosineFactor(l), std::stod(row[2]), 1e-14);
  }
}

TEST(EvaluateBits, AreTheSameOnTargetsOfAClass) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) {
    TestSameBits(EvaluateOperation(n, 3, false));
    TestSameBits(EvaluateOperation(n, 3, true));
  }
  TestSameBits(ConstantsOperation());
  TestSameBits(BlendOperation(3, 3));
}

GAUNT_INSTANTIATE_TARGETS(Evaluate);

}  // namespace
}  // namespace gaunt::test
