// SPDX-License-Identifier: MIT
#include "frame/bake.h"

#include "basis/basis_reference.h"
#include "evaluate/constants.h"
#include "frame/parallel.h"

namespace gaunt::tool {
namespace {

constexpr double kPi = 3.14159265358979323846;

void AddLight(const Vec3& radiance, const double* y, double* coefficients) {
  for (int i = 0; i < 9; ++i) {
    coefficients[i] += radiance.x * y[i];
    coefficients[9 + i] += radiance.y * y[i];
    coefficients[18 + i] += radiance.z * y[i];
  }
}

// Probes inside walls would leak darkness: each takes the mean of the nearest ones outside, ring by
// ring from the open space.
void FillInvalid(ProbeVolume* volume) {
  const ProbeGrid& grid = volume->grid;
  const int n[3] = {static_cast<int>(grid.nx), static_cast<int>(grid.ny),
                    static_cast<int>(grid.nz)};
  std::vector<uint8_t> known = volume->valid;
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<uint8_t> before = known;
    for (size_t p = 0; p < grid.count(); ++p) {
      if (before[p]) continue;
      const int at[3] = {static_cast<int>(p % grid.nx), static_cast<int>(p / grid.nx % grid.ny),
                         static_cast<int>(p / grid.nx / grid.ny)};
      int found = 0;
      double sum[ProbeVolume::kPlanes] = {};
      for (int side = 0; side < 6; ++side) {
        int to[3] = {at[0], at[1], at[2]};
        to[side / 2] += side % 2 == 0 ? -1 : 1;
        if (to[side / 2] < 0 || to[side / 2] >= n[side / 2]) continue;
        const size_t q = static_cast<size_t>(to[0] + n[0] * (to[1] + n[1] * to[2]));
        if (!before[q]) continue;
        ++found;
        for (size_t k = 0; k < ProbeVolume::kPlanes; ++k) {
          sum[k] += volume->coefficients[q * ProbeVolume::kPlanes + k];
        }
      }
      if (found == 0) continue;
      for (size_t k = 0; k < ProbeVolume::kPlanes; ++k) {
        volume->coefficients[p * ProbeVolume::kPlanes + k] = sum[k] / found;
      }
      known[p] = 1;
      changed = true;
    }
  }
}

}  // namespace

ProbeGrid ProbeGrid::Fill(const Bounds& bounds, uint32_t nx, uint32_t ny, uint32_t nz) {
  const Vec3 size = bounds.high - bounds.low;
  const auto step = [](double length, uint32_t n) { return n > 1 ? length / (n - 1) : length; };
  ProbeGrid grid = {nx, ny, nz, bounds.low, {step(size.x, nx), step(size.y, ny), step(size.z, nz)}};
  // A single layer lies in the middle.
  if (nx == 1) grid.origin.x += 0.5 * size.x;
  if (ny == 1) grid.origin.y += 0.5 * size.y;
  if (nz == 1) grid.origin.z += 0.5 * size.z;
  return grid;
}

Vec3 ProbeGrid::Position(size_t index) const {
  const Vec3 at = {static_cast<double>(index % nx), static_cast<double>(index / nx % ny),
                   static_cast<double>(index / nx / ny)};
  return origin + at * spacing;
}

void ProbeGrid::Taps(const Vec3& point, uint32_t indices[8], float weights[8]) const {
  const double offset[3] = {(point.x - origin.x) / spacing.x, (point.y - origin.y) / spacing.y,
                            (point.z - origin.z) / spacing.z};
  const uint32_t n[3] = {nx, ny, nz};
  uint32_t low[3], high[3];
  double fraction[3];
  for (int k = 0; k < 3; ++k) {
    const double at = std::clamp(offset[k], 0.0, static_cast<double>(n[k] - 1));
    low[k] = std::min(static_cast<uint32_t>(at), n[k] - 1);
    high[k] = std::min(low[k] + 1, n[k] - 1);
    fraction[k] = at - low[k];
  }
  for (uint32_t t = 0; t < 8; ++t) {
    const uint32_t x = t & 1 ? high[0] : low[0], y = t & 2 ? high[1] : low[1];
    const uint32_t z = t & 4 ? high[2] : low[2];
    indices[t] = x + nx * (y + ny * z);
    weights[t] = static_cast<float>((t & 1 ? fraction[0] : 1.0 - fraction[0]) *
                                    (t & 2 ? fraction[1] : 1.0 - fraction[1]) *
                                    (t & 4 ? fraction[2] : 1.0 - fraction[2]));
  }
}

