// SPDX-License-Identifier: MIT
#include "light/light.h"

#include "check.h"
#include "light/constants.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

extern "C" {

gaunt_status gaunt_light_direction(uint32_t n, uint32_t channels, size_t count,
                                   const gaunt_view* in, const float* weights,
                                   const gaunt_view* directions) {
  GAUNT_REQUIRE(InRange(n, 2, GAUNT_MAX_LIGHT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count).In(in, channels * n * n).Out(directions, 3).status());
  if (count == 0) return GAUNT_OK;
  float used[GAUNT_MAX_CHANNELS];
  for (uint32_t c = 0; c < channels; ++c) {
    if (weights != nullptr) {
      used[c] = weights[c];
    } else {
      used[c] = channels == 3 ? static_cast<float>(gaunt::light::kLuminance[c]) : 1.0f;
    }
  }
  gaunt::light::Kernels().direction(n * n, channels, used, count, InputOf(*in, count),
                                    OutputOf(*directions, count));
  return GAUNT_OK;
}

gaunt_status gaunt_light_extract(uint32_t n, uint32_t channels, uint32_t lights, uint32_t sense,
                                 size_t count, const gaunt_view* in, const gaunt_view* directions,
                                 const gaunt_view* colours, const gaunt_view* ambient) {
  GAUNT_REQUIRE(InRange(n, 2, GAUNT_MAX_LIGHT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(lights == 1, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(sense <= GAUNT_SENSE_IRRADIANCE, GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(in, channels * n * n)
                  .In(directions, 3)
                  .Out(colours, channels)
                  .Out(ambient, channels)
                  .status());
  if (count == 0) return GAUNT_OK;
  const gaunt::light::Table& kernels = gaunt::light::Kernels();
  const auto* extract =
      sense == GAUNT_SENSE_RADIANCE ? kernels.extract_radiance : kernels.extract_irradiance;
  extract[n](channels, count, InputOf(*in, count), InputOf(*directions, count),
             OutputOf(*colours, count), OutputOf(*ambient, count));
  return GAUNT_OK;
}

}  // extern "C"
