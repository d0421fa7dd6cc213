// SPDX-License-Identifier: MIT
// Sparse products: step by step as plans.h has it. For low orders, where it has the fewest
// operations.
#if defined(GAUNT_PRODUCT_SPARSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_SPARSE_INL_H_
#undef GAUNT_PRODUCT_SPARSE_INL_H_
#else
#define GAUNT_PRODUCT_SPARSE_INL_H_
#endif

#include <utility>

#include "product/plans.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

template <int kA, int kB, int kOut, const auto& kSteps, Factors factors>
struct Sparse {
  template <class K, class InA, class InB, class Out>
  GAUNT_LANES void operator()(const K& k, const InA& a, const InB& b, const Out& out) const {
    typename K::template Slots<NumCoefficients(kOut)> sums;
    typename K::template Slots<4 * kPlan.NumPlaces() + 1> kept;
    BandZero(k, a, b, sums);
    Steps(k, a, b, kept, sums, std::make_integer_sequence<int, StepPlan::kCount>());
    Copy(sums, out, std::make_integer_sequence<int, NumCoefficients(kOut)>());
  }
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    static_assert(factors == Factors::kSame, "a factor is missing");
    (*this)(k, in, in, out);
  }

 private:
  using StepPlan = Plan<kSteps, factors>;
  static constexpr StepPlan kPlan = {};
  static constexpr int kPlanesA = NumCoefficients(kA), kPlanesB = NumCoefficients(kB);
  static constexpr int kPlanesOut = NumCoefficients(kOut);
  static constexpr double kY00 = 0.5 / ConstexprSqrt(kPi);
  static constexpr bool kSame = factors == Factors::kSame;

  template <class S, class Out, int... i>
  static GAUNT_LANES void Copy(const S& sums, const Out& out, std::integer_sequence<int, i...>) {
    (out(i, sums(i)), ...);
  }

  // Band 0 takes part with one constant: what is multiplied by it, and what it is multiplied from.
  template <class K, class InA, class InB, class S>
  static GAUNT_LANES void BandZero(const K& k, const InA& a, const InB& b, S& sums) {
    const auto scaled_a = Mul(k(kSame ? 2.0 * kY00 : kY00), a(0));
    if constexpr (kSame) {
      const auto squares = Dot<0>(a, a);
      sums(0, Mul(k(kY00), squares));
      BandZeroOne(scaled_a, scaled_a, a, b, sums,
                  std::make_integer_sequence<int, kPlanesOut - 1>());
    } else {
      const auto scaled_b = Mul(k(kY00), b(0));
      if constexpr (kPlanesA > 1 && kPlanesB > 1) {
        const auto dot = Dot<1>(a, b);
        sums(0, MulAdd(k(kY00), dot, Mul(scaled_a, b(0))));
      } else {
        sums(0, Mul(scaled_a, b(0)));
      }
      BandZeroOne(scaled_a, scaled_b, a, b, sums,
                  std::make_integer_sequence<int, kPlanesOut - 1>());
    }
  }
  // The sum of products of coefficients from i on. Long ones go in four parts, whose rounding errors
  // add up to less.
  template <int i, class InA, class InB>
  static GAUNT_LANES auto Dot(const InA& a, const InB& b) {
    if constexpr (kProducts > 16) {
      return Add(Add(Part<i, 4>(a, b), Part<i + 1, 4>(a, b)),
                 Add(Part<i + 2, 4>(a, b), Part<i + 3, 4>(a, b)));
    } else {
      return Part<i, 1>(a, b);
    }
  }
  static constexpr int kProducts = kPlanesA < kPlanesB ? kPlanesA : kPlanesB;
  template <int i, int step, class InA, class InB>
  static GAUNT_LANES auto Part(const InA& a, const InB& b) {
    return Rest<i + step, step>(a, b, Mul(a(i), b(i)));
  }
  template <int i, int step, class InA, class InB, class V>
  static GAUNT_LANES V Rest(const InA& a, const InB& b, V sum) {
    if constexpr (i < kProducts) {
      return Rest<i + step, step>(a, b, MulAdd(a(i), b(i), sum));
    } else {
      return sum;
    }
  }
  template <class V, class InA, class InB, class S, int... i>
  static GAUNT_LANES void BandZeroOne([[maybe_unused]] V scaled_a, [[maybe_unused]] V scaled_b,
                                      const InA& a, const InB& b, S& sums,
                                      std::integer_sequence<int, i...>) {
    (BandZeroTo<i + 1>(scaled_a, scaled_b, a, b, sums), ...);
  }
  template <int i, class V, class InA, class InB, class S>
  static GAUNT_LANES void BandZeroTo(V scaled_a, [[maybe_unused]] V scaled_b,
                                     [[maybe_unused]] const InA& a, const InB& b, S& sums) {
    static_assert(kA <= kB && kOut <= kB, "orders that plans do not have");
    if constexpr (!kSame && i < kPlanesA) {
      sums(i, MulAdd(a(i), scaled_b, Mul(scaled_a, b(i))));
    } else {
      sums(i, Mul(scaled_a, b(i)));
    }
  }

  template <class K, class InA, class InB, class T, class S, int... i>
  static GAUNT_LANES void Steps(const K& k, const InA& a, const InB& b, T& kept, S& sums,
                                std::integer_sequence<int, i...>) {
    (One<i>(k, a, b, kept, sums), ...);
  }
  template <int i, class K, class InA, class InB, class T, class S>
  static GAUNT_LANES void One(const K& k, const InA& a, const InB& b, T& kept, S& sums) {
    if constexpr (kSteps[i].Has(kForward)) Multiply<i>(k, a, b, sums);
    if constexpr (kSteps[i].IsBack()) BackOf<i>(k, a, b, kept, sums);
  }

  // Which z of a step there are, among those that are in the product where `to_product`.
  static constexpr bool Any(const Step& step, bool sums, bool complex_only, bool to_product) {
    for (int i = 0; i < step.count; ++i) {
      const Block z(step.z[i]);
      if (IsSum(step, i) == sums && (!complex_only || z.m > 0) && (!to_product || z.l < kOut)) {
        return true;
      }
    }
    return false;
  }

  // a_p b_q, and a_q b_p where both ways are one step.
  template <int p, int q, class InA, class InB>
  static GAUNT_LANES auto Pair(const InA& a, const InB& b) {
    if constexpr (StepPlan::kTwice && p != q) {
      return MulAdd(a(q), b(p), Mul(a(p), b(q)));
    } else {
      return Mul(a(p), b(q));
    }
  }
  // The same, added to or taken from a sum.
  template <int p, int q, class InA, class InB, class V>
  static GAUNT_LANES V AddPair(const InA& a, const InB& b, V sum) {
    sum = MulAdd(a(p), b(q), sum);
    if constexpr (StepPlan::kTwice && p != q) sum = MulAdd(a(q), b(p), sum);
    return sum;
  }
  template <int p, int q, class InA, class InB, class V>
  static GAUNT_LANES V SubPair(const InA& a, const InB& b, V sum) {
    sum = NegMulAdd(a(p), b(q), sum);
    if constexpr (StepPlan::kTwice && p != q) sum = NegMulAdd(a(q), b(p), sum);
    return sum;
  }

  // x y, as complex numbers; with the conjugate of the one of lower m where z's m is a difference.
  template <int i, class K, class InA, class InB, class S>
  static GAUNT_LANES void Multiply(const K& k, const InA& a, const InB& b, S& sums) {
    using V = typename K::V;
    constexpr Step kStep = kSteps[i];
    constexpr Block x(kStep.x), y(kStep.y);
    constexpr int xc = x.Cosine(), xs = x.Sine(), yc = y.Cosine(), ys = y.Sine();
    using Zs = std::make_integer_sequence<int, kStep.count>;
    if constexpr (x.m == 0 && y.m == 0) {
      const V real = Pair<xc, yc>(a, b);
      Scatter<i>(k, real, real, real, real, sums, Zs());
    } else if constexpr (x.m == 0) {
      const V real = Pair<xc, yc>(a, b), imaginary = Pair<xc, ys>(a, b);
      Scatter<i>(k, real, imaginary, real, imaginary, sums, Zs());
    } else if constexpr (y.m == 0) {
      const V real = Pair<xc, yc>(a, b), imaginary = Pair<xs, yc>(a, b);
      Scatter<i>(k, real, imaginary, real, imaginary, sums, Zs());
    } else {
      constexpr bool kSum = Any(kStep, true, false, true);
      constexpr bool kDifference = Any(kStep, false, false, true);
      constexpr bool kComplexDifference = Any(kStep, false, true, true);
      V real, imaginary, difference_real, difference_imaginary;
      const V cc = Pair<xc, yc>(a, b);
      if constexpr (kSum && kDifference) {
        const V ss = Pair<xs, ys>(a, b);
        real = Sub(cc, ss);
        difference_real = Add(cc, ss);
      } else if constexpr (kSum) {
        real = SubPair<xs, ys>(a, b, cc);
      } else {
        difference_real = AddPair<xs, ys>(a, b, cc);
      }
      if constexpr (kSum || kComplexDifference) {
        // Of the difference: the one of higher m by the conjugate of the other.
        constexpr bool kSelf = kStep.x == kStep.y && StepPlan::kTwice;
        V sc, cs;
        if constexpr (kSum && kComplexDifference) {
          sc = Pair<xs, yc>(a, b);
          cs = Pair<xc, ys>(a, b);
          imaginary = Add(sc, cs);
          difference_imaginary = x.m > y.m ? Sub(sc, cs) : Sub(cs, sc);
        } else if constexpr (kSum && kSelf) {
          imaginary = Pair<xs, yc>(a, b);  // both ways
        } else if constexpr (kSum) {
          imaginary = AddPair<xc, ys>(a, b, Pair<xs, yc>(a, b));
        } else if constexpr (x.m > y.m) {
          difference_imaginary = SubPair<xc, ys>(a, b, Pair<xs, yc>(a, b));
        } else {
          difference_imaginary = SubPair<xs, yc>(a, b, Pair<xc, ys>(a, b));
        }
      }
      Scatter<i>(k, real, imaginary, difference_real, difference_imaginary, sums, Zs());
    }
  }
  template <int i, class K, class V, class S, int... z>
  static GAUNT_LANES void Scatter(const K& k, const V& real, const V& imaginary,
                                  const V& difference_real, const V& difference_imaginary, S& sums,
                                  std::integer_sequence<int, z...>) {
    (ScatterTo<i, z>(k, real, imaginary, difference_real, difference_imaginary, sums), ...);
  }
  template <int i, int j, class K, class V, class S>
  static GAUNT_LANES void ScatterTo(const K& k, const V& real, const V& imaginary,
                                    const V& difference_real, const V& difference_imaginary,
                                    S& sums) {
    constexpr Block z(kSteps[i].z[j]);
    if constexpr (z.l < kOut) {
      constexpr double kFactor = kPlan.Forward(i, j);
      constexpr bool kSum = IsSum(kSteps[i], j);
      AddTo<z.Cosine()>(k(kFactor), kSum ? real : difference_real, sums);
      if constexpr (z.m > 0) {
        AddTo<z.Sine()>(k(kFactor), kSum ? imaginary : difference_imaginary, sums);
      }
    }
  }
  template <int p, class V, class S>
  static GAUNT_LANES void AddTo(V factor, V value, S& sums) {
    sums(p, MulAdd(factor, value, sums(p)));
  }

  // The sums over z of a factor: real and imaginary, where z's m is a sum, and where it is not.
  enum { kSumReal, kSumImaginary, kRestReal, kRestImaginary, kSumParts };

  template <int i, class K, class In, class S>
  static GAUNT_LANES void SumZ(const K& k, const In& in, S& parts) {
    AddZ<i, 0>(k, in, parts);
  }
  template <int i, int j, class K, class In, class S>
  static GAUNT_LANES void AddZ(const K& k, const In& in, S& parts) {
    if constexpr (j < kSteps[i].count) {
      constexpr bool kSum = IsSum(kSteps[i], j);
      constexpr Block z(kSteps[i].z[j]);
      constexpr double kFactor = kPlan.Back(i, j);
      PutTerm<IsFirst(i, j, kSum, false), kSum ? kSumReal : kRestReal>(k(kFactor), in(z.Cosine()),
                                                                       parts);
      if constexpr (z.m > 0) {
        PutTerm<IsFirst(i, j, kSum, true), kSum ? kSumImaginary : kRestImaginary>(
            k(kFactor), in(z.Sine()), parts);
      }
      AddZ<i, j + 1>(k, in, parts);
    }
  }
  static constexpr bool IsFirst(int i, int j, bool is_sum, bool complex_only) {
    for (int earlier = 0; earlier < j; ++earlier) {
      const Block z(kSteps[i].z[earlier]);
      if (IsSum(kSteps[i], earlier) == is_sum && (!complex_only || z.m > 0)) return false;
    }
    return true;
  }
  template <bool kFirst, int p, class V, class S>
  static GAUNT_LANES void PutTerm(V factor, V value, S& parts) {
    if constexpr (kFirst) {
      parts(p, Mul(factor, value));
    } else {
      parts(p, MulAdd(factor, value, parts(p)));
    }
  }

  template <int i, class K, class InA, class InB, class T, class S>
  static GAUNT_LANES void BackOf(const K& k, const InA& a, const InB& b, T& kept, S& sums) {
    typename K::template Slots<kSumParts> of_a, of_b;
    constexpr int kSource = kPlan.Source(i);
    if constexpr (kSource == i) {
      SumZ<i>(k, a, of_a);
      if constexpr (StepPlan::kTwice) SumZ<i>(k, b, of_b);
      if constexpr (kPlan.IsKept(i)) Keep<i, kPlan.Place(i)>(of_a, of_b, kept);
    } else {
      TakeOver<i, kPlan.Place(kSource)>(kept, of_a, of_b);
    }
    Spread<i>(of_a, b, sums);
    if constexpr (StepPlan::kTwice) Spread<i>(of_b, a, sums);
  }
  // A single z is a sum, or it is not: kept in two places.
  template <int i, int place, class S, class T>
  static GAUNT_LANES void Keep(const S& of_a, const S& of_b, T& kept) {
    constexpr bool kSum = IsSum(kSteps[i], 0), kComplex = Block(kSteps[i].z[0]).m > 0;
    kept(4 * place, of_a(kSum ? kSumReal : kRestReal));
    if constexpr (kComplex) kept(4 * place + 1, of_a(kSum ? kSumImaginary : kRestImaginary));
    if constexpr (StepPlan::kTwice) {
      kept(4 * place + 2, of_b(kSum ? kSumReal : kRestReal));
      if constexpr (kComplex) kept(4 * place + 3, of_b(kSum ? kSumImaginary : kRestImaginary));
    }
  }
  template <int i, int place, class T, class S>
  static GAUNT_LANES void TakeOver(const T& kept, S& of_a, S& of_b) {
    constexpr bool kSum = IsSum(kSteps[i], 0), kComplex = Block(kSteps[i].z[0]).m > 0;
    of_a(kSum ? kSumReal : kRestReal, kept(4 * place));
    if constexpr (kComplex) of_a(kSum ? kSumImaginary : kRestImaginary, kept(4 * place + 1));
    if constexpr (StepPlan::kTwice) {
      of_b(kSum ? kSumReal : kRestReal, kept(4 * place + 2));
      if constexpr (kComplex) of_b(kSum ? kSumImaginary : kRestImaginary, kept(4 * place + 3));
    }
  }

  // The sums of one factor times y to x, and times x to y, of the other.
  template <int i, class T, class In, class S>
  static GAUNT_LANES void Spread(const T& parts, const In& in, S& sums) {
    constexpr Step kStep = kSteps[i];
    constexpr Block x(kStep.x), y(kStep.y);
    constexpr bool kToY = kStep.Has(StepParts::kToY), kToX = kStep.Has(StepParts::kToX);
    if constexpr (x.m == 0 || y.m == 0) {
      // z has the m of the other one.
      constexpr bool kComplex = x.m > 0 || y.m > 0;
      if constexpr (kToX) SpreadReal<i, (x.m > 0), (y.m > 0), kStep.x, kStep.y>(parts, in, sums);
      if constexpr (kToY && kStep.x != kStep.y) {
        SpreadReal<i, (y.m > 0), (x.m > 0), kStep.y, kStep.x>(parts, in, sums);
      }
      static_assert(kComplex || Block(kStep.z[0]).m == 0, "real by real is real");
    } else {
      constexpr bool kUpperIsX = x.m >= y.m;
      constexpr int kUpper = kUpperIsX ? kStep.x : kStep.y;
      constexpr int kLower = kUpperIsX ? kStep.y : kStep.x;
      constexpr bool kToUpper = kUpperIsX ? kToX : kToY, kToLower = kUpperIsX ? kToY : kToX;
      SpreadComplex<i, kUpper, kLower, kToUpper, kToLower && kStep.x != kStep.y>(parts, in, sums);
    }
  }
  // The sum times block `by` to block `to`, one of which is real at least.
  template <int i, bool to_complex, bool by_complex, int to, int by, class T, class In, class S>
  static GAUNT_LANES void SpreadReal(const T& parts, const In& in, S& sums) {
    constexpr Block t(to), w(by);
    const auto real = parts(kRestReal);
    AddTo<t.Cosine()>(in(w.Cosine()), real, sums);
    if constexpr (by_complex) AddTo<t.Cosine()>(in(w.Sine()), parts(kRestImaginary), sums);
    if constexpr (to_complex) AddTo<t.Sine()>(in(w.Cosine()), parts(kRestImaginary), sums);
  }
  // With sums T where z's m is a sum and M where it is not, upper U and lower W:
  //   to U: conj(W) T + W M,   to W: conj(U) T + conj(M) U.
  template <int i, int upper, int lower, bool to_upper, bool to_lower, class T, class In, class S>
  static GAUNT_LANES void SpreadComplex(const T& parts, const In& in, S& sums) {
    constexpr Block u(upper), w(lower);
    constexpr bool kSum = Any(kSteps[i], true, false, false);
    constexpr bool kRest = Any(kSteps[i], false, false, false);
    constexpr bool kComplexRest = Any(kSteps[i], false, true, false);
    constexpr int uc = u.Cosine(), us = u.Sine(), wc = w.Cosine(), ws = w.Sine();
    using V = std::decay_t<decltype(parts(0))>;
    V sum_real, sum_imaginary, difference_real, difference_imaginary;
    // T + M, and M - T and T - M of their real and imaginary parts.
    if constexpr (kSum && kRest) {
      sum_real = Add(parts(kSumReal), parts(kRestReal));
      difference_real = Sub(parts(kRestReal), parts(kSumReal));
      if constexpr (kComplexRest) {
        sum_imaginary = Add(parts(kSumImaginary), parts(kRestImaginary));
        difference_imaginary = Sub(parts(kSumImaginary), parts(kRestImaginary));
      } else {
        sum_imaginary = difference_imaginary = parts(kSumImaginary);
      }
      if constexpr (to_upper) {
        AddTwo<u.Cosine()>(in(wc), sum_real, in(ws), difference_imaginary, sums);
        AddTwo<u.Sine()>(in(wc), sum_imaginary, in(ws), difference_real, sums);
      }
      if constexpr (to_lower) {
        AddTwo<w.Cosine()>(in(uc), sum_real, in(us), sum_imaginary, sums);
        AddTwo<w.Sine()>(in(uc), difference_imaginary, in(us), difference_real, sums);
      }
    } else if constexpr (kSum) {
      const V real = parts(kSumReal), imaginary = parts(kSumImaginary);
      if constexpr (to_upper) {
        AddTwo<u.Cosine()>(in(wc), real, in(ws), imaginary, sums);
        AddTwo<u.Sine(), false>(in(wc), imaginary, in(ws), real, sums);
      }
      if constexpr (to_lower) {
        AddTwo<w.Cosine()>(in(uc), real, in(us), imaginary, sums);
        AddTwo<w.Sine(), false>(in(uc), imaginary, in(us), real, sums);
      }
    } else if constexpr (kComplexRest) {
      const V real = parts(kRestReal), imaginary = parts(kRestImaginary);
      if constexpr (to_upper) {
        AddTwo<u.Cosine(), false>(in(wc), real, in(ws), imaginary, sums);
        AddTwo<u.Sine()>(in(wc), imaginary, in(ws), real, sums);
      }
      if constexpr (to_lower) {
        AddTwo<w.Cosine()>(in(uc), real, in(us), imaginary, sums);
        AddTwo<w.Sine(), false>(in(us), real, in(uc), imaginary, sums);
      }
    } else {
      const V real = parts(kRestReal);
      if constexpr (to_upper) {
        AddTo<u.Cosine()>(in(wc), real, sums);
        AddTo<u.Sine()>(in(ws), real, sums);
      }
      if constexpr (to_lower) {
        AddTo<w.Cosine()>(in(uc), real, sums);
        AddTo<w.Sine()>(in(us), real, sums);
      }
    }
  }
  template <int p, bool kPlus = true, class V, class S>
  static GAUNT_LANES void AddTwo(V a, V b, V c, V d, S& sums) {
    const V sum = MulAdd(a, b, sums(p));
    sums(p, kPlus ? MulAdd(c, d, sum) : NegMulAdd(c, d, sum));
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_SPARSE_INL_H_
