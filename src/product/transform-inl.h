// SPDX-License-Identifier: MIT
// Fourier transforms of real rows: from coefficients of cos(m phi) and sin(m phi) to values at M
// equispaced points, and the transpose. Points come in orbits phi, -phi, pi - phi, pi + phi, whose
// values are sums of four parts: cosines and sines, of even and of odd m.
//
// All of them recur to half of M: even m are a transform of M/2, and odd m, folded with M/2 - m,
// split into the even points, again of M/2, and a small dense block for the odd ones.
#if defined(GAUNT_PRODUCT_TRANSFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_TRANSFORM_INL_H_
#undef GAUNT_PRODUCT_TRANSFORM_INL_H_
#else
#define GAUNT_PRODUCT_TRANSFORM_INL_H_
#endif

#include <utility>

#include "product/grid.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Every step-th slot from one on.
template <int step, class S>
struct Strided {
  S& slots;
  int first;
  GAUNT_LANES auto operator()(int i) const { return slots(static_cast<size_t>(step * i + first)); }
  template <class V>
  GAUNT_LANES void operator()(int i, V v) const {
    slots(static_cast<size_t>(step * i + first), v);
  }
};
template <int step, class S>
GAUNT_LANES Strided<step, S> Every(S& slots, int first) {
  return {slots, first};
}

// A dense block: Block::At(r, c), rows r and columns c from kFirst.. in steps of two. Sums leave out
// a factor, so that one of their terms needs no multiplication.
template <class Block>
struct Dense {
  static constexpr bool IsUnit(double x) {
    return (x > 1.0 - 1e-12 && x < 1.0 + 1e-12) || (x < -1.0 + 1e-12 && x > -1.0 - 1e-12);
  }

  // Sums over the columns of a row, or over the rows of a column.
  template <bool kTransposed>
  struct Line {
    static constexpr int kFirst = kTransposed ? Block::kFirstRow : Block::kFirstColumn;
    static constexpr int kLast = kTransposed ? Block::kLastRow : Block::kLastColumn;
    static constexpr int kStep = kTransposed ? Block::kRowStep : Block::kColumnStep;
    static constexpr double Exact(int line, int i) {
      return kTransposed ? Block::At(i, line) : Block::At(line, i);
    }
    static constexpr double Factor(int line) {
      for (int i = kFirst; i <= kLast; i += kStep) {
        if (IsUnit(Exact(line, i))) return 1.0;
      }
      return Exact(line, kFirst);
    }
    static constexpr double At(int line, int i) { return Exact(line, i) / Factor(line); }
    // Where a sum begins: with a term of its own, which is +1 if there is one, else -1.
    static constexpr int Start(int line) {
      int start = kFirst;
      for (int i = kLast; i >= kFirst; i -= kStep) {
        if (IsUnit(At(line, i)) && At(line, i) < 0.0) start = i;
      }
      for (int i = kLast; i >= kFirst; i -= kStep) {
        if (IsUnit(At(line, i)) && At(line, i) > 0.0) start = i;
      }
      return start;
    }
  };

  template <bool kTransposed, int line, class K, class In>
  static GAUNT_LANES typename K::V Sum(const K& k, const In& in) {
    using L = Line<kTransposed>;
    constexpr int kStart = L::Start(line);
    if constexpr (L::At(line, kStart) > 0.0) {
      return Rest<L, line, L::kFirst, kStart, kStart>(k, in, in(kStart));
    } else {
      // The first other term takes it along.
      constexpr int kOther = kStart == L::kFirst ? L::kFirst + L::kStep : L::kFirst;
      static_assert(kOther <= L::kLast, "a single term is never negative");
      constexpr double kCoefficient = L::At(line, kOther);
      return Rest<L, line, L::kFirst, kStart, kOther>(
          k, in, MulSub(k(kCoefficient), in(kOther), in(kStart)));
    }
  }

 private:
  // Adds the terms from i on but those that are in the sum.
  template <class L, int line, int i, int start, int other, class K, class In>
  static GAUNT_LANES typename K::V Rest(const K& k, const In& in, typename K::V sum) {
    if constexpr (i > L::kLast) {
      return sum;
    } else if constexpr (i == start || i == other) {
      return Rest<L, line, i + L::kStep, start, other>(k, in, sum);
    } else {
      constexpr double kCoefficient = L::At(line, i);
      constexpr int kNext = i + L::kStep;
      if constexpr (IsUnit(kCoefficient) && kCoefficient > 0.0) {
        return Rest<L, line, kNext, start, other>(k, in, Add(sum, in(i)));
      } else if constexpr (IsUnit(kCoefficient)) {
        return Rest<L, line, kNext, start, other>(k, in, Sub(sum, in(i)));
      } else {
        return Rest<L, line, kNext, start, other>(k, in, MulAdd(k(kCoefficient), in(i), sum));
      }
    }
  }
};