Vec3 ProbeVolume::Irradiance(const Vec3& point, const Vec3& normal) const {
  uint32_t indices[8];
  float weights[8];
  grid.Taps(point, indices, weights);
  const double n[3] = {normal.x, normal.y, normal.z};
  double y[9], rgb[3] = {0.0, 0.0, 0.0};
  basis::EvalReference(3, n, y);
  constexpr double kBand[9] = {
      evaluate::CosineBand(0), evaluate::CosineBand(1), evaluate::CosineBand(1),
      evaluate::CosineBand(1), evaluate::CosineBand(2), evaluate::CosineBand(2),
      evaluate::CosineBand(2), evaluate::CosineBand(2), evaluate::CosineBand(2)};
  for (int t = 0; t < 8; ++t) {
    const double* f = coefficients.data() + indices[t] * kPlanes;
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < 9; ++i) rgb[c] += double{weights[t]} * kBand[i] * f[9 * c + i] * y[i];
    }
  }
  return {std::max(rgb[0], 0.0), std::max(rgb[1], 0.0), std::max(rgb[2], 0.0)};
}

IndirectFn LightFrom(const Scene& scene, const ProbeVolume& volume, const IndirectFn& outside) {
  constexpr double kMargin = 1.2;  // walls stand a little outside of the probes
  const Vec3 margin = {kMargin, kMargin, kMargin};
  const Bounds near = {scene.probe_bounds().low - margin, scene.probe_bounds().high + margin};
  return [&volume, &outside, near](const Vec3& point, const Vec3& normal) {
    return near.Contains(point) ? volume.Irradiance(point, normal) : outside(point, normal);
  };
}

ProbeVolume Bake(const Scene& scene, const Environment& environment, const IndirectFn& outside,
                 const ProbeGrid& grid, int rays, int bounces,
                 const std::function<void(double)>& progress) {
  std::vector<Vec3> directions;
  std::vector<double> basis(static_cast<size_t>(rays) * 9);
  for (int r = 0; r < rays; ++r) {
    directions.push_back(SphereDirection(r, rays));
    const double d[3] = {directions.back().x, directions.back().y, directions.back().z};
    basis::EvalReference(3, d, basis.data() + 9 * r);
  }
  const Sun& sun = environment.sun();
  const double to_sun[3] = {sun.direction.x, sun.direction.y, sun.direction.z};
  double sun_basis[9];
  basis::EvalReference(3, to_sun, sun_basis);

  ProbeVolume volume = {grid, std::vector<double>(grid.count() * ProbeVolume::kPlanes),
                        std::vector<uint8_t>(grid.count())};
  for (int pass = 0; pass <= bounces; ++pass) {
    const ProbeVolume before = volume;  // dark in the first pass
    const IndirectFn indirect = LightFrom(scene, before, outside);
    volume.coefficients.assign(grid.count() * ProbeVolume::kPlanes, 0.0);
    ParallelFor(
        static_cast<int>(grid.count()),
        [&](int p) {
          const Vec3 position = grid.Position(static_cast<size_t>(p));
          volume.valid[static_cast<size_t>(p)] = scene.Inside(position) ? 0 : 1;
          if (!volume.valid[static_cast<size_t>(p)]) return;
          double* coefficients =
              volume.coefficients.data() + static_cast<size_t>(p) * ProbeVolume::kPlanes;
          for (int r = 0; r < rays; ++r) {
            const Vec3& direction = directions[static_cast<size_t>(r)];
            Hit hit;
            const Vec3 radiance = scene.Intersect({position, direction}, &hit)
                                      ? Shade(scene, environment, hit, indirect)
                                      : environment.Radiance(direction);
            AddLight(4.0 * kPi / rays * radiance, basis.data() + 9 * r, coefficients);
          }
          AddLight(SunVisibility(scene, sun, position) * sun.irradiance, sun_basis, coefficients);
        },
        [&](double fraction) {
          if (progress) progress((pass + fraction) / (bounces + 1));
        });
    FillInvalid(&volume);
  }
  return volume;
}

}  // namespace gaunt::tool
