// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evaluate/constants.h"
#include "evaluate/evaluate_reference.h"
#include "gaunt/gaunt.h"
#include "tests/support/buffer.h"
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

double NormOfChannel(const std::vector<double>& coefficients, size_t channels, size_t c) {
  const size_t n = coefficients.size() / channels;
  return Norm(coefficients.data() + c * n, n);
}

double LargestOfChannel(const std::vector<double>& coefficients, size_t c) {
  double largest = 0.0;
  for (size_t i = 9 * c; i < 9 * c + 9; ++i) largest = std::max(largest, std::abs(coefficients[i]));
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
  operation.broadcast_rounds_alike = false;
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
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t, size_t c) {
    const double sh = n <= 6 ? 2e-6 : 1e-8 * std::pow(n, 3.0);
    return (irradiance ? 1e-6 : sh) * NormOfChannel(in[0], channels, c);
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
  operation.tolerance = [](const Operation::Item& in, const Operation::Item&, size_t, size_t p) {
    if (p == 27) return 0.0;
    return 1e-7 * LargestOfChannel(in[0], p < 24 ? p % 12 / 4 : p - 24);
  };
  return operation;
}

Operation MatrixOperation(uint32_t channels) {
  Operation operation = ConstantsOperation();
  operation.name = "irradiance_matrix/channels" + std::to_string(channels);
  operation.inputs = {9 * channels};
  operation.outputs = {16 * channels};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_irradiance_matrix(3, channels, count, in[0], out[0]);
  };
  operation.make = [=](Random& random, size_t, float* planes) {
    random.Fill(planes, 9 * channels, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (uint32_t c = 0; c < channels; ++c) {
      evaluate::IrradianceMatrixReference(in[0].data() + 9 * c, out[0].data() + 16 * c);
    }
  };
  operation.tolerance = [](const Operation::Item& in, const Operation::Item&, size_t, size_t p) {
    return 1e-7 * LargestOfChannel(in[0], p / 16);
  };
  return operation;
}

Operation DotOperation(uint32_t n, uint32_t channels) {
  const size_t planes = channels * n * n;
  Operation operation;
  operation.name = "sh_dot/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {planes, planes};
  operation.outputs = {channels};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_sh_dot(n, channels, count, in[0], in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t, float* out) { random.Fill(out, planes, -1.0, 1.0); };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t p = 0; p < planes; ++p) out[0][p / (n * n)] += in[0][p] * in[1][p];
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t channel) {
    double magnitude = 0.0;
    for (size_t p = channel * n * n; p < (channel + 1) * n * n; ++p) {
      magnitude += std::abs(in[0][p] * in[1][p]);
    }
    return 6e-8 * (2.0 + 0.25 * n * n) * magnitude;
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
  operation.tolerance = [](const Operation::Item& in, const Operation::Item&, size_t, size_t p) {
    return 1.2e-7 * (std::abs(in[0][p]) + std::abs(in[1][p]));
  };
  operation.in_place = {0, 1};
  return operation;
}

// Every unrolled order, and some of those that are not.
const std::vector<uint32_t> kOrders = {1, 2, 3, 4, 5, 6, 7, 8, 12};

class Evaluate : public TargetTest {};

TEST_P(Evaluate, MatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kOrders) {
    for (const uint32_t channels : {1u, 3u}) {
      TestBatches(EvaluateOperation(n, channels, false));
      TestBatches(EvaluateOperation(n, channels, true));
    }
  }
  TestBatches(EvaluateOperation(3, 4, false));
  TestBatches(EvaluateOperation(9, 4, true));
}

TEST_P(Evaluate, MatrixAndDotMatchTheDefinitionInEveryLayout) {
  for (const uint32_t channels : {1u, 3u, 4u}) TestBatches(MatrixOperation(channels));
  for (const uint32_t n : {1u, 3u, 6u, 9u, 12u}) TestBatches(DotOperation(n, 1));
  for (const uint32_t n : {2u, 3u}) TestBatches(DotOperation(n, 3));
}

// The highest order, few items: the reference is slow there.
TEST_P(Evaluate, ReachesOrder64) {
  constexpr uint32_t n = 64;
  constexpr size_t kCount = 18;
  Random random(17);
  for (const bool irradiance : {false, true}) {
    const Operation operation = EvaluateOperation(n, 1, irradiance);
    Buffer f(Layout::kInterleaved, kCount, n * n), d(Layout::kTiled, kCount, 3);
    Buffer out(Layout::kPlanar, kCount, 1);
    Operation::Item item(2), wanted(1);
    std::vector<Operation::Item> items;
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t side = 0; side < 2; ++side) {
        std::vector<float> planes(operation.inputs[side]);
        operation.make(random, side, planes.data());
        item[side].assign(planes.begin(), planes.end());
        for (size_t p = 0; p < planes.size(); ++p) (side == 0 ? f : d).Set(i, p, planes[p]);
      }
      items.push_back(item);
    }
    ASSERT_EQ(operation.call(kCount, {f.view(), d.view()}, {out.view()}), GAUNT_OK);
    for (size_t i = 0; i < kCount; ++i) {
      wanted[0].assign(1, 0.0);
      operation.reference(items[i], wanted);
      EXPECT_NEAR(out.Get(i, 0), wanted[0][0], operation.tolerance(items[i], wanted, 0, 0));
    }
  }
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
  TestErrors(EvaluateOperation(12, 3, true));
  TestErrors(ConstantsOperation());
  TestErrors(MatrixOperation(3));
  TestErrors(DotOperation(3, 3));
  TestErrors(BlendOperation(3, 3));
  EXPECT_EQ(gaunt_sh_evaluate(0, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_sh_evaluate(65, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_irradiance_matrix(4, 1, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_irradiance_matrix(3, 5, 0, nullptr, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_sh_dot(65, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_sh_dot(3, 5, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
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

// The matrix is the quadratic form of the irradiance.
TEST_P(Evaluate, MatrixEvaluatesToTheIrradiance) {
  Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    float radiance[27], m[48], n[4], e[3];
    random.Fill(radiance, 27, -1.0, 1.0);
    random.Direction(n);
    n[3] = 1.0f;
    gaunt_view vr, vm, vn, ve;
    gaunt_view_interleaved(radiance, 27, &vr);
    gaunt_view_interleaved(m, 48, &vm);
    gaunt_view_interleaved(n, 3, &vn);
    gaunt_view_interleaved(e, 3, &ve);
    ASSERT_EQ(gaunt_irradiance_matrix(3, 3, 1, &vr, &vm), GAUNT_OK);
    ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, 1, &vr, &vn, &ve), GAUNT_OK);
    for (int c = 0; c < 3; ++c) {
      double form = 0.0;
      for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
          form += double{n[row]} * double{m[16 * c + 4 * row + column]} * double{n[column]};
        }
      }
      ASSERT_NEAR(form, e[c], 1e-6);
    }
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
  using C = evaluate::QuadraticConstants<evaluate::IrradianceBands>;
  const double wanted[5] = {C::kMean, C::kLinear, C::kProduct, -C::kOffset, C::kDifference};
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
  for (const uint32_t n : kOrders) {
    TestSameBits(EvaluateOperation(n, 3, false));
    TestSameBits(EvaluateOperation(n, 3, true));
  }
  TestSameBits(ConstantsOperation());
  TestSameBits(MatrixOperation(3));
  TestSameBits(DotOperation(3, 3));
  TestSameBits(DotOperation(9, 1));
  TestSameBits(BlendOperation(3, 3));
}

GAUNT_INSTANTIATE_TARGETS(Evaluate);

}  // namespace
}  // namespace gaunt::test
