// SPDX-License-Identifier: MIT
// The part of the basis that depends on the polar angle, in double precision, for projections that
// separate into rows, and as polynomials.
#ifndef GAUNT_PROJECT_LEGENDRE_H_
#define GAUNT_PROJECT_LEGENDRE_H_

#include <cmath>
#include <cstddef>

#include "basis/constants.h"
#include "project/project.h"

namespace gaunt::project {

// Columns first <= m < last of the recurrence over bands, the steps computed once for all rows:
//   q_m^m = sectoral(m),  q_l^m = forward z q_{l-1}^m - backward q_{l-2}^m,
//   y_l^+-m = q_l^m(z) Re, Im (x + i y)^m.
class Legendre {
 public:
  struct Step {
    double forward;
    double backward;
  };

  Legendre(int order, int first, int last) : order_(order), first_(first), last_(last) {
    double sectoral = std::sqrt(1.0 / (4.0 * kPi));
    Step* step = steps_;
    for (int m = 0; m < last; ++m) {
      if (m > 0) sectoral *= -std::sqrt((2.0 * m + 1.0) / (2.0 * m) * (m == 1 ? 2.0 : 1.0));
      if (m < first) continue;
      sectoral_[m] = sectoral;
      double below = 0.0;
      for (int l = m + 1; l < order; ++l) {
        const double ll = 1.0 * l * l, forward = std::sqrt((4.0 * ll - 1.0) / (ll - 1.0 * m * m));
        *step++ = {forward, below == 0.0 ? 0.0 : forward / below};
        below = forward;
      }
    }
  }

  // Calls visit(l, m, p) column by column, where y_l^+-m = p cos(m phi), p sin(m phi) at polar
  // angle theta, cos(theta) = z, sin(theta) = s.
  template <class Visit>
  void ForEach(double z, double s, const Visit& visit) const {
    double power = std::pow(s, first_);
    const Step* step = steps_;
    for (int m = first_; m < last_; ++m) {
      double below = 0.0, value = sectoral_[m] * power;
      visit(m, m, value);
      for (int l = m + 1; l < order_; ++l, ++step) {
        const double next = step->forward * z * value - step->backward * below;
        below = value;
        value = next;
        visit(l, m, value);
      }
      power *= s;
    }
  }

  // Calls visit(l, m, q) column by column, where q[k] is the factor of z^k in q_l^m. For low orders:
  // q has as many elements as there are bands, of which there are at most kBands.
  template <int kBands, class Visit>
  void ForEachPolynomial(const Visit& visit) const {
    const Step* step = steps_;
    for (int m = first_; m < last_; ++m) {
      double below[kBands] = {}, value[kBands] = {sectoral_[m]};
      visit(m, m, value);
      for (int l = m + 1; l < order_; ++l, ++step) {
        double next[kBands];
        for (int k = 0; k < order_; ++k) {
          next[k] = (k > 0 ? step->forward * value[k - 1] : 0.0) - step->backward * below[k];
        }
        for (int k = 0; k < order_; ++k) below[k] = value[k], value[k] = next[k];
        visit(l, m, value);
      }
    }
  }

 private:
  int order_, first_, last_;
  double sectoral_[kMaxOrder];
  Step steps_[Pass::kMaxCoefficients];
};

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_LEGENDRE_H_
