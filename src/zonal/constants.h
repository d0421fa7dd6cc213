// SPDX-License-Identifier: MIT
// The factor of band l between a zonal function's coefficient and those of the function turned.
#ifndef GAUNT_ZONAL_CONSTANTS_H_
#define GAUNT_ZONAL_CONSTANTS_H_

#include "basis/constants.h"

namespace gaunt::zonal {

// sqrt(4 pi / (2l+1)), as weights of bands: the addition theorem turns sum of z_l y_l0 to d as
// sum of z_l Band(l) y_lm(d), and convolution multiplies by h_l Band(l).
struct ZonalBands {
  static constexpr double Band(int l) { return ConstexprSqrt(4.0 * kPi / (2.0 * l + 1.0)); }
};

// The same for loops, and the bands of coefficients.
struct Tables {
  float factor[kMaxOrder];
  unsigned char band[NumCoefficients(kMaxOrder)];
};
constexpr Tables MakeTables() {
  Tables tables = {};
  for (int l = 0; l < kMaxOrder; ++l) {
    tables.factor[l] = static_cast<float>(ZonalBands::Band(l));
    for (int m = -l; m <= l; ++m) {
      tables.band[CoefficientIndex(l, m)] = static_cast<unsigned char>(l);
    }
  }
  return tables;
}
inline constexpr Tables kTables = MakeTables();

}  // namespace gaunt::zonal

#endif  // GAUNT_ZONAL_CONSTANTS_H_
