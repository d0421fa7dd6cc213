// SPDX-License-Identifier: MIT
// Radiance that rays bring back from a scene.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_LIGHTING_H_
#define GAUNT_TOOLS_GAUNT_FRAME_LIGHTING_H_

#include <functional>

#include "frame/environment.h"
#include "frame/geometry.h"
#include "frame/scene.h"

namespace gaunt::tool {

// E/pi, without the sun, of a surface at a point.
using IndirectFn = std::function<Vec3(const Vec3& point, const Vec3& normal)>;

// Share of the sun that is seen from a point.
double SunVisibility(const Scene& scene, const Sun& sun, const Vec3& point);

// Radiance that a diffuse surface sends out.
Vec3 Shade(const Scene& scene, const Environment& environment, const Hit& hit,
           const IndirectFn& indirect);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_LIGHTING_H_
