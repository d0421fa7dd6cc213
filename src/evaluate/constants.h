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
using RadianceBands = basis::UnitBands;
struct IrradianceBands {
  static constexpr double Band(int l) { return CosineBand(l); }
};

// sum of Band(l) f_lm y_lm of order 3 as a polynomial of the direction (of E/pi: C0 to C4 of Sloan
// 2008, appendix A10, are kMean, kLinear, kProduct, -kOffset and kDifference).
template <class Quantity>
struct QuadraticConstants {
  static constexpr double kMean = Quantity::Band(0) * basis::kSectoral<0>;
  static constexpr double kLinear = Quantity::Band(1) * basis::kFirst<0>;
  static constexpr double kProduct = Quantity::Band(2) * 2.0 * basis::kSectoral<2>;
  static constexpr double kSquare = Quantity::Band(2) * basis::kSecondSquare<0>;
  static constexpr double kOffset = Quantity::Band(2) * basis::kSecondConstant<0>;
  static constexpr double kDifference = Quantity::Band(2) * basis::kSectoral<2>;
};

}  // namespace gaunt::evaluate

#endif  // GAUNT_EVALUATE_CONSTANTS_H_
