// SPDX-License-Identifier: MIT
// The part of the basis that depends on the polar angle, in double precision, for projections that
// separate into rows.
#ifndef GAUNT_PROJECT_LEGENDRE_H_
#define GAUNT_PROJECT_LEGENDRE_H_

#include "basis/constants.h"

namespace gaunt::project {

// Calls visit(l, m, p) for 0 <= m <= l < order, where y_l^+-m(theta, phi) = p cos(m phi), p sin(m
// phi) at cos(theta) = z, sin(theta) = s.
template <class Visit>
void ForEachLegendre(int order, double z, double s, const Visit& visit) {
  double sectoral = 1.0;  // s^m
  for (int m = 0; m < order; ++m) {
    double below = 0.0, value = basis::Sectoral(m) * sectoral;
    visit(m, m, value);
    for (int l = m + 1; l < order; ++l) {
      const double next =
          basis::StepForward(l, m) * (z * value - basis::StepBackward(l, m) * below);
      below = value;
      value = next;
      visit(l, m, value);
    }
    sectoral *= s;
  }
}

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_LEGENDRE_H_
