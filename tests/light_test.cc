// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "gaunt/gaunt.h"
#include "light/constants.h"
#include "light/light_reference.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

// Radiance with a mean and a direction to find, in all channels alike.
void MakeRadiance(Random& random, uint32_t n, uint32_t channels, float* out) {
  float d[3];
  random.Direction(d);
  for (uint32_t c = 0; c < channels; ++c) {
    float* f = out + c * n * n;
    random.Fill(f, n * n, -0.3, 0.3);
    const float strength = random.Between(0.6, 1.0);
    f[0] = random.Between(0.02, 1.5);  // down to where no ambient light is left
    f[1] = 0.2f * f[1] - strength * d[1];
    f[2] = 0.2f * f[2] + strength * d[2];
    f[3] = 0.2f * f[3] - strength * d[0];
  }
}

Operation DirectionOperation(uint32_t n, uint32_t channels, std::vector<float> weights) {
  Operation operation;
  operation.name = "light_direction/n" + std::to_string(n) + "/channels" +
                   std::to_string(channels) + (weights.empty() ? "" : "/weights");
  operation.inputs = {channels * n * n};
  operation.outputs = {3};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_light_direction(n, channels, count, in[0],
                                 weights.empty() ? nullptr : weights.data(), out[0]);
  };
  operation.make = [=](Random& random, size_t, float* out) {
    MakeRadiance(random, n, channels, out);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    const std::vector<double> exact(weights.begin(), weights.end());
    light::DirectionReference(static_cast<int>(n), static_cast<int>(channels), in[0].data(),
                              weights.empty() ? nullptr : exact.data(), out[0].data());
  };
  operation.tolerance = [](const Operation::Item&, const Operation::Item&, size_t, size_t) {
    return 4e-7 / 0.3;
  };
  return operation;
}

Operation ExtractOperation(uint32_t n, uint32_t channels, uint32_t sense) {
  Operation operation;
  operation.name = "light_extract/n" + std::to_string(n) + "/channels" + std::to_string(channels) +
                   (sense == GAUNT_SENSE_RADIANCE ? "/L" : "/E");
  operation.inputs = {channels * n * n, 3};
  operation.outputs = {channels, channels};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_light_extract(n, channels, 1, sense, count, in[0], in[1], out[0], out[1]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    if (side == 1) return random.Direction(out);
    MakeRadiance(random, n, channels, out);
    if (random.Uniform() < 0.1) std::fill(out, out + channels * n * n, 0.0f);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    light::ExtractReference(static_cast<int>(n), static_cast<int>(channels),
                            sense == GAUNT_SENSE_IRRADIANCE, in[0].data(), in[1].data(),
                            out[0].data(), out[1].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t, size_t) {
    double largest = 0.0;
    for (uint32_t c = 0; c < channels; ++c) {
      double sum = 0.0;
      for (uint32_t i = 0; i < n * n; ++i) sum += in[0][c * n * n + i] * in[0][c * n * n + i];
      largest = std::max(largest, std::sqrt(sum));
    }
    return 1e-6 * largest;
  };
  return operation;
}

class Light : public TargetTest {};

TEST_P(Light, DirectionMatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 2; n <= GAUNT_MAX_LIGHT_ORDER; ++n) {
    for (const uint32_t channels : {1u, 3u, 4u}) TestBatches(DirectionOperation(n, channels, {}));
  }
  TestBatches(DirectionOperation(3, 3, {0.5f, 0.25f, 1.0f}));
}

TEST_P(Light, ExtractionMatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 2; n <= GAUNT_MAX_LIGHT_ORDER; ++n) {
    for (const uint32_t channels : {1u, 3u}) {
      TestBatches(ExtractOperation(n, channels, GAUNT_SENSE_IRRADIANCE));
      TestBatches(ExtractOperation(n, channels, GAUNT_SENSE_RADIANCE));
    }
  }
}

