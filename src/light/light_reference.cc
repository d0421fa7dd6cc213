// SPDX-License-Identifier: MIT
#include "light/light_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"
#include "evaluate/evaluate_reference.h"

namespace gaunt::light {

double DirectionalNormReference(int order) {
  double peak = 0.0;  // E/pi of y(d) at d, by the addition theorem
  for (int l = 0; l < order; ++l) {
    peak += (2.0 * l + 1.0) / (4.0 * std::acos(-1.0)) * evaluate::CosineFactor(l);
  }
  return 1.0 / peak;
}

bool DirectionReference(int order, int channels, const double* in, const double* weights,
                        double direction[3]) {
  const double luminance[3] = {0.2126, 0.7152, 0.0722};
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  for (int c = 0; c < channels; ++c) {
    const double weight = weights != nullptr ? weights[c] : channels == 3 ? luminance[c] : 1.0;
    for (int i = 0; i < 4; ++i) sum[i] += weight * in[c * order * order + i];
  }
  const double length = std::hypot(sum[1], sum[2], sum[3]);
  direction[0] = direction[1] = 0.0;
  direction[2] = 1.0;
  if (!(length > 1e-5 * std::abs(sum[0])) || !std::isfinite(length)) return false;
  direction[0] = -sum[3] / length;
  direction[1] = -sum[1] / length;
  direction[2] = sum[2] / length;
  return true;
}

void ExtractReference(int order, int channels, bool irradiance, const double* in,
                      const double direction[3], double* colour, double* ambient) {
  const size_t n = static_cast<size_t>(order * order);
  std::vector<double> light(n), even(n, 0.0), factor(n);
  basis::EvalReference(order, direction, light.data());
  for (int l = 0; l < order; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      factor[static_cast<size_t>(i)] = irradiance ? evaluate::CosineFactor(l) : 1.0;
    }
  }
  for (size_t i = 0; i < n; ++i) light[i] *= DirectionalNormReference(order) * factor[i];
  even[0] = 2.0 * std::sqrt(std::acos(-1.0)) * factor[0];
  const auto dot = [&](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
  };
  // Normal equations of the two unknowns; without one of them where it would be negative.
  const double ll = dot(light, light), le = dot(light, even), ee = dot(even, even);
  for (int c = 0; c < channels; ++c) {
    std::vector<double> f(in + static_cast<size_t>(c) * n, in + static_cast<size_t>(c + 1) * n);
    for (size_t i = 0; i < n; ++i) f[i] *= factor[i];
    const double lf = dot(light, f), ef = dot(even, f);
    const double determinant = ll * ee - le * le;
    colour[c] = (ee * lf - le * ef) / determinant;
    ambient[c] = (ll * ef - le * lf) / determinant;
    if (colour[c] < 0.0) {
      colour[c] = 0.0;
      ambient[c] = std::max(0.0, ef / ee);
    } else if (ambient[c] < 0.0) {
      ambient[c] = 0.0;
      colour[c] = std::max(0.0, lf / ll);
    }
  }
}

}  // namespace gaunt::light
