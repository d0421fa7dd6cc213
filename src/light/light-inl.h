// SPDX-License-Identifier: MIT
// Kernels that take lights out of SH coefficients.
#if defined(GAUNT_LIGHT_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_LIGHT_LIGHT_INL_H_
#undef GAUNT_LIGHT_LIGHT_INL_H_
#else
#define GAUNT_LIGHT_LIGHT_INL_H_
#endif

#include "basis/basis-inl.h"
#include "light/constants.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::light::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Optimal linear direction: the normalised gradient (-f_1,1, -f_1,-1, f_1,0) of the channels'
// weighted sum. Squares neither overflow nor vanish: extreme vectors are first scaled by a power of
// two. Where there is no direction, or no number, the result is +z.
struct Direction {
  size_t coefficients;
  size_t channels;
  const float* weights;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    using V = typename K::V;
    V mean = k(0.0), x = k(0.0), y = k(0.0), z = k(0.0);
    for (size_t c = 0; c < channels; ++c) {
      const V weight = k(static_cast<double>(weights[c]));
      const auto f = in.From(c * coefficients);
      mean = MulAdd(weight, f(0), mean);
      y = NegMulAdd(weight, f(1), y);
      z = MulAdd(weight, f(2), z);
      x = NegMulAdd(weight, f(3), x);
    }
    constexpr double kTiny = 0x1p-40, kHuge = 0x1p60, kScale = 0x1p80;
    const V largest = Max(Max(Abs(x), Abs(y)), Abs(z));
    const V scale = IfThenElse(Lt(largest, k(kTiny)), k(kScale),
                               IfThenElse(Gt(largest, k(kHuge)), k(1.0 / kScale), k(1.0)));
    x = Mul(x, scale);
    y = Mul(y, scale);
    z = Mul(z, scale);
    const V length = Sqrt(MulAdd(x, x, MulAdd(y, y, Mul(z, z))));
    const V noise = Mul(k(kNoDirection), Mul(Abs(mean), scale));
    const auto known = And(Gt(length, noise), Lt(length, k(kHuge * kHuge)));
    const V inverse = Div(k(1.0), length);
    out(0, IfThenElseZero(known, Mul(x, inverse)));
    out(1, IfThenElseZero(known, Mul(y, inverse)));
    out(2, IfThenElse(known, Mul(z, inverse), k(1.0)));
  }
};

// Least-squares colour of one light at a given direction, and of the ambient light that is left,
// both kept at or above zero (Fit in light/constants.h).
template <int n, class Quantity>
struct Extract {
  using Constants = Fit<n, Quantity>;
  size_t channels;

  template <class K, class In, class InD, class OutC, class OutA>
  GAUNT_LANES void operator()(const K& k, const In& in, const InD& direction, const OutC& colours,
                              const OutA& ambient) const {
    using V = typename K::V;
    typename K::template Slots<NumCoefficients(n)> y;
    basis::HWY_NAMESPACE::Eval<n>()(k, direction, y);
    for (size_t c = 0; c < channels; ++c) {
      const auto f = in.From(c * NumCoefficients(n));
      const V mean = f(0);
      const V fitted = AtLeastZero(k, BandSum<1>(k, f, y));
      const V left = NegMulAdd(k(Constants::kMean), fitted, mean);
      const V alone =
          AtLeastZero(k, MulAdd(k(Constants::kAlone), fitted, Mul(k(Constants::kAloneMean), mean)));
      colours(c, IfThenElse(Lt(left, k(0.0)), alone, fitted));
      ambient(c, AtLeastZero(k, Mul(k(1.0 / kAmbient), left)));
    }
  }

 private:
  // Zero for NaN too.
  template <class K, class V>
  static GAUNT_LANES V AtLeastZero(const K& k, V v) {
    return IfThenElseZero(Gt(v, k(0.0)), v);
  }

  // sum over bands l.. of Band(l) sum_m y_lm f_lm
  template <int l, class K, class In, class Slots>
  static GAUNT_LANES typename K::V BandSum(const K& k, const In& f, const Slots& y) {
    constexpr double kBand = Constants::Band(l);
    constexpr int kFirst = CoefficientIndex(l, -l);
    const auto dot = Dot<kFirst + 1, CoefficientIndex(l, l)>(f, y, Mul(y(kFirst), f(kFirst)));
    if constexpr (l + 1 == n) {
      return Mul(k(kBand), dot);
    } else if constexpr (Constants::Band(l + 1) == 0.0 && l + 2 == n) {
      return Mul(k(kBand), dot);
    } else if constexpr (Constants::Band(l + 1) == 0.0) {
      return MulAdd(k(kBand), dot, BandSum<l + 2>(k, f, y));
    } else {
      return MulAdd(k(kBand), dot, BandSum<l + 1>(k, f, y));
    }
  }

  template <int i, int last, class In, class Slots, class V>
  static GAUNT_LANES V Dot(const In& f, const Slots& y, V sum) {
    if constexpr (i > last) {
      return sum;
    } else {
      return Dot<i + 1, last>(f, y, MulAdd(y(i), f(i), sum));
    }
  }
};

}  // namespace gaunt::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_LIGHT_LIGHT_INL_H_