TEST_P(Light, RejectsWrongArguments) {
  TestErrors(DirectionOperation(3, 3, {}));
  TestErrors(ExtractOperation(3, 3, GAUNT_SENSE_IRRADIANCE));
  EXPECT_EQ(gaunt_light_direction(1, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_light_direction(7, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_light_direction(3, 0, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  const auto extract = [](uint32_t n, uint32_t channels, uint32_t lights, uint32_t sense) {
    return gaunt_light_extract(n, channels, lights, sense, 0, nullptr, nullptr, nullptr, nullptr);
  };
  EXPECT_EQ(extract(3, 3, 1, 0), GAUNT_OK);
  EXPECT_EQ(extract(1, 3, 1, 0), GAUNT_ERROR_ORDER);
  EXPECT_EQ(extract(3, 5, 1, 0), GAUNT_ERROR_RANGE);
  EXPECT_EQ(extract(3, 3, 0, 0), GAUNT_ERROR_RANGE);
  EXPECT_EQ(extract(3, 3, 2, 0), GAUNT_ERROR_RANGE);
  EXPECT_EQ(extract(3, 3, 1, 2), GAUNT_ERROR_RANGE);
}

void DirectionOf(const float f[4], float d[3]) {
  gaunt_view in, out;
  gaunt_view_interleaved(const_cast<float*>(f), 4, &in);
  gaunt_view_interleaved(d, 3, &out);
  ASSERT_EQ(gaunt_light_direction(2, 1, 1, &in, nullptr, &out), GAUNT_OK);
}

// The naive normalisation under- and overflows in these (squares of 1e-23 and of 1e20).
TEST_P(Light, DirectionHoldsForTinyAndHugeLight) {
  for (const float scale :
       {1e-37f, 1e-30f, 1e-23f, 1e-20f, 1e-10f, 1.0f, 1e10f, 1e18f, 1e20f, 1e30f, 1e37f}) {
    const float f[4] = {1.5f * scale, -0.6f * scale, 0.48f * scale, -0.64f * scale};
    float d[3];
    DirectionOf(f, d);
    EXPECT_NEAR(d[0], 0.64, 4e-7) << scale;
    EXPECT_NEAR(d[1], 0.6, 4e-7) << scale;
    EXPECT_NEAR(d[2], 0.48, 4e-7) << scale;
  }
}

TEST_P(Light, DirectionIsUpWhereThereIsNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float cases[][4] = {{0, 0, 0, 0},      {1, 0, 0, 0},   {1, 5e-6f, 0, 0},
                            {-1, 0, 0, 5e-6f}, {1, nan, 0, 0}, {1, 0, nan, 0},
                            {1, 0, 0, nan},    {nan, 0, 1, 0}, {1, inf, 0, 0},
                            {1, 0, -inf, inf}, {inf, 1, 0, 0}, {1e-30f, 1e-36f, 0, 0}};
  for (const auto& f : cases) {
    float d[3];
    DirectionOf(f, d);
    EXPECT_EQ(d[0], 0.0f);
    EXPECT_EQ(d[1], 0.0f);
    EXPECT_EQ(d[2], 1.0f);
  }
}

TEST_P(Light, NotANumberGivesNoLight) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  float f[9] = {1, 0, nan}, d[3] = {0, 0, 1};
  float colour = 9, ambient = 9;
  gaunt_view vf, vd, vc, va;
  gaunt_view_interleaved(f, 9, &vf);
  gaunt_view_interleaved(d, 3, &vd);
  gaunt_view_interleaved(&colour, 1, &vc);
  gaunt_view_interleaved(&ambient, 1, &va);
  ASSERT_EQ(gaunt_light_extract(3, 1, 1, GAUNT_SENSE_IRRADIANCE, 1, &vf, &vd, &vc, &va), GAUNT_OK);
  EXPECT_EQ(colour, 0.0f);
  EXPECT_NEAR(ambient, 0.5 / std::sqrt(std::acos(-1.0)), 1e-7);
  f[0] = nan;
  ASSERT_EQ(gaunt_light_extract(3, 1, 1, GAUNT_SENSE_IRRADIANCE, 1, &vf, &vd, &vc, &va), GAUNT_OK);
  EXPECT_EQ(colour, 0.0f);
  EXPECT_EQ(ambient, 0.0f);
}

TEST_P(Light, MatchesGoldenExtractions) {
  std::map<std::string, std::map<std::string, std::map<int, double>>> cases;
  for (const auto& row : ReadGolden("light_extraction.csv")) {
    cases[row[0]][row[1]][std::stoi(row[2])] = std::stod(row[3]);
  }
  int tested = 0;
  for (auto& [name, golden] : cases) {
    if (golden["c"].size() != 1) continue;
    const uint32_t n = static_cast<uint32_t>(golden["order"][0]);
    std::vector<float> f(n * n);
    double norm = 0.0;
    for (uint32_t i = 0; i < n * n; ++i) {
      f[i] = static_cast<float>(golden["L_radiance"][static_cast<int>(i)]);
      norm = std::hypot(norm, golden["L_radiance"][static_cast<int>(i)]);
    }
    float d[3], colour, ambient;
    for (int k = 0; k < 3; ++k) d[k] = static_cast<float>(golden["dir0"][k]);
    gaunt_view vf, vd, vc, va;
    gaunt_view_interleaved(f.data(), n * n, &vf);
    gaunt_view_interleaved(d, 3, &vd);
    gaunt_view_interleaved(&colour, 1, &vc);
    gaunt_view_interleaved(&ambient, 1, &va);
    const bool radiance = name.find("_radiance") != std::string::npos;
    ASSERT_EQ(gaunt_light_extract(n, 1, 1, radiance ? GAUNT_SENSE_RADIANCE : GAUNT_SENSE_IRRADIANCE,
                                  1, &vf, &vd, &vc, &va),
              GAUNT_OK);
    EXPECT_NEAR(colour, std::max(0.0, golden["c"][0]), 1e-6 * norm) << name;
    if (golden["c"][0] >= 0.0 && golden["ambient"][0] >= 0.0) {
      EXPECT_NEAR(ambient, golden["ambient"][0], 1e-6 * norm) << name;
    }
    if (golden.count("optimal_linear_dir") != 0) {
      gaunt_view vo;
      float found[3];
      gaunt_view_interleaved(found, 3, &vo);
      ASSERT_EQ(gaunt_light_direction(n, 1, 1, &vf, nullptr, &vo), GAUNT_OK);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], golden["optimal_linear_dir"][k], 1e-6);
    }
    ++tested;
  }
  EXPECT_GE(tested, 2);
}

template <int n>
void ExpectNorm(const std::vector<std::vector<std::string>>& rows) {
  EXPECT_NEAR(light::DirectionalNorm(n), std::stod(rows[n - 1][1]), 1e-13);
  EXPECT_NEAR(light::DirectionalNormReference(n), std::stod(rows[n - 1][1]), 1e-12);
  if constexpr (n < GAUNT_MAX_LIGHT_ORDER) ExpectNorm<n + 1>(rows);
}

TEST(LightConstants, MatchGoldenNormalisation) {
  ExpectNorm<1>(ReadGolden("directional_normalisation.csv"));
}

TEST(LightBits, AreTheSameOnTargetsOfAClass) {
  for (uint32_t n = 2; n <= GAUNT_MAX_LIGHT_ORDER; ++n) {
    TestSameBits(DirectionOperation(n, 3, {}));
    TestSameBits(ExtractOperation(n, 3, GAUNT_SENSE_IRRADIANCE));
    TestSameBits(ExtractOperation(n, 3, GAUNT_SENSE_RADIANCE));
  }
}

GAUNT_INSTANTIATE_TARGETS(Light);

}  // namespace
}  // namespace gaunt::test
