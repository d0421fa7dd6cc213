// SPDX-License-Identifier: MIT
// Kernels that evaluate, combine and blend SH coefficients.
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

// sum of f_lm y_lm for each channel, over the bands whose weight is not zero; y carries the weights.
template <int n, class Quantity>
struct SumChannels {
  size_t channels;

  template <class K, class InF, class InY, class Out>
  GAUNT_LANES void operator()(const K&, const InF& f, const InY& y, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      const auto channel = f.From(c * NumCoefficients(n));
      out(c, Sum<1>(channel, y, Mul(y(0), channel(0))));
    }
  }

 private:
  template <int i, class InF, class InY, class V>
  static GAUNT_LANES V Sum(const InF& f, const InY& y, V sum) {
    if constexpr (i == NumCoefficients(n)) {
      return sum;
    } else if constexpr (Quantity::Band(BandOf(i)) == 0.0) {
      return Sum<i + 1>(f, y, sum);
    } else {
      return Sum<i + 1>(f, y, MulAdd(y(i), f(i), sum));
    }
  }
};

// sum_lm Quantity::Band(l) f_lm y_lm for each channel. The weighted basis is evaluated once and kept
// in slots.
template <int n, class Quantity>
struct Evaluate {
  size_t channels;

  template <class K, class InF, class InD, class Out>
  GAUNT_LANES void operator()(const K& k, const InF& f, const InD& direction,
                              const Out& out) const {
    typename K::template Slots<NumCoefficients(n)> y;
    basis::HWY_NAMESPACE::Eval<n, Quantity>()(k, direction, y);
    SumChannels<n, Quantity>{channels}(k, f, y, out);
  }
};

// Planes of a Quadratic, in the order of the float4 of Constants.
enum QuadraticPlane { kX, kY, kZ, kOne, kXY, kYZ, kZZ, kZX, kXXYY, kQuadraticPlanes };

// sum_lm Quantity::Band(l) f_lm y_lm of order 3 as a polynomial of the direction: planes of
// (x, y, z, 1), (xy, yz, zz, zx) and xx - yy.
template <class Quantity>
struct Quadratic {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& f, const Out& a, const Out& b,
                              const Out& c) const {
    using C = QuadraticConstants<Quantity>;
    const auto f6 = f(6);
    a(0, Mul(k(-C::kLinear), f(3)));
    a(1, Mul(k(-C::kLinear), f(1)));
    a(2, Mul(k(C::kLinear), f(2)));
    a(3, MulAdd(k(C::kOffset), f6, Mul(k(C::kMean), f(0))));
    b(0, Mul(k(C::kProduct), f(4)));
    b(1, Mul(k(-C::kProduct), f(5)));
    b(2, Mul(k(C::kSquare), f6));
    b(3, Mul(k(-C::kProduct), f(7)));
    c(0, Mul(k(C::kDifference), f(8)));
  }
};

// The polynomials of each channel, plane after plane.
template <class Quantity>
struct Quadratics {
  size_t channels;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& f, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      const auto channel = out.From(kQuadraticPlanes * c);
      Quadratic<Quantity>()(k, f.From(9 * c), channel.From(kX), channel.From(kXY),
                            channel.From(kXXYY));
    }
  }
};

// Values of one item's polynomials, by nested multiplication. The item is part of the kernel, so that
// a loop over directions keeps it in registers.
template <int kChannels>
struct EvaluateQuadratics {
  float item[kChannels * kQuadraticPlanes];

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, const Out& out) const {
    Channel<0>(k, direction(0), direction(1), direction(2), out);
  }

 private:
  template <int c, class K, class V, class Out>
  GAUNT_LANES void Channel(const K& k, V x, V y, V z, const Out& out) const {
    if constexpr (c < kChannels) {
      const float* const p = item + c * kQuadraticPlanes;
      const V difference = k(p[kXXYY]);
      V value = MulAdd(z, MulAdd(z, k(p[kZZ]), k(p[kZ])), k(p[kOne]));
      value = MulAdd(x, MulAdd(x, difference, MulAdd(y, k(p[kXY]), MulAdd(z, k(p[kZX]), k(p[kX])))),
                     value);
      value = MulAdd(y, NegMulAdd(y, difference, MulAdd(z, k(p[kYZ]), k(p[kY]))), value);
      out(c, value);
      Channel<c + 1>(k, x, y, z, out);
    }
  }
};

