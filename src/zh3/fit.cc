// SPDX-License-Identifier: MIT
// The curve of hallucinated ZH3, fitted to probes.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "zh3/constants.h"
#include "zh3/zh3.h"

namespace gaunt::zh3 {
namespace {

constexpr int kPlanes = 27;

// Normal equations of y = linear r + quadratic r^2.
struct Sums {
  double r2 = 0.0, r3 = 0.0, r4 = 0.0, ry = 0.0, r2y = 0.0;

  void Add(double r, double y) {
    r2 += r * r;
    r3 += r * r * r;
    r4 += r * r * r * r;
    ry += r * y;
    r2y += r * r * y;
  }

  bool Solve(double* linear, double* quadratic) const {
    // Ratios that differ by less than some 1e-5 of themselves tell one number, not two.
    constexpr double kLeastSpread = 1e-10;
    const double determinant = r2 * r4 - r3 * r3;
    if (!(determinant > kLeastSpread * r2 * r4)) return false;
    *linear = (ry * r4 - r2y * r3) / determinant;
    *quadratic = (r2 * r2y - r3 * ry) / determinant;
    return std::isfinite(*linear) && std::isfinite(*quadratic);
  }
};

// k2 of a channel about an axis.
double ZonalOf(const double* f, const double a[3]) {
  const double sum = kSqrt3 * (a[0] * a[1] * f[4] - a[1] * a[2] * f[5] - a[0] * a[2] * f[7]) +
                     0.5 * kSqrt3 * (a[0] * a[0] - a[1] * a[1]) * f[8];
  return sum + 0.5 * (3.0 * a[2] * a[2] - 1.0) * f[6];
}

// One probe; channels without light, direction or number are left out.
void AddProbe(AxisMode mode, const double* f, Sums* sums) {
  double shared[3] = {};
  for (int c = 0; c < 3; ++c) {
    const double weight = static_cast<double>(kLuminance[c]);
    shared[0] -= weight * f[9 * c + 3];
    shared[1] -= weight * f[9 * c + 1];
    shared[2] += weight * f[9 * c + 2];
  }
  for (int c = 0; c < 3; ++c, f += 9) {
    const double own[3] = {-f[3], -f[1], f[2]};
    const double* const v = mode == kSharedAxis ? shared : own;
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!(length > kLeastVector) || !(f[0] > 0.0)) continue;
    const double a[3] = {v[0] / length, v[1] / length, v[2] / length};
    const double along = std::abs(a[0] * own[0] + a[1] * own[1] + a[2] * own[2]);
    const double r = std::min(along / f[0], kMaxRatio), y = ZonalOf(f, a) / f[0];
    if (std::isfinite(r) && std::isfinite(y)) sums->Add(r, y);
  }
}

}  // namespace

bool FitCurve(AxisMode mode, size_t count, const simd::InView& sh3, double* linear,
              double* quadratic) {
  Sums sums;
  for (size_t i = 0; i < count; ++i) {
    const unsigned char* const item = sh3.Item(i);
    double f[kPlanes];
    for (int p = 0; p < kPlanes; ++p) {
      float value;
      std::memcpy(&value, item + p * sh3.plane_stride, sizeof(value));
      f[p] = static_cast<double>(value);
    }
    AddProbe(mode, f, &sums);
  }
  return sums.Solve(linear, quadratic);
}

}  // namespace gaunt::zh3
