// SPDX-License-Identifier: MIT
#include "evaluate/evaluate_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"

namespace gaunt::evaluate {

// A_l / pi = 2 int_0^1 x P_l(x) dx in closed form (Ramamoorthi and Hanrahan 2001): 2/3 for l = 1, 0
// for other odd l, else 2 (-1)^(l/2-1) l! / ((l+2) (l-1) 2^l (l/2)!^2).
double CosineFactor(int l) {
  if (l == 1) return 2.0 / 3.0;
  if (l % 2 == 1) return 0.0;
  const double log_ratio =
      std::lgamma(l + 1.0) - l * std::log(2.0) - 2.0 * std::lgamma(0.5 * l + 1.0);
  return (l / 2 % 2 == 1 ? 2.0 : -2.0) / ((l + 2.0) * (l - 1.0)) * std::exp(log_ratio);
}

double ShReference(int order, const double* coefficients, const double direction[3]) {
  std::vector<double> y(static_cast<size_t>(order * order));
  basis::EvalReference(order, direction, y.data());
  double sum = 0.0;
  for (size_t i = 0; i < y.size(); ++i) sum += coefficients[i] * y[i];
  return sum;
}

double IrradianceReference(int order, const double* radiance, const double normal[3]) {
  std::vector<double> convolved(radiance, radiance + order * order);
  for (int l = 0; l < order; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      convolved[static_cast<size_t>(i)] *= CosineFactor(l);
    }
  }
  return ShReference(order, convolved.data(), normal);
}

void IrradianceConstantsReference(const double radiance[27], double out[28]) {
  const double root_pi = std::sqrt(std::acos(-1.0));
  const double c0 = 1.0 / (2.0 * root_pi), c1 = std::sqrt(3.0) / (3.0 * root_pi);
  const double c2 = std::sqrt(15.0) / (8.0 * root_pi), c3 = std::sqrt(5.0) / (16.0 * root_pi);
  for (int c = 0; c < 3; ++c) {
    const double* L = radiance + 9 * c;
    const double a[4] = {-c1 * L[3], -c1 * L[1], c1 * L[2], c0 * L[0] - c3 * L[6]};
    const double b[4] = {c2 * L[4], -c2 * L[5], 3.0 * c3 * L[6], -c2 * L[7]};
    std::copy(a, a + 4, out + 4 * c);
    std::copy(b, b + 4, out + 12 + 4 * c);
    out[24 + c] = 0.5 * c2 * L[8];
  }
  out[27] = 1.0;
}

// By polarisation: E/pi(n) = v M v with v = (n, 1) holds for every unit n, and fixes M but for the
// trace of its upper part against its last entry; the polynomial of order 3 has M_xx = -M_yy.
void IrradianceMatrixReference(const double radiance[9], double out[16]) {
  const double root = std::sqrt(0.5);
  const auto e = [&](double x, double y, double z) {
    const double normal[3] = {x, y, z};
    return IrradianceReference(3, radiance, normal);
  };
  const auto even = [&](double x, double y, double z) {
    return 0.5 * (e(x, y, z) + e(-x, -y, -z));
  };
  const auto odd = [&](double x, double y, double z) { return 0.5 * (e(x, y, z) - e(-x, -y, -z)); };
  const double xx = even(1, 0, 0), yy = even(0, 1, 0), zz = even(0, 0, 1);
  const double last = 0.5 * (xx + yy);
  const double m[4][4] = {{xx - last, even(root, root, 0) - last,
                           even(root, 0, root) - 0.5 * (xx + zz), 0.5 * odd(1, 0, 0)},
                          {0, yy - last, even(0, root, root) - 0.5 * (yy + zz), 0.5 * odd(0, 1, 0)},
                          {0, 0, zz - last, 0.5 * odd(0, 0, 1)},
                          {0, 0, 0, last}};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      out[4 * row + column] = m[std::min(row, column)][std::max(row, column)];
    }
  }
}

}  // namespace gaunt::evaluate
