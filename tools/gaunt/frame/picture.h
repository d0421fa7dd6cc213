// SPDX-License-Identifier: MIT
// Pictures of a scene with lit spheres, each twice: lit from packed probes, and from the reference.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_PICTURE_H_
#define GAUNT_TOOLS_GAUNT_FRAME_PICTURE_H_

#include <string>
#include <vector>

#include "frame/lighting.h"

namespace gaunt::tool {

struct LitSphere {
  Vec3 centre;
  double radius;
  Vec3 albedo;
  float constants[28];  // as of gaunt_irradiance_constants()
  float light[6];       // direction and colour of the dominant light
};

struct Picture {
  int width, height;
  std::vector<unsigned char> rgb;
};

// Left and right halves show the same view and differ in the light of the spheres only. Each half
// is width / 2 wide; both have the same exposure.
Picture Render(const Scene& scene, const Environment& environment, const IndirectFn& indirect,
               const std::vector<LitSphere>& left, const std::vector<LitSphere>& right, int width,
               int height);

// Writes a PNG, whole or not at all. Throws BadInput.
void WritePng(const Picture& picture, const std::string& path);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_PICTURE_H_