// Radiance of order 3, RGB, to 7 float4 that a shader dots with (n, 1), (xy, yz, zz, zx) and
// x^2 - y^2: E/pi of a normal n.
struct Constants {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& f, const Out& out) const {
    for (size_t c = 0; c < 3; ++c) {
      Quadratic<IrradianceBands>()(k, f.From(9 * c), out.From(4 * c), out.From(12 + 4 * c),
                                   out.From(24 + c));
    }
    out(27, k(1.0));
  }
};

// Radiance of order 3 to the symmetric 4x4 matrix M of each channel, row by row, for which
// E/pi = (n, 1) M (n, 1) (Ramamoorthi and Hanrahan 2001).
struct Matrix {
  size_t channels;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& f, const Out& out) const {
    typename K::template Slots<kQuadraticPlanes> p;
    for (size_t c = 0; c < channels; ++c) {
      Quadratic<IrradianceBands>()(k, f.From(9 * c), Part<decltype(p)>{p, kX},
                                   Part<decltype(p)>{p, kXY}, Part<decltype(p)>{p, kXXYY});
      const auto m = out.From(16 * c);
      const auto half = k(0.5);
      Both(m, 0, 1, Mul(half, p(kXY)));
      Both(m, 0, 2, Mul(half, p(kZX)));
      Both(m, 1, 2, Mul(half, p(kYZ)));
      Both(m, 0, 3, Mul(half, p(kX)));
      Both(m, 1, 3, Mul(half, p(kY)));
      Both(m, 2, 3, Mul(half, p(kZ)));
      m(0, p(kXXYY));
      m(5, Neg(p(kXXYY)));
      m(10, p(kZZ));
      m(15, p(kOne));
    }
  }

 private:
  template <class Slots>
  struct Part {
    Slots& slots;
    size_t first;
    template <class V>
    GAUNT_LANES void operator()(size_t p, V v) const {
      slots(first + p, v);
    }
  };
  template <class Out, class V>
  static GAUNT_LANES void Both(const Out& m, size_t row, size_t column, V v) {
    m(4 * row + column, v);
    m(4 * column + row, v);
  }
};

// sum over planes of a b, in four sums that do not wait for each other.
struct Dot {
  size_t planes;

  template <class K, class InA, class InB>
  GAUNT_LANES typename K::V operator()(const K& k, const InA& a, const InB& b) const {
    using V = typename K::V;
    V s0 = k(0.0), s1 = s0, s2 = s0, s3 = s0;
    size_t p = 0;
    for (; p + 4 <= planes; p += 4) {
      s0 = MulAdd(a(p), b(p), s0);
      s1 = MulAdd(a(p + 1), b(p + 1), s1);
      s2 = MulAdd(a(p + 2), b(p + 2), s2);
      s3 = MulAdd(a(p + 3), b(p + 3), s3);
    }
    for (; p < planes; ++p) s0 = MulAdd(a(p), b(p), s0);
    return Add(Add(s0, s1), Add(s2, s3));
  }
};

// Adds weight times the dot product of a band's planes to `sum`.
struct AddDot {
  size_t planes;
  double weight;

  template <class K, class InA, class InB, class InSum, class OutSum>
  GAUNT_LANES void operator()(const K& k, const InA& a, const InB& b, const InSum& before,
                              const OutSum& sum) const {
    sum(0, MulAdd(k(weight), Dot{planes}(k, a, b), before(0)));
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
