// SPDX-License-Identifier: MIT
#include "zh3/zh3.h"

#include <cmath>

#include "check.h"
#include "zh3/constants.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

bool IsAxisMode(uint32_t mode) {
  return InRange(mode, GAUNT_ZH3_AXIS_LUMINANCE, GAUNT_ZH3_AXIS_CHANNEL);
}
gaunt::zh3::AxisMode ModeOf(uint32_t mode) {
  return mode == GAUNT_ZH3_AXIS_LUMINANCE ? gaunt::zh3::kSharedAxis : gaunt::zh3::kAxisEach;
}

}  // namespace

extern "C" {

gaunt_status gaunt_zh3_solve(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                             const gaunt_view* k2, const gaunt_view* axis) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  MemoryCheck check(count);
  check.In(sh3, 27).Out(k2, 3);
  if (axis != nullptr) check.Out(axis, axis_mode == GAUNT_ZH3_AXIS_LUMINANCE ? 3 : 9);
  GAUNT_CHECK(check.status());
  if (count == 0) return GAUNT_OK;
  gaunt::simd::OutView axis_out = {};
  if (axis != nullptr) axis_out = OutputOf(*axis, count);
  gaunt::zh3::Kernels().solve[ModeOf(axis_mode)](count, InputOf(*sh3, count), OutputOf(*k2, count),
                                                 axis != nullptr ? &axis_out : nullptr);
  return GAUNT_OK;
}

gaunt_status gaunt_zh3_refit(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                             const gaunt_view* sh2, const gaunt_view* k2) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count).In(sh3, 27).Out(sh2, 12).Out(k2, 3).status());
  if (count == 0) return GAUNT_OK;
  gaunt::zh3::Kernels().refit[ModeOf(axis_mode)](count, InputOf(*sh3, count), OutputOf(*sh2, count),
                                                 OutputOf(*k2, count));
  return GAUNT_OK;
}

gaunt_status gaunt_zh3_hallucinate(uint32_t model, uint32_t axis_mode, size_t count,
                                   const gaunt_view* sh2, const gaunt_view* k2) {
  GAUNT_REQUIRE(InRange(model, GAUNT_ZH3_MODEL_AMBIENT_DIRECTIONAL, GAUNT_ZH3_MODEL_CURVE),
                GAUNT_ERROR_RANGE);
  const gaunt::zh3::Curve& curve = gaunt::zh3::kModels[model - GAUNT_ZH3_MODEL_AMBIENT_DIRECTIONAL];
  return gaunt_zh3_hallucinate_curve(static_cast<float>(curve.linear),
                                     static_cast<float>(curve.quadratic), nullptr, axis_mode, count,
                                     sh2, k2);
}

gaunt_status gaunt_zh3_hallucinate_curve(float linear, float quadratic, const float* weights,
                                         uint32_t axis_mode, size_t count, const gaunt_view* sh2,
                                         const gaunt_view* k2) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(std::isfinite(linear) && std::isfinite(quadratic), GAUNT_ERROR_RANGE);
  if (weights == nullptr) weights = gaunt::zh3::kLuminance;
  for (int c = 0; c < 3; ++c) GAUNT_REQUIRE(std::isfinite(weights[c]), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count).In(sh2, 12).Out(k2, 3).status());
  if (count == 0) return GAUNT_OK;
  gaunt::zh3::Kernels().hallucinate[ModeOf(axis_mode)](linear, quadratic, weights, count,
                                                       InputOf(*sh2, count), OutputOf(*k2, count));
  return GAUNT_OK;
}

gaunt_status gaunt_zh3_fit_curve(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                                 float* linear, float* quadratic) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(linear != nullptr && quadratic != nullptr, GAUNT_ERROR_NULL);
  GAUNT_CHECK(MemoryCheck(count).In(sh3, 27).status());
  GAUNT_REQUIRE(count != 0, GAUNT_ERROR_RANGE);
  double fitted[2];
  GAUNT_REQUIRE(
      gaunt::zh3::FitCurve(ModeOf(axis_mode), count, InputOf(*sh3, count), &fitted[0], &fitted[1]),
      GAUNT_ERROR_RANGE);
  const float rounded[2] = {static_cast<float>(fitted[0]), static_cast<float>(fitted[1])};
  GAUNT_REQUIRE(std::isfinite(rounded[0]) && std::isfinite(rounded[1]), GAUNT_ERROR_RANGE);
  *linear = rounded[0];
  *quadratic = rounded[1];
  return GAUNT_OK;
}

gaunt_status gaunt_zh3_expand(uint32_t axis_mode, size_t count, const gaunt_view* sh2,
                              const gaunt_view* k2, const gaunt_view* sh3) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count).In(sh2, 12).In(k2, 3).Out(sh3, 27).status());
  if (count == 0) return GAUNT_OK;
  gaunt::zh3::Kernels().expand[ModeOf(axis_mode)](count, InputOf(*sh2, count), InputOf(*k2, count),
                                                  OutputOf(*sh3, count));
  return GAUNT_OK;
}

gaunt_status gaunt_zh3_irradiance(uint32_t axis_mode, size_t count, const gaunt_view* sh2,
                                  const gaunt_view* k2, const gaunt_view* normals,
                                  const gaunt_view* out) {
  GAUNT_REQUIRE(IsAxisMode(axis_mode), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count).In(sh2, 12).In(k2, 3).In(normals, 3).Out(out, 3).status());
  if (count == 0) return GAUNT_OK;
  gaunt::zh3::Kernels().irradiance[ModeOf(axis_mode)](count, InputOf(*sh2, count),
                                                      InputOf(*k2, count), InputOf(*normals, count),
                                                      OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_geomerics_irradiance(size_t count, const gaunt_view* sh2,
                                        const gaunt_view* normals, const gaunt_view* out) {
  GAUNT_CHECK(MemoryCheck(count).In(sh2, 12).In(normals, 3).Out(out, 3).status());
  if (count == 0) return GAUNT_OK;
  gaunt::zh3::Kernels().geomerics(count, InputOf(*sh2, count), InputOf(*normals, count),
                                  OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
