// SPDX-License-Identifier: MIT
#include "frame/lighting.h"

#include <limits>

namespace gaunt::tool {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOffset = 1e-4;  // off a surface, so that it does not shade itself

}  // namespace

double SunVisibility(const Scene& scene, const Sun& sun, const Vec3& point) {
  constexpr int kRays = 5;
  const Vec3 side = Normalize(Cross(
      sun.direction, std::abs(sun.direction.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0}));
  const Vec3 up = Cross(side, sun.direction);
  int seen = 0;
  for (int k = 0; k < kRays; ++k) {
    const double r = k == 0 ? 0.0 : 0.7 * sun.angle, turn = 2.0 * kPi * k / (kRays - 1);
    const Vec3 direction =
        Normalize(sun.direction + (r * std::cos(turn)) * side + (r * std::sin(turn)) * up);
    if (!scene.Occluded({point, direction}, std::numeric_limits<double>::infinity())) ++seen;
  }
  return static_cast<double>(seen) / kRays;
}

Vec3 Shade(const Scene& scene, const Environment& environment, const Hit& hit,
           const IndirectFn& indirect) {
  const Sun& sun = environment.sun();
  const Vec3 above = hit.point + kOffset * hit.normal;
  Vec3 reflected = indirect(above, hit.normal);
  const double cosine = Dot(hit.normal, sun.direction);
  if (cosine > 0.0 && Luminance(sun.irradiance) > 0.0) {
    reflected += (cosine * SunVisibility(scene, sun, above) / kPi) * sun.irradiance;
  }
  return hit.albedo * reflected;
}

}  // namespace gaunt::tool
