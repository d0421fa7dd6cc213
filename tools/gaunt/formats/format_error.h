// SPDX-License-Identifier: MIT
// What packed formats lose of the irradiance of light.
#ifndef GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_ERROR_H_
#define GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_ERROR_H_

#include <cstdint>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::tool {

// Order of the light that errors are measured against: bands above give E next to nothing.
inline constexpr uint32_t kLightOrder = 24;

// RGB radiance, channel by channel, of kLightOrder.
using Light = std::vector<float>;

// Errors of E/pi.
struct FormatError {
  double rms;      // over the sphere and the channels, relative to the RMS of the light
  double largest;  // in any of many directions, relative to the mean of the light
};

Light ProjectLight(const gaunt_image& panorama);

// Of the bands below an order as they are.
FormatError ErrorOfOrder(uint32_t order, const Light& light);
// Of what a format's decoder gives, by gaunt_probe_encode() or gaunt_probe_encode_refined().
FormatError ErrorOfFormat(uint32_t format, bool refined, const Light& light);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_ERROR_H_