// Sums of two values that lack factors.
template <bool kFuse>
struct Butterfly {
  template <bool kUnitA, bool kUnitB, class K, class V>
  static GAUNT_LANES V Sum(const K& k, double factor_a, V a, double factor_b, V b) {
    if constexpr (kUnitA && kUnitB) {
      return Add(a, b);
    } else if constexpr (kUnitA) {
      return MulAdd(k(factor_b), b, a);
    } else {
      return MulAdd(k(factor_a), a, Whole<kUnitB>(k, factor_b, b));
    }
  }

  // Where both are wanted, one product serves both, or each has a multiply-add.
  template <bool kUnitA, bool kUnitB, class K, class V>
  static GAUNT_LANES void Both(const K& k, double factor_a, V a, double factor_b, V b, V& sum,
                               V& difference) {
    if constexpr (!kUnitA && !kUnitB) {
      Both<false, true>(k, factor_a, a, 1.0, Mul(k(factor_b), b), sum, difference);
    } else if constexpr (!kUnitB && kFuse) {
      sum = MulAdd(k(factor_b), b, a);
      difference = NegMulAdd(k(factor_b), b, a);
    } else if constexpr (!kUnitA && kFuse) {
      sum = MulAdd(k(factor_a), a, b);
      difference = MulSub(k(factor_a), a, b);
    } else {
      const V x = Whole<kUnitA>(k, factor_a, a), y = Whole<kUnitB>(k, factor_b, b);
      sum = Add(x, y);
      difference = Sub(x, y);
    }
  }

  template <bool kUnit, class K, class V>
  static GAUNT_LANES V Whole(const K& k, double factor, V v) {
    if constexpr (kUnit) {
      return v;
    } else {
      return Mul(k(factor), v);
    }
  }
};

enum class Wave { kCosine, kSine };

template <Wave wave>
constexpr double WaveAt(int k, int n) {
  return wave == Wave::kCosine ? CosineOfTurn(k, n) : CosineOfTurn(4 * k - n, 4 * n);
}

// Odd m <= L, points j: from 0 below M/4 of cosines, from 1 up to M/4 of sines. Results lack
// factors. Coefficients arrive times the OddScale of as many points as kScaled says, if it is not 0.
template <Wave wave, int M, int L, bool kFuse, int kScaled = 0>
struct OddWaves {
  static constexpr bool kCosine = wave == Wave::kCosine;
  static constexpr int kFirstPoint = kCosine ? 0 : 1;
  static constexpr int kLastPoint = kCosine ? (M + 3) / 4 - 1 : M / 4;
  static constexpr bool kFolds = M % 4 == 0 && M > 4;
  static constexpr double kScale = kScaled != 0 ? 1.0 / OddScale(kScaled) : 1.0;
  // M/2 - m takes part with m. One that is its own partner has no cosine at odd points, no sine at
  // even ones.
  static constexpr int kQuarter = M / 4;
  static constexpr bool IsSelf(int m) { return 2 * m == M / 2; }
  static constexpr bool HasPartner(int m) { return !IsSelf(m) && M / 2 - m <= L; }
  static constexpr int AtMost(int limit) {
    const int last = L < limit ? L : limit;
    return last % 2 != 0 ? last : last - 1;
  }
  static constexpr int kLastFolded = AtMost(kQuarter);
  static constexpr bool HasSum(int m) { return kCosine || !IsSelf(m); }
  static constexpr bool HasDifference(int m) { return !kCosine || !IsSelf(m); }
  // The even points see c_m + c_{M/2-m}, but of sines the difference; the odd points the other one.
  static constexpr int kLastEven = kLastFolded - (HasSum(kLastFolded) ? 0 : 2);
  static constexpr int kLastOdd = kLastFolded - (HasDifference(kLastFolded) ? 0 : 2);
  // Fused, the scale is one factor more to be taken along by a multiply-add; else constants have it.
  using Even = OddWaves<wave, M / 2, kLastEven, kFuse, kFuse ? 0 : kScaled>;
  static constexpr double kEvenScale = kFuse ? kScale : 1.0;

