// SPDX-License-Identifier: MIT
// The Gaunt coefficients of the real basis, the integrals over the sphere of three of its functions,
// computed at compile time by quadrature that is exact for them.
#ifndef GAUNT_PRODUCT_TENSOR_H_
#define GAUNT_PRODUCT_TENSOR_H_

#include "product/quadrature.h"

namespace gaunt::product {

// Degrees of two factors and of the product: a triangle whose sides sum up to an even number.
constexpr bool DegreesCouple(int l1, int l2, int l3) {
  return l1 <= l2 + l3 && l2 <= l1 + l3 && l3 <= l1 + l2 && (l1 + l2 + l3) % 2 == 0;
}

class PolarTensor {
 public:
  constexpr PolarTensor() {
    constexpr Rule kRule(kMaxDegree);
    const PolarRecurrence recurrence;
    for (int i = 0; i < kNodes; ++i) {
      const bool is_pole = i == kRule.pairs;
      weight_[i] = 2.0 * (is_pole ? kRule.pole_weight : kRule.weight[i]);
      at_[i] = recurrence.At(is_pole ? 1.0 : kRule.z[i]);
    }
  }

  // The integral over z of three polar parts, l1 + l2 + l3 and m1 + m2 + m3 even, m >= 0.
  constexpr double Integral(int l1, int m1, int l2, int m2, int l3, int m3) const {
    double sum = 0.0;
    for (int i = 0; i < kNodes; ++i) {
      const double* const part = at_[i].part;
      sum += weight_[i] * part[PolarIndex(l1, m1)] * part[PolarIndex(l2, m2)] *
             part[PolarIndex(l3, m3)];
    }
    return sum;
  }

 private:
  static_assert(kMaxDegree / 2 % 2 == 0, "no node on the equator");
  static constexpr int kNodes = kMaxPairs + 1;
  double weight_[kNodes] = {};
  PolarParts at_[kNodes];
};
inline constexpr PolarTensor kPolarTensor;

// The integral over phi of three functions cos(m phi), or sin(|m| phi) for m < 0.
constexpr double AzimuthIntegral(int m1, int m2, int m3) {
  const int sines = (m1 < 0 ? 1 : 0) + (m2 < 0 ? 1 : 0) + (m3 < 0 ? 1 : 0);
  if (sines % 2 != 0) return 0.0;
  const auto size = [](int m) { return m < 0 ? -m : m; };
  const int a = size(m1), b = size(m2), c = size(m3);
  const int zeros = (a == 0 ? 1 : 0) + (b == 0 ? 1 : 0) + (c == 0 ? 1 : 0);
  if (zeros == 3) return 2.0 * kPi;
  // One is the sum of the others; two sines are negative where that one is the cosine.
  if (a == b + c) return (zeros != 0 ? 1.0 : sines == 2 && m1 >= 0 ? -0.5 : 0.5) * kPi;
  if (b == a + c) return (zeros != 0 ? 1.0 : sines == 2 && m2 >= 0 ? -0.5 : 0.5) * kPi;
  if (c == a + b) return (zeros != 0 ? 1.0 : sines == 2 && m3 >= 0 ? -0.5 : 0.5) * kPi;
  return 0.0;
}

// The integral of y_l1,m1 y_l2,m2 y_l3,m3 over the sphere; the sum of degrees is at most kMaxDegree.
// Exactly 0 where it vanishes.
constexpr double Gaunt(int l1, int m1, int l2, int m2, int l3, int m3) {
  const double azimuth = AzimuthIntegral(m1, m2, m3);
  if (azimuth == 0.0 || !DegreesCouple(l1, l2, l3)) return 0.0;
  const auto size = [](int m) { return m < 0 ? -m : m; };
  const double value = azimuth * kPolarTensor.Integral(l1, size(m1), l2, size(m2), l3, size(m3));
  return value < 1e-12 && value > -1e-12 ? 0.0 : value;  // a few vanish by accident
}

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_TENSOR_H_
