// SPDX-License-Identifier: MIT
// Panoramas from image files.
#ifndef GAUNT_TOOLS_GAUNT_PANORAMA_H_
#define GAUNT_TOOLS_GAUNT_PANORAMA_H_

#include <cstdint>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::tool {

// Texels that no light can have, which LoadPanorama() set to zero.
struct TexelReport {
  uint64_t negative = 0;
  uint64_t not_finite = 0;
};

// Equirectangular, RGB.
struct Panorama {
  int width = 0, height = 0;
  std::vector<float> texels;

  gaunt_image Image() const;
};

// An EXR or HDR file. Throws BadInput.
Panorama LoadPanorama(const std::string& path, TexelReport* report);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_PANORAMA_H_
