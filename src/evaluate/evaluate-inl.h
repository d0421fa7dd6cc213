// SPDX-License-Identifier: MIT
// Kernels that evaluate and blend SH coefficients.
#if defined(GAUNT_EVALUATE_EVALUATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_EVALUATE_EVALUATE_INL_H_
#undef GAUNT_EVALUATE_EVALUATE_INL_H_
#else
#define GAUNT_EVALUATE_EVALUATE_INL_H_
#endif

#include "basis/basis-inl.h"
#include "evaluate/constants.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::evaluate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// sum_lm Quantity::Band(l) f_lm y_lm for each channel. The basis is evaluated once, scaled by the
// band's factor where there is one, and kept in slots; bands whose factor is zero are left out.
template <int n, class Quantity>
struct Evaluate {
  size_t channels;

  template <class K, class InF, class InD, class Out>
  GAUNT_LANES void operator()(const K& k, const InF& f, const InD& direction,
                              const Out& out) const {
    typename K::template Slots<NumCoefficients(n)> y;
    basis::HWY_NAMESPACE::Eval<n>()(k, direction, y);
    Scale<0>(k, y);
    for (size_t c = 0; c < channels; ++c) {
      const auto channel = f.From(c * NumCoefficients(n));
      out(c, Sum<1>(channel, y, Mul(y(0), channel(0))));
    }
  }

 private:
  static constexpr int Band(int i) {
    int l = 0;
    while ((l + 1) * (l + 1) <= i) ++l;
    return l;
  }

  template <int i, class K, class Slots>
  static GAUNT_LANES void Scale(const K& k, Slots& y) {
    if constexpr (i < NumCoefficients(n)) {
      constexpr double kBand = Quantity::Band(Band(i));
      if constexpr (kBand != 0.0 && kBand != 1.0) y(i, Mul(k(kBand), y(i)));
      Scale<i + 1>(k, y);
    }
  }

  template <int i, class InF, class Slots, class V>
  static GAUNT_LANES V Sum(const InF& f, const Slots& y, V sum) {
    if constexpr (i == NumCoefficients(n)) {
      return sum;
    } else if constexpr (Quantity::Band(Band(i)) == 0.0) {
      return Sum<i + 1>(f, y, sum);
    } else {
      return Sum<i + 1>(f, y, MulAdd(y(i), f(i), sum));
    }
  }
};

// Radiance of order 3, RGB, to 7 float4 that a shader dots with (n, 1), (xy, yz, zz, zx) and
// x^2 - y^2: E/pi of a normal n.
struct Constants {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& f, const Out& out) const {
    for (size_t c = 0; c < 3; ++c) {
      const auto l = f.From(9 * c);
      const auto a = out.From(4 * c), b = out.From(12 + 4 * c);
      const auto l6 = l(6);
      a(0, Mul(k(-kC1), l(3)));
      a(1, Mul(k(-kC1), l(1)));
      a(2, Mul(k(kC1), l(2)));
      a(3, MulAdd(k(-kC3), l6, Mul(k(kC0), l(0))));
      b(0, Mul(k(kC2), l(4)));
      b(1, Mul(k(-kC2), l(5)));
      b(2, Mul(k(3.0 * kC3), l6));
      b(3, Mul(k(-kC2), l(7)));
      out(24 + c, Mul(k(kC4), l(8)));
    }
    out(27, k(1.0));
  }
};

// (1 - t) a + t b, exactly a at t = 0 and exactly b at t = 1.
struct Blend {
  size_t planes;

  template <class K, class InA, class InB, class InT, class Out>
  GAUNT_LANES void operator()(const K&, const InA& a, const InB& b, const InT& t,
                              const Out& out) const {
    const auto weight = t(0);
    for (size_t p = 0; p < planes; ++p) {
      const auto from = a(p);
      out(p, MulAdd(weight, b(p), NegMulAdd(weight, from, from)));
    }
  }
};

}  // namespace gaunt::evaluate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_EVALUATE_EVALUATE_INL_H_
