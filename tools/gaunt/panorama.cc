// SPDX-License-Identifier: MIT
#include "panorama.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

constexpr int kMaxSize = 32768;

}  // namespace

gaunt_image Panorama::Image() const {
  return {texels.data(),
          static_cast<uint32_t>(width),
          static_cast<uint32_t>(height),
          3 * sizeof(float),
          static_cast<ptrdiff_t>(3 * sizeof(float)) * width,
          GAUNT_TEXEL_F32};
}

Panorama LoadPanorama(const std::string& path, TexelReport* report) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw BadInput("cannot read " + path + ": " + FirstLine(OIIO::geterror()));
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 2 || spec.height < 2 || spec.width > kMaxSize || spec.height > kMaxSize ||
      spec.nchannels < 1) {
    throw BadInput(path + " is no panorama: " + std::to_string(spec.width) + " x " +
                   std::to_string(spec.height) + " texels, " + std::to_string(spec.nchannels) +
                   " channels");
  }
  const int channels = std::min(spec.nchannels, 3);
  std::vector<float> read(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                          static_cast<size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, read.data())) {
    throw BadInput("cannot read " + path + ": " + FirstLine(input->geterror()));
  }
  Panorama panorama = {spec.width, spec.height, {}};
  panorama.texels.reserve(read.size() / static_cast<size_t>(channels) * 3);
  for (size_t texel = 0; texel < read.size(); texel += static_cast<size_t>(channels)) {
    for (int c = 0; c < 3; ++c) {
      float value = read[texel + static_cast<size_t>(std::min(c, channels - 1))];
      if (!std::isfinite(value)) {
        ++report->not_finite;
        value = 0.0f;
      } else if (value < 0.0f) {
        ++report->negative;
        value = 0.0f;
      }
      panorama.texels.push_back(value);
    }
  }
  return panorama;
}

}  // namespace gaunt::tool
