// SPDX-License-Identifier: MIT
// A grid of probes, baked by casting rays.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_BAKE_H_
#define GAUNT_TOOLS_GAUNT_FRAME_BAKE_H_

#include <cstdint>
#include <functional>
#include <vector>

#include "frame/lighting.h"

namespace gaunt::tool {

struct ProbeGrid {
  uint32_t nx, ny, nz;  // x runs fastest
  Vec3 origin, spacing;

  // Evenly inside bounds.
  static ProbeGrid Fill(const Bounds& bounds, uint32_t nx, uint32_t ny, uint32_t nz);
  size_t count() const { return size_t{nx} * ny * nz; }
  Vec3 Position(size_t index) const;
  // The corners of the cell around a point, and their trilinear weights.
  void Taps(const Vec3& point, uint32_t indices[8], float weights[8]) const;
};

// RGB radiance of order 3 per probe, channel-major, in double precision.
struct ProbeVolume {
  static constexpr size_t kPlanes = 27;
  ProbeGrid grid;
  std::vector<double> coefficients;
  std::vector<uint8_t> valid;  // 0: inside something solid; filled from its neighbours

  // E/pi at a point, from blended probes.
  Vec3 Irradiance(const Vec3& point, const Vec3& normal) const;
};

// Deterministic, whatever the number of cores. `bounces` counts reflections between surfaces; those
// outside the probes are lit by `outside`.
ProbeVolume Bake(const Scene& scene, const Environment& environment, const IndirectFn& outside,
                 const ProbeGrid& grid, int rays, int bounces,
                 const std::function<void(double)>& progress);

// Inside the scene's probe bounds, or just beyond, light from the volume; else from `outside`.
IndirectFn LightFrom(const Scene& scene, const ProbeVolume& volume, const IndirectFn& outside);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_BAKE_H_
