// SPDX-License-Identifier: MIT
// What lies around a scene: a panorama, with its sun taken out to be sampled on its own.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_ENVIRONMENT_H_
#define GAUNT_TOOLS_GAUNT_FRAME_ENVIRONMENT_H_

#include <string>
#include <vector>

#include "frame/geometry.h"
#include "panorama.h"

namespace gaunt::tool {

struct Sun {
  Vec3 direction = {0.0, 0.0, 1.0};  // towards it
  Vec3 irradiance;                   // on a surface that faces it
  double angle = 0.005;              // half of its width
};

// Equirectangular, z up, in the orientation of gaunt_project_equirect().
class Environment {
 public:
  // A clear sky in the late afternoon.
  static Environment Procedural();
  // An EXR or HDR file. Throws BadInput.
  static Environment Load(const std::string& path, TexelReport* report);

  Vec3 Radiance(const Vec3& direction) const;  // without the sun
  const Sun& sun() const { return sun_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<float>& texels() const { return texels_; }  // RGB

 private:
  Vec3 Texel(int column, int row) const;
  Vec3 Direction(double column, double row) const;
  // Moves a small, bright spot of the image into sun_.
  void TakeSun();

  int width_ = 0, height_ = 0;
  std::vector<float> texels_;
  Sun sun_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_ENVIRONMENT_H_