  // Where it does not fold, all points; else the odd ones.
  struct Block {
    static constexpr int kFirstRow = kFolds ? 1 : kFirstPoint;
    static constexpr int kLastRow = kLastPoint - (kFolds && kLastPoint % 2 == 0 ? 1 : 0);
    static constexpr int kRowStep = kFolds ? 2 : 1;
    static constexpr int kFirstColumn = 1;
    // sin(pi j) is nothing.
    static constexpr int kLastColumn = kFolds ? kLastOdd : AtMost(kCosine ? M / 2 : M / 2 - 1);
    static constexpr int kColumnStep = 2;
    static constexpr double At(int j, int m) { return kScale * WaveAt<wave>(m * j, M); }
  };
  using BlockSums = Dense<Block>;
  static constexpr double Factor(int j) {
    if constexpr (kFolds) {
      if (j % 2 == 0) return kEvenScale * Even::Factor(j / 2);
    }
    return BlockSums::template Line<false>::Factor(j);
  }

  template <class K, class In, class Out>
  static GAUNT_LANES void Forward(const K& k, const In& in, const Out& out) {
    if constexpr (L < 1) {
      return;
    } else if constexpr (!kFolds) {
      Rows(k, in, out, std::make_integer_sequence<int, kLastPoint - kFirstPoint + 1>());
    } else {
      typename K::template Slots<kQuarter + 1> even, odd;
      Fold(k, in, even, odd, std::make_integer_sequence<int, (kLastFolded + 1) / 2>());
      Even::Forward(k, Every<1>(even, 0), EvenPoints<const Out>{out});
      Rows(k, Every<1>(odd, 0), out,
           std::make_integer_sequence<int, (Block::kLastRow - Block::kFirstRow) / 2 + 1>());
    }
  }

  // out(m) = the sum over points of in(j) times the wave.
  template <class K, class In, class Out>
  static GAUNT_LANES void Backward(const K& k, const In& in, const Out& out) {
    if constexpr (L < 1) {
      return;
    } else if constexpr (!kFolds) {
      Columns(k, in, out, std::make_integer_sequence<int, (Block::kLastColumn + 1) / 2>());
    } else {
      typename K::template Slots<kQuarter + 1> even, odd;
      Even::Backward(k, EvenPoints<const In>{in}, Every<1>(even, 0));
      Columns(k, in, Every<1>(odd, 0),
              std::make_integer_sequence<int, (Block::kLastColumn + 1) / 2>());
      Unfold(k, even, odd, out, std::make_integer_sequence<int, (kLastFolded + 1) / 2>());
    }
  }

  // What Backward leaves out of out(m).
  static constexpr double BackwardFactor(int m) {
    if constexpr (kFolds) {
      return 1.0;
    } else {
      return BlockSums::template Line<true>::Factor(m);
    }
  }

 private:
  template <class S>
  struct EvenPoints {
    S& slots;
    GAUNT_LANES auto operator()(int j) const { return slots(2 * j); }
    template <class V>
    GAUNT_LANES void operator()(int j, V v) const {
      slots(2 * j, v);
    }
  };

  template <class K, class In, class Out, int... i>
  static GAUNT_LANES void Rows(const K& k, const In& in, const Out& out,
                               std::integer_sequence<int, i...>) {
    (out(Block::kFirstRow + Block::kRowStep * i,
         BlockSums::template Sum<false, Block::kFirstRow + Block::kRowStep * i>(k, in)),
     ...);
  }
  template <class K, class In, class Out, int... i>
  static GAUNT_LANES void Columns(const K& k, const In& in, const Out& out,
                                  std::integer_sequence<int, i...>) {
    (out(2 * i + 1, BlockSums::template Sum<true, 2 * i + 1>(k, in)), ...);
  }

  template <class K, class In, class S, int... i>
  static GAUNT_LANES void Fold(const K& k, const In& in, S& even, S& odd,
                               std::integer_sequence<int, i...>) {
    (FoldOne<2 * i + 1>(k, in, even, odd), ...);
  }
  template <int m, class K, class In, class S>
  static GAUNT_LANES void FoldOne(const K&, const In& in, S& even, S& odd) {
    const auto one = in(m);
    if constexpr (HasPartner(m)) {
      const auto other = in(M / 2 - m);
      even(m, kCosine ? Add(one, other) : Sub(one, other));
      odd(m, kCosine ? Sub(one, other) : Add(one, other));
    } else {
      if constexpr (HasSum(m)) even(m, one);
      if constexpr (HasDifference(m)) odd(m, one);
    }
  }

