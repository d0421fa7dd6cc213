// SPDX-License-Identifier: MIT
// Wrong arguments of conversions: the status, and nothing written.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::test {
namespace {

TEST(ConvertArguments, AreChecked) {
  gaunt_convention gaunt;
  gaunt.struct_size = sizeof(gaunt);
  ASSERT_EQ(gaunt_convention_preset(GAUNT_ENGINE_GAUNT, &gaunt), GAUNT_OK);
  std::vector<float> in(64 * 64, 1.0f), out(64 * 64, 7.0f);
  const std::vector<float> before = out;
  gaunt_view from_view, to_view;
  const auto call = [&](uint32_t n, uint32_t channels, const gaunt_convention* from,
                        const gaunt_convention* to) {
    gaunt_view_interleaved(in.data(), channels * n * n, &from_view);
    gaunt_view_interleaved(out.data(), channels * n * n, &to_view);
    const gaunt_status status = gaunt_convert(n, channels, 1, from, to, &from_view, &to_view);
    EXPECT_EQ(gaunt_convert(n, channels, 0, from, to, nullptr, nullptr), status);
    if (status != GAUNT_OK) {
      EXPECT_EQ(out, before) << "written";
    }
    out = before;
    return status;
  };
  EXPECT_EQ(call(0, 1, &gaunt, &gaunt), GAUNT_ERROR_ORDER);
  EXPECT_EQ(call(65, 1, &gaunt, &gaunt), GAUNT_ERROR_ORDER);
  EXPECT_EQ(call(64, 1, &gaunt, &gaunt), GAUNT_OK);
  EXPECT_EQ(call(3, 0, &gaunt, &gaunt), GAUNT_ERROR_RANGE);
  EXPECT_EQ(call(3, 5, &gaunt, &gaunt), GAUNT_ERROR_RANGE);
  EXPECT_EQ(call(3, 3, nullptr, &gaunt), GAUNT_ERROR_NULL);
  EXPECT_EQ(call(3, 3, &gaunt, nullptr), GAUNT_ERROR_NULL);

  const auto expect = [&](gaunt_status status, uint32_t n, const auto& change) {
    gaunt_convention changed = gaunt;
    change(changed);
    EXPECT_EQ(call(n, 1, &changed, &gaunt), status);
    EXPECT_EQ(call(n, 1, &gaunt, &changed), status);
  };
  using C = gaunt_convention;
  expect(GAUNT_ERROR_STRUCT, 3, [](C& c) { c.struct_size -= 4; });
  expect(GAUNT_ERROR_STRUCT, 3, [](C& c) { c.struct_size = 0; });
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.sign = GAUNT_SIGN_POSITIVE + 1; });
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.coefficients = GAUNT_COEFFICIENTS_FUMA + 1; });
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.scale = GAUNT_SCALE_POLYNOMIAL + 1; });
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.quantity = GAUNT_QUANTITY_IRRADIANCE_OVER_PI + 1; });
  for (int k = 0; k < 3; ++k) {
    expect(GAUNT_ERROR_RANGE, 3, [k](C& c) { c.axes[k] = GAUNT_AXIS_BACKWARD + 1; });
    expect(GAUNT_ERROR_RANGE, 3, [k](C& c) { c.axes[k] = UINT32_MAX; });
    expect(GAUNT_ERROR_RANGE, 3, [k](C& c) { c.axes[k] = c.axes[(k + 1) % 3]; });
    expect(GAUNT_ERROR_RANGE, 3, [k](C& c) { c.axes[k] = c.axes[(k + 1) % 3] ^ 1u; });
  }
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.offset = std::numeric_limits<float>::infinity(); });
  expect(GAUNT_ERROR_RANGE, 3, [](C& c) { c.offset = std::numeric_limits<float>::quiet_NaN(); });
  expect(GAUNT_OK, 3, [](C& c) { c.scale = GAUNT_SCALE_POLYNOMIAL; });
  expect(GAUNT_ERROR_ORDER, 4, [](C& c) { c.scale = GAUNT_SCALE_POLYNOMIAL; });
  expect(GAUNT_OK, 4, [](C& c) { c.scale = GAUNT_SCALE_FUMA; });
  expect(GAUNT_ERROR_ORDER, 5, [](C& c) { c.scale = GAUNT_SCALE_FUMA; });
  expect(GAUNT_OK, 4, [](C& c) { c.coefficients = GAUNT_COEFFICIENTS_FUMA; });
  expect(GAUNT_ERROR_ORDER, 5, [](C& c) { c.coefficients = GAUNT_COEFFICIENTS_FUMA; });
  expect(GAUNT_OK, 64, [](C& c) { std::swap(c.axes[0], c.axes[1]); });
  expect(GAUNT_OK, 16, [](C& c) { std::swap(c.axes[1], c.axes[2]); });
  expect(GAUNT_ERROR_ORDER, 17, [](C& c) { std::swap(c.axes[1], c.axes[2]); });

  // Irradiance has no band 3: only what stays irradiance exists from order 4 up.
  gaunt_convention over_pi = gaunt, irradiance = gaunt, irradiance_over_pi = gaunt;
  over_pi.quantity = GAUNT_QUANTITY_RADIANCE_OVER_PI;
  irradiance.quantity = GAUNT_QUANTITY_IRRADIANCE;
  irradiance_over_pi.quantity = GAUNT_QUANTITY_IRRADIANCE_OVER_PI;
  for (const C* e : {&irradiance, &irradiance_over_pi}) {
    for (const C* radiance : {&std::as_const(gaunt), &std::as_const(over_pi)}) {
      EXPECT_EQ(call(3, 1, e, radiance), GAUNT_OK);
      EXPECT_EQ(call(4, 1, e, radiance), GAUNT_ERROR_ORDER);
      EXPECT_EQ(call(64, 1, radiance, e), GAUNT_OK);
    }
  }
  EXPECT_EQ(call(64, 1, &irradiance, &irradiance_over_pi), GAUNT_OK);
}

TEST(ConvertArguments, OfPresetsAreChecked) {
  EXPECT_EQ(gaunt_convention_preset(0, nullptr), GAUNT_ERROR_NULL);
  gaunt_convention convention;
  std::memset(&convention, 0xAB, sizeof(convention));
  const gaunt_convention before = convention;
  EXPECT_EQ(gaunt_convention_preset(0, &convention), GAUNT_ERROR_STRUCT);
  EXPECT_EQ(std::memcmp(&convention, &before, sizeof(before)), 0);
  convention.struct_size = sizeof(convention);
  EXPECT_EQ(gaunt_convention_preset(GAUNT_ENGINE_FUMA + 1, &convention), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_convention_preset(UINT32_MAX, &convention), GAUNT_ERROR_RANGE);
  EXPECT_EQ(convention.sign, before.sign);
  EXPECT_EQ(gaunt_convention_preset(GAUNT_ENGINE_FUMA, &convention), GAUNT_OK);
}

}  // namespace
}  // namespace gaunt::test
