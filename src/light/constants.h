// SPDX-License-Identifier: MIT
// Normalisations of lights in SH (Sloan 2008, appendix A5, for every order).
#ifndef GAUNT_LIGHT_CONSTANTS_H_
#define GAUNT_LIGHT_CONSTANTS_H_

#include "basis/constants.h"
#include "evaluate/constants.h"

namespace gaunt::light {

// P_k(0)
constexpr double LegendreAtZero(int k) {
  if (k % 2 == 1) return 0.0;
  double value = 1.0;
  for (int i = 0; i < k; i += 2) value *= -(i + 1.0) / (i + 2.0);
  return value;
}

// The directional light c_n y(d) reflects E/pi = 1 at its own direction when truncated to order n.
constexpr double DirectionalNorm(int n) {
  if (n == 1) return 4.0 * kPi;
  return kPi / (1.0 - (LegendreAtZero(n - 1) / (n + 1.0) + LegendreAtZero(n - 2) / n) / 2.0);
}

inline constexpr double kY0 = 0.5 / ConstexprSqrt(kPi);       // y_00
inline constexpr double kAmbient = 2.0 * ConstexprSqrt(kPi);  // f_00 of radiance 1

// Below this share of the mean, the linear band holds rounding noise instead of a direction.
inline constexpr double kNoDirection = 1e-5;

inline constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};  // Rec. 709

// Constants of the least-squares fit of one light of order n and an ambient light, with each band
// weighted by band(l): the clamped cosine for irradiance, 1 for radiance.
template <int n, class Quantity>
struct Fit {
  static constexpr double kNorm = DirectionalNorm(n);
  static constexpr double Energy() {  // |light|^2 without its mean
    double sum = 0.0;
    for (int l = 1; l < n; ++l) {
      sum += (2.0 * l + 1.0) / (4.0 * kPi) * Quantity::Band(l) * Quantity::Band(l);
    }
    return sum * kNorm * kNorm;
  }
  // Colour = sum over l > 0 of kBand(l) sum_m y_lm(d) f_lm.
  static constexpr double Band(int l) {
    return Quantity::Band(l) * Quantity::Band(l) * kNorm / Energy();
  }
  // Mean of the light of colour 1, in f_00.
  static constexpr double kMean = kNorm * kY0;
  // Colour when no ambient light is left: kAlone * colour + kAloneMean * f_00.
  static constexpr double kAlone = Energy() / (Energy() + kMean * kMean);
  static constexpr double kAloneMean = kMean / (Energy() + kMean * kMean);
};

}  // namespace gaunt::light

#endif  // GAUNT_LIGHT_CONSTANTS_H_
