// SPDX-License-Identifier: MIT
#include "basis/basis_reference.h"

#include <cmath>
#include <vector>

namespace gaunt::basis {

// y_l^m = N_l^m P_l^|m|(cos theta) (sqrt2 cos m phi, 1, sqrt2 sin |m| phi), P with the
// Condon-Shortley phase. N P is carried as one, in angles: it stays of order 1 and overflows at no
// order.
void EvalReference(int order, const double direction[3], double* y) {
  const double x = direction[0], y_axis = direction[1], z = direction[2];
  const double theta = std::atan2(std::hypot(x, y_axis), z);
  const double phi = std::atan2(y_axis, x);
  const double pi = std::acos(-1.0);
  double sectoral = std::sqrt(1.0 / (4.0 * pi));
  for (int m = 0; m < order; ++m) {
    if (m > 0) sectoral *= -std::sin(theta) * std::sqrt((2.0 * m + 1.0) / (2.0 * m));
    const double c = m == 0 ? 1.0 : std::sqrt(2.0) * std::cos(m * phi);
    const double s = m == 0 ? 1.0 : std::sqrt(2.0) * std::sin(m * phi);
    double below = 0.0, value = sectoral;
    for (int l = m; l < order; ++l) {
      if (l > m) {
        const double ll = l, mm = m;
        const double next =
            std::sqrt((4.0 * ll * ll - 1.0) / (ll * ll - mm * mm)) *
            (std::cos(theta) * value - std::sqrt(((ll - 1.0) * (ll - 1.0) - mm * mm) /
                                                 (4.0 * (ll - 1.0) * (ll - 1.0) - 1.0)) *
                                           below);
        below = value;
        value = next;
      }
      y[l * (l + 1) + m] = value * c;
      y[l * (l + 1) - m] = value * s;
    }
  }
}

// Central differences of eighth order over a step that band `order` varies little in.
void GradientReference(int order, const double direction[3], double* gradient) {
  const size_t n = static_cast<size_t>(order * order);
  const double step = 0.04 / order;
  const double weights[4] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  std::vector<double> ahead(n), behind(n);
  for (size_t axis = 0; axis < 3; ++axis) {
    double* const out = gradient + axis * n;
    for (size_t i = 0; i < n; ++i) out[i] = 0.0;
    for (int k = 1; k <= 4; ++k) {
      double v[3] = {direction[0], direction[1], direction[2]};
      v[axis] = direction[axis] + k * step;
      EvalReference(order, v, ahead.data());
      v[axis] = direction[axis] - k * step;
      EvalReference(order, v, behind.data());
      for (size_t i = 0; i < n; ++i) out[i] += weights[k - 1] * (ahead[i] - behind[i]) / step;
    }
  }
}

}  // namespace gaunt::basis