  template <class K, class S, class Out, int... i>
  static GAUNT_LANES void Unfold(const K& k, const S& even, const S& odd, const Out& out,
                                 std::integer_sequence<int, i...>) {
    (UnfoldOne<2 * i + 1>(k, even, odd, out), ...);
  }
  template <int m, class K, class S, class Out>
  static GAUNT_LANES void UnfoldOne(const K& k, const S& even, const S& odd, const Out& out) {
    constexpr double kEven = HasSum(m) ? kEvenScale * Even::BackwardFactor(m) : 1.0;
    constexpr double kOdd = HasDifference(m) ? BlockSums::template Line<true>::Factor(m) : 1.0;
    constexpr bool kUnitEven = kEven == 1.0, kUnitOdd = kOdd == 1.0;
    using Pair = Butterfly<kFuse>;
    if constexpr (!HasSum(m)) {
      out(m, Pair::template Whole<kUnitOdd>(k, kOdd, odd(m)));
    } else if constexpr (!HasDifference(m)) {
      out(m, Pair::template Whole<kUnitEven>(k, kEven, even(m)));
    } else if constexpr (!HasPartner(m)) {
      out(m, Pair::template Sum<kUnitEven, kUnitOdd>(k, kEven, even(m), kOdd, odd(m)));
    } else {
      typename K::V sum, difference;
      if constexpr (kCosine) {
        Pair::template Both<kUnitEven, kUnitOdd>(k, kEven, even(m), kOdd, odd(m), sum, difference);
      } else {  // the partner has the part of the odd points with its sign
        Pair::template Both<kUnitOdd, kUnitEven>(k, kOdd, odd(m), kEven, even(m), sum, difference);
      }
      out(m, sum);
      out(M / 2 - m, difference);
    }
  }
};

// All m <= L, points 0 .. M/2 of cosines, 1 .. below M/2 of sines; no factor is left out.
template <Wave wave, int M, int L, bool kFuse>
struct Waves {
  static constexpr bool kCosine = wave == Wave::kCosine;
  static constexpr int kFirst = kCosine ? 0 : 1;
  static constexpr int kHalf = M / 2;
  static constexpr int kLast = L < kHalf - kFirst ? L : kHalf - kFirst;
  using Odd = OddWaves<wave, M, kLast, kFuse>;
  using Even = Waves<wave, M / 2, kLast / 2, kFuse>;
  static constexpr bool kHasEven = kLast / 2 >= kFirst;
  static constexpr bool kHasOdd = kLast >= 1;
  // Points that have a mirror image at M/2 - j.
  static constexpr int kLastMirrored = (kHalf - 1) / 2;

  // An odd M does not split.
  struct Block {
    static constexpr int kFirstRow = kFirst, kLastRow = M / 2, kRowStep = 1;
    static constexpr int kFirstColumn = kFirst, kLastColumn = L < M / 2 ? L : M / 2;
    static constexpr int kColumnStep = 1;
    static constexpr double At(int j, int m) { return WaveAt<wave>(m * j, M); }
  };
  using BlockSums = Dense<Block>;

  template <class K, class In, class Out>
  static GAUNT_LANES void Forward(const K& k, const In& in, const Out& out) {
    if constexpr (M % 2 != 0) {
      Rows(k, in, out, std::make_integer_sequence<int, M / 2 - kFirst + 1>());
    } else {
      typename K::template Slots<kHalf + 1> even, odd;
      if constexpr (kHasEven) Even::Forward(k, EvenOrders<const In>{in}, Every<1>(even, 0));
      if constexpr (kHasOdd) Odd::Forward(k, in, Every<1>(odd, 0));
      Mirror(k, even, odd, out, std::make_integer_sequence<int, kHalf / 2 - kFirst + 1>());
    }
  }

  template <class K, class In, class Out>
  static GAUNT_LANES void Backward(const K& k, const In& in, const Out& out) {
    if constexpr (M % 2 != 0) {
      Columns(k, in, out,
              std::make_integer_sequence<int, Block::kLastColumn - Block::kFirstColumn + 1>());
    } else {
      typename K::template Slots<kHalf + 1> even, odd;
      Gather(k, in, even, odd, std::make_integer_sequence<int, kHalf / 2 - kFirst + 1>());
      if constexpr (kHasEven) Even::Backward(k, Every<1>(even, 0), EvenOrders<const Out>{out});
      if constexpr (kHasOdd) {
        Odd::Backward(k, Every<1>(odd, 0), out);
        Complete(k, out, std::make_integer_sequence<int, (kLast + 1) / 2>());
      }
    }
  }

