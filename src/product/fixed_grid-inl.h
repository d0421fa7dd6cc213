// SPDX-License-Identifier: MIT
// Products on the grid: functions are evaluated along rows of constant z, multiplied point by point,
// and integrated against the basis. Exact for what is read, with the fewest rows.
#if defined(GAUNT_PRODUCT_FIXED_GRID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_FIXED_GRID_INL_H_
#undef GAUNT_PRODUCT_FIXED_GRID_INL_H_
#else
#define GAUNT_PRODUCT_FIXED_GRID_INL_H_
#endif

#include <utility>

#include "product/orbits-inl.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

// Pairs of rows in a group.
inline constexpr int kMaxGroup = 3;

// What the second factor is: a function of its own, the first one again, or one that is prepared.
enum class Second { kOther, kSame, kPrepared };

// Rows of degrees La and Lb into one of degree Lc, which may take the place of the first. Out of
// line: it is the hot stage, and all of its values are its own.
template <int M, int La, int Lb, int Lc, Level level, class K, class A, class B, class C>
HWY_NOINLINE void MultiplyRows(const K& k, A a, B b, C c) {
  typename K::template Slots<M> a_values, b_values;
  ValuesOfRow<M, La, level>(k, a, a_values);
  ValuesOfRow<M, Lb, level>(k, b, b_values);
  RowOfProduct<M, Lc, level, false>(k, a_values, b_values, c);
}
template <int M, int L, int Lc, Level level, class K, class A, class C>
HWY_NOINLINE void SquareRow(const K& k, A a, C c) {
  typename K::template Slots<M> values;
  ValuesOfRow<M, L, level>(k, a, values);
  RowOfProduct<M, Lc, level, true>(k, values, values, c);
}
template <int M, int L, int Lc, Level level, class K, class A, class Values, class C>
HWY_NOINLINE void ApplyToRow(const K& k, A a, Values prepared, C c) {
  typename K::template Slots<M> values;
  ValuesOfRow<M, L, level>(k, a, values);
  RowOfProduct<M, Lc, level, false>(k, values, prepared, c);
}

// Orders of the factors and of the product that are known when it is compiled. Pairs of rows go
// through in groups: what is read of the factors, and of their tables, serves a whole group.
template <int kA, int kB, int kOut, Level level, Second second = Second::kOther>
struct FixedGrid {
  // Of a prepared function.
  const void* values = nullptr;

