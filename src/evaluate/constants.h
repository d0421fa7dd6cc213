// SPDX-License-Identifier: MIT
// The clamped-cosine kernel per band, and the constants of the order-3 irradiance polynomial.
#ifndef GAUNT_EVALUATE_CONSTANTS_H_
#define GAUNT_EVALUATE_CONSTANTS_H_

#include "basis/constants.h"

namespace gaunt::evaluate {

// A_l / pi, the factor of band l from radiance to E/pi: 1, 2/3, 1/4, 0, -1/24, 0, 1/64 ...
// (Ramamoorthi and Hanrahan 2001), by A_{l+2} = -A_l (l-1)/(l+4).
constexpr double CosineBand(int l) {
  if (l == 1) return 2.0 / 3.0;
  if (l % 2 == 1) return 0.0;
  double factor = 1.0;
  for (int k = 0; k < l; k += 2) factor *= -(k - 1.0) / (k + 4.0);
  return factor;
}

// What a sum over bands weights them by.
struct RadianceBands {
  static constexpr double Band(int) { return 1.0; }
};
struct IrradianceBands {
  static constexpr double Band(int l) { return CosineBand(l); }
};

// E/pi of order 3 as a polynomial of the normal (Sloan 2008, appendix A10).
inline constexpr double kRootPi = ConstexprSqrt(kPi);
inline constexpr double kC0 = 1.0 / (2.0 * kRootPi);
inline constexpr double kC1 = ConstexprSqrt(3.0) / (3.0 * kRootPi);
inline constexpr double kC2 = ConstexprSqrt(15.0) / (8.0 * kRootPi);
inline constexpr double kC3 = ConstexprSqrt(5.0) / (16.0 * kRootPi);
inline constexpr double kC4 = 0.5 * kC2;

}  // namespace gaunt::evaluate

#endif  // GAUNT_EVALUATE_CONSTANTS_H_