 private:
  template <class S>
  struct EvenOrders {
    S& slots;
    GAUNT_LANES auto operator()(int m) const { return slots(2 * m); }
    template <class V>
    GAUNT_LANES void operator()(int m, V v) const {
      slots(2 * m, v);
    }
  };

  template <class K, class In, class Out, int... i>
  static GAUNT_LANES void Rows(const K& k, const In& in, const Out& out,
                               std::integer_sequence<int, i...>) {
    (PutSum<false, kFirst + i>(k, in, out), ...);
  }
  template <class K, class In, class Out, int... i>
  static GAUNT_LANES void Columns(const K& k, const In& in, const Out& out,
                                  std::integer_sequence<int, i...>) {
    (PutSum<true, kFirst + i>(k, in, out), ...);
  }
  template <bool kTransposed, int line, class K, class In, class Out>
  static GAUNT_LANES void PutSum(const K& k, const In& in, const Out& out) {
    constexpr double kFactor = BlockSums::template Line<kTransposed>::Factor(line);
    out(line, Butterfly<kFuse>::template Whole<kFactor == 1.0>(
                  k, kFactor, BlockSums::template Sum<kTransposed, line>(k, in)));
  }

  // Even and odd m at a point and at its mirror image, where cosines of odd m and sines of even m
  // change their sign.
  template <class K, class S, class Out, int... i>
  static GAUNT_LANES void Mirror(const K& k, const S& even, const S& odd, const Out& out,
                                 std::integer_sequence<int, i...>) {
    (MirrorOne<kFirst + i>(k, even, odd, out), ...);
  }
  template <int j, class K, class S, class Out>
  static GAUNT_LANES void MirrorOne(const K& k, const S& even, const S& odd, const Out& out) {
    constexpr double kFactor = kHasOdd && HasOddAt(j) ? Odd::Factor(j) : 1.0;
    constexpr bool kUnit = kFactor == 1.0;
    constexpr bool kEvenHere = kHasEven && (kCosine || j <= kLastMirrored);
    constexpr bool kOddHere = kHasOdd && HasOddAt(j);
    static_assert(kEvenHere || kOddHere, "a point without any order");
    typename K::V same, mirrored;
    if constexpr (!kOddHere) {
      same = mirrored = even(j);
    } else if constexpr (!kEvenHere) {
      same = mirrored = Butterfly<kFuse>::template Whole<kUnit>(k, kFactor, odd(j));
    } else if constexpr (kCosine) {
      Butterfly<kFuse>::template Both<true, kUnit>(k, 1.0, even(j), kFactor, odd(j), same,
                                                   mirrored);
    } else {
      Butterfly<kFuse>::template Both<kUnit, true>(k, kFactor, odd(j), 1.0, even(j), same,
                                                   mirrored);
    }
    out(j, same);
    if constexpr (j <= kLastMirrored) out(kHalf - j, mirrored);
  }
  // Cosines of odd m vanish half way.
  static constexpr bool HasOddAt(int j) { return !kCosine || 2 * j != kHalf; }

  template <class K, class In, class S, int... i>
  static GAUNT_LANES void Gather(const K& k, const In& in, S& even, S& odd,
                                 std::integer_sequence<int, i...>) {
    (GatherOne<kFirst + i>(k, in, even, odd), ...);
  }
  template <int j, class K, class In, class S>
  static GAUNT_LANES void GatherOne(const K&, const In& in, S& even, S& odd) {
    const auto here = in(j);
    if constexpr (j > kLastMirrored) {
      if constexpr (kCosine) even(j, here);
      if constexpr (!kCosine) odd(j, here);
    } else {
      const auto there = in(kHalf - j);
      if constexpr (kHasEven) even(j, kCosine ? Add(here, there) : Sub(here, there));
      if constexpr (kHasOdd) odd(j, kCosine ? Sub(here, there) : Add(here, there));
    }
  }

  // The factors that are left out by a block of odd m that does not fold.
  template <class K, class Out, int... i>
  static GAUNT_LANES void Complete(const K& k, const Out& out, std::integer_sequence<int, i...>) {
    (CompleteOne<2 * i + 1>(k, out), ...);
  }
  template <int m, class K, class Out>
  static GAUNT_LANES void CompleteOne(const K& k, const Out& out) {
    constexpr double kFactor = Odd::BackwardFactor(m);
    if constexpr (kFactor != 1.0) out(m, Mul(k(kFactor), out(m)));
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_TRANSFORM_INL_H_