  template <class K, class InA, class InB, class Out>
  GAUNT_LANES void operator()(const K& k, const InA& a, const InB& b, const Out& out) const {
    static_assert(second == Second::kOther, "one factor too many");
    Run(k, a, b, out);
  }
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    static_assert(second != Second::kOther, "a factor is missing");
    Run(k, in, in, out);
  }

 private:
  static constexpr int La = kA - 1, Lb = kB - 1, Lc = kOut - 1;
  static constexpr int kGrid = GridOf(La + Lb + Lc);
  static constexpr int kPoints = PointsOf(kGrid);
  static constexpr int kPairs = GridTable::Pairs(kGrid);
  static constexpr bool kHasEquator = GridTable::HasEquator(kGrid);
  static constexpr int kGroups = (kPairs + kMaxGroup - 1) / kMaxGroup;
  static constexpr int kGroup = kGroups == 0 ? 0 : (kPairs + kGroups - 1) / kGroups;

  // Without a second factor that has coefficients, all that is for it vanishes.
  static constexpr int kLastB = second == Second::kOther ? Lb : -1;

  // A row has cosines, then sines. Rows of the product take the place of those of the first factor.
  // Row 0 is the equator, then come those at z and -z of each pair.
  static constexpr int kRows = 2 * kGroup + 1;
  static constexpr int kWidthA = 2 * (La > Lc ? La : Lc) + 1, kWidthB = 2 * Lb + 1;

  template <class K>
  struct Rows {
    typename K::template Slots<kRows * kWidthA> a;  // and of the product
    typename K::template Slots < kLastB<0 ? 1 : kRows * kWidthB> b;
  };

  template <int L>
  using Degrees = std::make_integer_sequence<int, L + 1>;

  template <class K, class InA, class InB, class Out>
  GAUNT_LANES void Run(const K& k, const InA& a, const InB& b, const Out& out) const {
    Rows<K> rows;
    typename K::template Slots<2> poles;
    typename K::template Slots<kGroups <= 1 ? 1 : kOut * kOut> sums;
    const auto prepared = k.Floats(values);
    Poles(k, a, b, prepared, poles);
    Groups<0>(k, a, b, prepared.From(kPoleValues), rows, poles, sums, out);
  }

  template <int group, class K, class InA, class InB, class Prepared, class P, class S, class Out>
  static GAUNT_LANES void Groups(const K& k, const InA& a, const InB& b, const Prepared& prepared,
                                 Rows<K>& rows, const P& poles, S& sums, const Out& out) {
    constexpr int kFirst = group * kGroup;
    constexpr int kCount = kPairs - kFirst < kGroup ? kPairs - kFirst : kGroup;
    constexpr bool kIsFirst = group == 0, kIsLast = group + 1 >= kGroups;
    constexpr bool kEquator = kIsFirst && kHasEquator;
    SynthesiseGroup<kFirst, kCount, kEquator>(k, a, b, rows);
    for (int row = kEquator ? 0 : 1; row <= 2 * kCount; ++row) {
      const auto product = Every<1>(rows.a, row * kWidthA);
      if constexpr (second == Second::kOther) {
        MultiplyRows<kPoints, La, Lb, Lc, level>(k, product, Every<1>(rows.b, row * kWidthB),
                                                 product);
      } else if constexpr (second == Second::kSame) {
        SquareRow<kPoints, La, Lc, level>(k, product, product);
      } else {
        const int stored = 2 * kFirst + row - (kHasEquator ? 0 : 1);
        ApplyToRow<kPoints, La, Lc, level>(
            k, product, prepared.From(static_cast<size_t>(stored * kPoints)), product);
      }
    }
    AnalyseGroup<kFirst, kCount, kEquator, kIsFirst, kIsLast>(k, rows.a, poles, sums, out);
    if constexpr (!kIsLast) Groups<group + 1>(k, a, b, prepared, rows, poles, sums, out);
  }

  // Of high orders apart: what compilers keep on the stack for each group is for that alone.
  static constexpr bool kIsApart = kA > 7;
  template <int first, int count, bool equator, class K, class InA, class InB>
  static GAUNT_LANES void SynthesiseGroup(const K& k, const InA& a, const InB& b, Rows<K>& rows) {
    using All = Degrees<(La > kLastB ? La : kLastB)>;
    if constexpr (kIsApart) {
      SynthesiseApart<first, count, equator>(k, a, b, rows, All());
    } else {
      Synthesise<first, count, equator>(k, a, b, rows, All());
    }
  }
  template <int first, int count, bool equator, class K, class InA, class InB, class All>
  static HWY_NOINLINE void SynthesiseApart(const K& k, const InA& a, const InB& b, Rows<K>& rows,
                                           All all) {
    Synthesise<first, count, equator>(k, a, b, rows, all);
  }
  template <int first, int count, bool equator, bool is_first, bool is_last, class K, class R,
            class P, class S, class Out>
  static GAUNT_LANES void AnalyseGroup(const K& k, const R& rows, const P& poles, S& sums,
                                       const Out& out) {
    if constexpr (kIsApart) {
      AnalyseApart<first, count, equator, is_first, is_last>(k, rows, poles, sums, out);
    } else {
      Analyse<first, count, equator, is_first, is_last>(k, rows, poles, sums, out, Degrees<Lc>());
    }
  }
  template <int first, int count, bool equator, bool is_first, bool is_last, class K, class R,
            class P, class S, class Out>
  static HWY_NOINLINE void AnalyseApart(const K& k, const R& rows, const P& poles, S& sums,
                                        const Out& out) {
    Analyse<first, count, equator, is_first, is_last>(k, rows, poles, sums, out, Degrees<Lc>());
  }

  template <int count>
  using Pairs = std::make_integer_sequence<int, count>;

  // Factors of pair i, or of the equator, which is pair kPairs.
  static const float* In(int i) { return kGrids<level>.Row(kGrid, i).in; }
  static const float* Back(int i) { return kGrids<level>.Row(kGrid, i).out; }

  // The rows of both factors from their coefficients, for each m.
  template <int first, int count, bool equator, class K, class InA, class InB, int... m>
  static GAUNT_LANES void Synthesise(const K& k, const InA& a, const InB& b, Rows<K>& rows,
                                     std::integer_sequence<int, m...>) {
    (SynthesiseOrder<first, count, equator, m, 1>(k, a, b, rows), ...);
    (SynthesiseOrder<first, count, equator, m, -1>(k, a, b, rows), ...);
  }
  template <int first, int count, bool equator, int m, int side, class K, class InA, class InB>
  static GAUNT_LANES void SynthesiseOrder(const K& k, const InA& a, const InB& b, Rows<K>& rows) {
    if constexpr (m > 0 || side > 0) {
      // Sums over l of even l + m and of odd, of each pair, then of the equator.
      typename K::template Slots<count + 1> even_a, odd_a, even_b, odd_b;
      Bands<first, count, equator, m, side, m>(k, a, b, even_a, even_b);
      Bands<first, count, false, m, side, m + 1>(k, a, b, odd_a, odd_b);
      PutRows<La, count, equator, m, side>(even_a, odd_a, rows.a, kWidthA, Pairs<count>());
      PutRows<kLastB, count, equator, m, side>(even_b, odd_b, rows.b, kWidthB, Pairs<count>());
    }
  }
  // Adds bands l, l + 2, ..
  template <int first, int count, bool equator, int m, int side, int l, class K, class InA,
            class InB, class S>
  static GAUNT_LANES void Bands(const K& k, const InA& a, [[maybe_unused]] const InB& b, S& sums_a,
                                [[maybe_unused]] S& sums_b) {
    constexpr int i = CoefficientIndex(l, side * m);
    using Rows = Pairs<count + (equator ? 1 : 0)>;
    if constexpr (l <= La && l <= kLastB) {
      AddBands<first, count, m, l>(k, a(i), b(i), sums_a, sums_b, Rows());
    } else if constexpr (l <= La) {
      AddBand<first, count, m, l>(k, a(i), sums_a, Rows());
    } else if constexpr (l <= kLastB) {
      AddBand<first, count, m, l>(k, b(i), sums_b, Rows());
    }
    if constexpr (l + 2 <= La || l + 2 <= kLastB) {
      Bands<first, count, equator, m, side, l + 2>(k, a, b, sums_a, sums_b);
    }
  }
  // To each pair of the group and, after them, to the equator.
  template <int first, int count, int m, int l, class K, class V, class S, int... i>
  static GAUNT_LANES void AddBands(const K& k, [[maybe_unused]] V a, [[maybe_unused]] V b,
                                   [[maybe_unused]] S& sums_a, [[maybe_unused]] S& sums_b,
                                   std::integer_sequence<int, i...>) {
    ((AddTerm<m, l>(k, In(i == count ? kPairs : first + i), a, sums_a, i),
      AddTerm<m, l>(k, In(i == count ? kPairs : first + i), b, sums_b, i)),
     ...);
  }
  template <int first, int count, int m, int l, class K, class V, class S, int... i>
  static GAUNT_LANES void AddBand(const K& k, [[maybe_unused]] V a, S& sums,
                                  std::integer_sequence<int, i...>) {
    (AddTerm<m, l>(k, In(i == count ? kPairs : first + i), a, sums, i), ...);
  }
  template <int m, int l, class K, class V, class S>
  static GAUNT_LANES void AddTerm(const K& k, const float* factors, V value, S& sums, int i) {
    if constexpr (l == 1 && m == 1) {
      sums(i, value);  // its factor is 1
    } else if constexpr (l <= m + 1) {
      sums(i, Mul(k(factors[PolarIndex(l, m)]), value));
    } else {
      sums(i, MulAdd(k(factors[PolarIndex(l, m)]), value, sums(i)));
    }
  }
  template <int L, int count, bool equator, int m, int side, class S, class R, int... i>
  static GAUNT_LANES void PutRows(const S& even, const S& odd, R& rows, int width,
                                  std::integer_sequence<int, i...>) {
    if constexpr (m <= L) {
      constexpr int kAt = side > 0 ? m : L + m;
      if constexpr (equator) rows(kAt, even(count));
      (PutPair<m == L>(even, odd, rows, kAt, i, width), ...);
    }
  }
  template <bool kEvenOnly, class S, class R>
  static GAUNT_LANES void PutPair(const S& even, const S& odd, R& rows, int at, int i, int width) {
    const int upper = at + (2 * i + 1) * width, lower = upper + width;
    if constexpr (kEvenOnly) {
      rows(upper, even(i));
      rows(lower, even(i));
    } else {
      rows(upper, Add(even(i), odd(i)));
      rows(lower, Sub(even(i), odd(i)));
    }
  }

  // What the rows contribute to each coefficient.
  template <int first, int count, bool equator, bool is_first, bool is_last, class K, class R,
            class P, class S, class Out, int... m>
  static GAUNT_LANES void Analyse(const K& k, const R& rows, const P& poles, S& sums,
                                  const Out& out, std::integer_sequence<int, m...>) {
    (AnalyseOrder<first, count, equator, is_first, is_last, m, 1>(k, rows, poles, sums, out), ...);
    (AnalyseOrder<first, count, equator, is_first, is_last, m, -1>(k, rows, poles, sums, out), ...);
  }
  template <int first, int count, bool equator, bool is_first, bool is_last, int m, int side,
            class K, class R, class P, class S, class Out>
  static GAUNT_LANES void AnalyseOrder(const K& k, const R& rows, const P& poles, S& sums,
                                       const Out& out) {
    if constexpr (m > 0 || side > 0) {
      constexpr int kAt = side > 0 ? m : Lc + m;
      typename K::template Slots<count + 1> even, odd;
      if constexpr (equator) even(count, rows(kAt));
      Split<(m < Lc)>(rows, kAt, even, odd, Pairs<count>());
      Coefficients<first, count, equator, is_first, is_last, m, side, m>(k, even, odd, poles, sums,
                                                                         out);
    }
  }
  template <bool kOdd, class R, class S, int... i>
  static GAUNT_LANES void Split(const R& rows, int at, S& even, S& odd,
                                std::integer_sequence<int, i...>) {
    (SplitPair<kOdd>(rows, at + (2 * i + 1) * kWidthA, even, odd, i), ...);
  }
  template <bool kOdd, class R, class S>
  static GAUNT_LANES void SplitPair(const R& rows, int upper, S& even, S& odd, int i) {
    const auto a = rows(upper), b = rows(upper + kWidthA);
    even(i, Add(a, b));
    if constexpr (kOdd) odd(i, Sub(a, b));
  }
  template <int first, int count, bool equator, bool is_first, bool is_last, int m, int side, int l,
            class K, class S, class P, class T, class Out>
  static GAUNT_LANES void Coefficients(const K& k, const S& even, const S& odd, const P& poles,
                                       T& sums, const Out& out) {
    if constexpr (l <= Lc) {
      constexpr int i = CoefficientIndex(l, side * m);
      constexpr bool kEven = (l + m) % 2 == 0;
      const S& rows = kEven ? even : odd;
      typename K::V sum;
      if constexpr (!is_first) {
        sum = sums(i);
      } else if constexpr (m == 0) {
        sum = Mul(k(kGrids<level>.PoleOut(kGrid)[l]), poles(l % 2));
      } else if constexpr (equator && kEven) {
        sum = Mul(k(Back(kPairs)[PolarIndex(l, m)]), rows(count));
      }
      constexpr bool kBegun = !is_first || m == 0 || (equator && kEven);
      if constexpr (is_first && m == 0 && equator && kEven) {
        sum = MulAdd(k(Back(kPairs)[PolarIndex(l, m)]), rows(count), sum);
      }
      sum = AddPairs<first, count, 0, m, l, kBegun>(k, rows, sum);
      if constexpr (is_last) {
        out(i, sum);
      } else {
        sums(i, sum);
      }
      Coefficients<first, count, equator, is_first, is_last, m, side, l + 1>(k, even, odd, poles,
                                                                             sums, out);
    }
  }
  template <int first, int count, int p, int m, int l, bool begun, class K, class S, class V>
  static GAUNT_LANES V AddPairs(const K& k, const S& rows, V sum) {
    if constexpr (p == count) {
      return sum;
    } else {
      const auto factor = k(Back(first + p)[PolarIndex(l, m)]);
      if constexpr (begun) {
        sum = MulAdd(factor, rows(p), sum);
      } else {
        sum = Mul(factor, rows(p));
      }
      return AddPairs<first, count, p + 1, m, l, true>(k, rows, sum);
    }
  }

  // Both poles have one point each. Sums and differences of the products there.
  template <class K, class InA, class InB, class Prepared, class P>
  static GAUNT_LANES void Poles(const K& k, const InA& a, const InB& b, const Prepared& prepared,
                                P& poles) {
    typename K::V upper, lower;
    PoleValues<La>(k, a, upper, lower);
    if constexpr (second == Second::kOther) {
      typename K::V upper_b, lower_b;
      PoleValues<Lb>(k, b, upper_b, lower_b);
      upper = Mul(upper, upper_b);
      lower = Mul(lower, lower_b);
    } else if constexpr (second == Second::kSame) {
      upper = Mul(upper, upper);
      lower = Mul(lower, lower);
    } else {
      upper = Mul(upper, prepared(0));
      lower = Mul(lower, prepared(1));
    }
    poles(0, Add(upper, lower));
    poles(1, Sub(upper, lower));
  }
  template <int L, class K, class In>
  static GAUNT_LANES void PoleValues(const K& k, const In& in, typename K::V& upper,
                                     typename K::V& lower) {
    const float* const factors = kGrids<level>.PoleIn();
    const auto even = PoleSum<L, 0>(k, factors, in);
    if constexpr (L == 0) {
      upper = lower = even;
    } else {
      const auto odd = PoleSum<L, 1>(k, factors, in);
      upper = Add(even, odd);
      lower = Sub(even, odd);
    }
  }
  // The sum over l, l + 2, .., of which the factor of l = 0 is 1.
  template <int L, int l, class K, class In>
  static GAUNT_LANES typename K::V PoleSum(const K& k, const float* factors, const In& in) {
    const auto value = in(CoefficientIndex(l, 0));
    if constexpr (l == 0) {
      return PoleRest<L, l + 2>(k, factors, in, value);
    } else {
      return PoleRest<L, l + 2>(k, factors, in, Mul(k(factors[l]), value));
    }
  }
  template <int L, int l, class K, class In, class V>
  static GAUNT_LANES V PoleRest(const K& k, const float* factors, const In& in, V sum) {
    if constexpr (l > L) {
      return sum;
    } else {
      return PoleRest<L, l + 2>(k, factors, in,
                                MulAdd(k(factors[l]), in(CoefficientIndex(l, 0)), sum));
    }
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_FIXED_GRID_INL_H_
