// SPDX-License-Identifier: MIT
// Constants of the basis recurrences, computed at compile time from the normalisation
//   K_l^m = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!),
// and carried inside the recurrence so that nothing overflows at any order.
#ifndef GAUNT_BASIS_CONSTANTS_H_
#define GAUNT_BASIS_CONSTANTS_H_

#include "simd/order.h"

namespace gaunt {

inline constexpr double kPi = 3.14159265358979323846;

// Newton's iteration; std::sqrt is not a constant expression.
constexpr double ConstexprSqrt(double x) {
  if (x <= 0.0) return 0.0;
  double root = x > 1.0 ? x : 1.0;
  for (double before = 0.0; root != before;) {
    before = root;
    const double next = 0.5 * (root + x / root);
    if (next >= root) break;  // converged from above
    root = next;
  }
  return root;
}

namespace basis {

// Weights of bands: none.
struct UnitBands {
  static constexpr double Band(int) { return 1.0; }
};

// y_m^m = kSectoral<m> Re (x + i y)^m, y_m^-m = kSectoral<m> Im (x + i y)^m: the sign (-1)^m of the
// Condon-Shortley phase, sqrt(2) for m > 0, and K_m^m (2m-1)!!.
constexpr double Sectoral(int m) {
  double squared = 1.0 / (4.0 * kPi);
  for (int i = 1; i <= m; ++i) squared *= (2.0 * i + 1.0) / (2.0 * i);
  const double value = ConstexprSqrt(m == 0 ? squared : 2.0 * squared);
  return m % 2 == 0 ? value : -value;
}

// q_l^m = a_lm z q_{l-1}^m - a_lm b_lm q_{l-2}^m
constexpr double StepForward(int l, int m) {
  return ConstexprSqrt((4.0 * l * l - 1.0) / (1.0 * l * l - 1.0 * m * m));
}
constexpr double StepBackward(int l, int m) {
  const double below = l - 1.0;
  return ConstexprSqrt((below * below - 1.0 * m * m) / (4.0 * below * below - 1.0));
}

template <int m>
inline constexpr double kSectoral = Sectoral(m);
template <int l, int m>
inline constexpr double kStep = StepForward(l, m);
template <int l, int m>
inline constexpr double kStepBack = StepForward(l, m) * StepBackward(l, m);

// The first two steps of a column, where q_m^m is a constant:
//   q_{m+1} = kFirst z,   q_{m+2} = kSecondSquare z^2 + kSecondConstant.
template <int m>
inline constexpr double kFirst = Sectoral(m) * StepForward(m + 1, m);
template <int m>
inline constexpr double kSecondSquare = Sectoral(m) * StepForward(m + 1, m) * StepForward(m + 2, m);
template <int m>
inline constexpr double kSecondConstant = -Sectoral(m) * StepForward(m + 2, m) *
                                          StepBackward(m + 2, m);

// The same for every band up to order 64, for loops: the step to band l of column m < l is
// steps[StepIndex(l, m)].
struct Step {
  float forward;   // a_lm
  float backward;  // a_lm b_lm, which is a_lm / a_{l-1,m}; 0 where q_{l-2} does not exist
};
constexpr int StepIndex(int l, int m) { return l * (l - 1) / 2 + m; }

struct Bands {
  float sectoral[kMaxOrder];  // kSectoral
  Step steps[StepIndex(kMaxOrder, 0)];
  float ladder[StepIndex(kMaxOrder, 0)];  // sqrt((l - m) (l + m + 1)) / 2, between m and m + 1
};
constexpr Bands MakeBands() {
  Bands bands = {};
  double forward_below[kMaxOrder] = {};
  for (int l = 0; l < kMaxOrder; ++l) {
    bands.sectoral[l] = static_cast<float>(Sectoral(l));
    for (int m = 0; m < l; ++m) {
      const double forward = StepForward(l, m);
      const double backward = m + 1 < l ? forward / forward_below[m] : 0.0;
      bands.steps[StepIndex(l, m)] = {static_cast<float>(forward), static_cast<float>(backward)};
      bands.ladder[StepIndex(l, m)] =
          static_cast<float>(0.5 * ConstexprSqrt((l - m) * (l + m + 1.0)));
      forward_below[m] = forward;
    }
  }
  return bands;
}
inline constexpr Bands kBands = MakeBands();

}  // namespace basis
}  // namespace gaunt

#endif  // GAUNT_BASIS_CONSTANTS_H_
