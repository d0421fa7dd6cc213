// SPDX-License-Identifier: MIT
// Quadrature over the sphere that is exact for products of three SH functions with the fewest rows:
// Gauss-Lobatto nodes in z, where the poles cost one point each, times equispaced points in phi.
#ifndef GAUNT_PRODUCT_QUADRATURE_H_
#define GAUNT_PRODUCT_QUADRATURE_H_

#include "basis/constants.h"

namespace gaunt::product {

// cos(2 pi k / n) of integers, by its series below pi/4.
constexpr double CosineOfTurn(int k, int n) {
  k = (k % n + n) % n;
  if (2 * k > n) k = n - k;
  if (4 * k > n) return -CosineOfTurn(n - 2 * k, 2 * n);
  const bool is_sine = 8 * k > n;  // of the complement to a quarter turn
  const double x = 2.0 * kPi * (is_sine ? (n - 4 * k) / (4.0 * n) : static_cast<double>(k) / n);
  double sum = 0.0, term = is_sine ? x : 1.0;
  for (int i = is_sine ? 1 : 0; i < 26; i += 2) {
    sum += term;
    term *= -x * x / ((i + 1.0) * (i + 2.0));
  }
  return sum;
}

// The highest degrees: three functions of degrees that sum up to it.
inline constexpr int kMaxDegree = 36;
inline constexpr int kMaxPairs = kMaxDegree / 4;

// For integrands even in z, which are exact up to z^degree: odd ones vanish by symmetry. With
// q = degree / 2 + 1 conditions, a pair of nodes +-z meets two, the poles one, and the equator one.
struct Rule {
  int pairs = 0;
  bool equator = false;
  double z[kMaxPairs] = {};
  double weight[kMaxPairs] = {};  // of each node of a pair; all weights of the sphere sum up to 2
  double equator_weight = 0.0;
  double pole_weight = 0.0;

  constexpr Rule() = default;
  // Roots of P'_k, k + 1 being the nodes, by Newton's iteration from those of Chebyshev's U_{k-1}.
  constexpr explicit Rule(int degree)
      : pairs(degree / 4), equator(degree / 2 % 2 != 0), pole_weight(1.0) {
    const int k = 2 * pairs + (equator ? 1 : 0) + 1;
    const double scale = 2.0 / (k * (k + 1.0));
    pole_weight = scale;
    if (equator) {
      const Legendre at(k, 0.0);
      equator_weight = scale / (at.value * at.value);
    }
    for (int i = 0; i < pairs; ++i) {
      double x = CosineOfTurn(pairs - i, 2 * k);
      for (int step = 0; step < 8; ++step) {
        const Legendre at(k, x);
        // (1 - x^2) P'' = 2 x P' - k (k + 1) P
        x -= at.slope * (1.0 - x * x) / (2.0 * x * at.slope - k * (k + 1.0) * at.value);
      }
      const Legendre at(k, x);
      z[i] = x;
      weight[i] = scale / (at.value * at.value);
    }
  }

 private:
  struct Legendre {
    double value = 1.0, slope = 0.0;
    constexpr Legendre(int k, double x) {
      double below = 0.0;
      for (int i = 1; i <= k; ++i) {
        const double next = ((2 * i - 1) * x * value - (i - 1) * below) / i;
        below = value;
        value = next;
      }
      slope = k * (below - x * value) / (1.0 - x * x);
    }
  };
};

// The polar parts of the basis at one z: y_l^m = part cos(m phi), y_l^-m = part sin(m phi).
constexpr int PolarIndex(int l, int m) { return l * (l + 1) / 2 + m; }
inline constexpr int kPolarOrder = kMaxDegree / 2 + 1;
struct PolarParts {
  double part[PolarIndex(kPolarOrder, 0)] = {};
};

// For many z: the constants of the recurrence are found once.
class PolarRecurrence {
 public:
  constexpr PolarRecurrence() {
    for (int m = 0; m < kPolarOrder; ++m) {
      sectoral_[m] = basis::Sectoral(m);
      for (int l = m + 1; l < kPolarOrder; ++l) {
        forward_[PolarIndex(l, m)] = basis::StepForward(l, m);
        backward_[PolarIndex(l, m)] =
            l > m + 1 ? forward_[PolarIndex(l, m)] * basis::StepBackward(l, m) : 0.0;
      }
    }
  }

  constexpr PolarParts At(double z) const {
    const double sine = ConstexprSqrt((1.0 - z) * (1.0 + z));
    PolarParts at;
    double power = 1.0;
    for (int m = 0; m < kPolarOrder; ++m, power *= sine) {
      double below = 0.0, value = sectoral_[m] * power;
      at.part[PolarIndex(m, m)] = value;
      for (int l = m + 1; l < kPolarOrder; ++l) {
        const double next =
            forward_[PolarIndex(l, m)] * z * value - backward_[PolarIndex(l, m)] * below;
        below = value;
        value = next;
        at.part[PolarIndex(l, m)] = value;
      }
    }
    return at;
  }

 private:
  double sectoral_[kPolarOrder] = {};
  double forward_[PolarIndex(kPolarOrder, 0)] = {};
  double backward_[PolarIndex(kPolarOrder, 0)] = {};
};

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_QUADRATURE_H_
