// SPDX-License-Identifier: MIT
// Products on the grid for orders that are known when it runs. The same rows as those of
// fixed_grid-inl.h, with loops over coefficients.
#if defined(GAUNT_PRODUCT_ANY_GRID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_ANY_GRID_INL_H_
#undef GAUNT_PRODUCT_ANY_GRID_INL_H_
#else
#define GAUNT_PRODUCT_ANY_GRID_INL_H_
#endif

#include "product/orbits-inl.h"
#include "product/product.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

// Slots of a row: cosines, then sines, of every m that M points tell apart.
constexpr int LastOrder(int M) { return M / 2 - 1; }
constexpr int RowWidth(int M) { return M - 1; }

// Rows at z and -z of a function of degree L, or the equator, which is a row of its own. Orders up
// to `last` that the function does not have are 0.
template <class K, class In, class S>
HWY_NOINLINE void SynthesiseRows(const K& k, const float* factors, const In& in, int L, int last,
                                 bool is_pair, S upper, S lower) {
  using V = typename K::V;
  for (int m = -last; m <= last; ++m) {
    const int size = m < 0 ? -m : m, at = m < 0 ? last - m : m;
    V even = k(0.0), odd = k(0.0);
    for (int l = size; l <= L; l += 2) {
      even = MulAdd(k(factors[PolarIndex(l, size)]), in(CoefficientIndex(l, m)), even);
    }
    if (is_pair) {
      for (int l = size + 1; l <= L; l += 2) {
        odd = MulAdd(k(factors[PolarIndex(l, size)]), in(CoefficientIndex(l, m)), odd);
      }
      lower(at, Sub(even, odd));
      even = Add(even, odd);
    }
    upper(at, even);
  }
}

// Adds what such rows contribute to the coefficients of a product of degree L.
template <class K, class S, class Out>
HWY_NOINLINE void AnalyseRows(const K& k, const float* factors, int L, int last, bool is_pair,
                              S upper, S lower, const Out& out) {
  using V = typename K::V;
  const auto sums = out.Read();
  for (int m = -L; m <= L; ++m) {
    const int size = m < 0 ? -m : m, at = m < 0 ? last - m : m;
    const V a = upper(at), b = is_pair ? lower(at) : k(0.0);
    const V even = Add(a, b), odd = Sub(a, b);
    for (int l = size; l <= L; l += 2) {
      const int i = CoefficientIndex(l, m);
      out(i, MulAdd(k(factors[PolarIndex(l, size)]), even, sums(i)));
    }
    for (int l = size + 1; is_pair && l <= L; l += 2) {
      const int i = CoefficientIndex(l, m);
      out(i, MulAdd(k(factors[PolarIndex(l, size)]), odd, sums(i)));
    }
  }
}

// Values at both poles.
template <class K, class In>
GAUNT_LANES void PoleValues(const K& k, const float* factors, const In& in, int L,
                            typename K::V& upper, typename K::V& lower) {
  typename K::V even = k(0.0), odd = k(0.0);
  for (int l = 0; l <= L; ++l) {
    auto& sum = l % 2 == 0 ? even : odd;
    sum = MulAdd(k(factors[l]), in(CoefficientIndex(l, 0)), sum);
  }
  upper = Add(even, odd);
  lower = Sub(even, odd);
}

template <int M, Level level, class K, class S, class To>
HWY_NOINLINE void ValuesOfAnyRow(const K& k, S row, To& values) {
  ValuesOfRow<M, LastOrder(M), level>(k, row, values);
}
template <int M, Level level, class K, class Values, class S>
HWY_NOINLINE void RowOfAnyProduct(const K& k, const Values& a, const Values& b, S row) {
  RowOfProduct<M, LastOrder(M), level, false>(k, a, b, row);
}

// The output is where sums are kept, so that it may not be an input in place. Of one input, the
// second factor is the first or, if there are values of a prepared function, that function.
template <int M, Level level>
struct AnyGrid {
  Degrees degrees;
  const void* prepared = nullptr;

  template <class K, class InA, class InB, class Out>
  GAUNT_LANES void operator()(const K& k, const InA& a, const InB& b, const Out& out) const {
    Run<true>(k, a, b, out);
  }
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    Run<false>(k, in, in, out);
  }

 private:
  static constexpr int kLast = LastOrder(M), kWidth = RowWidth(M);

  template <bool kOther, class K, class InA, class InB, class Out>
  GAUNT_LANES void Run(const K& k, const InA& a, const InB& b, const Out& out) const {
    const GridTable& table = kGrids<level>;
    const int grid = GridOf(degrees.a + degrees.b + degrees.out);
    auto values = k.Floats(prepared);
    Begin<kOther>(k, table, grid, a, b, values, out);
    if (prepared != nullptr) values = values.From(kPoleValues);
    typename K::template Slots<4 * kWidth> slots;  // rows of the first factor become the product's
    typename K::template Slots<M> a_values, b_values;
    const int pairs = GridTable::Pairs(grid);
    for (int i = GridTable::HasEquator(grid) ? -1 : 0; i < pairs; ++i) {  // the equator first
      const bool is_pair = i >= 0;
      const RowFactors factors = table.Row(grid, is_pair ? i : pairs);
      SynthesiseRows(k, factors.in, a, degrees.a, kLast, is_pair, RowOf(slots, 0), RowOf(slots, 1));
      if (kOther) {
        SynthesiseRows(k, factors.in, b, degrees.b, kLast, is_pair, RowOf(slots, 2),
                       RowOf(slots, 3));
      }
      for (int row = 0; row < (is_pair ? 2 : 1); ++row) {
        ValuesOfAnyRow<M, level>(k, RowOf(slots, row), a_values);
        if (kOther) {
          ValuesOfAnyRow<M, level>(k, RowOf(slots, 2 + row), b_values);
        } else {
          for (size_t p = 0; p < M; ++p) b_values(p, prepared ? values(p) : a_values(p));
          if (prepared != nullptr) values = values.From(M);
        }
        RowOfAnyProduct<M, level>(k, a_values, b_values, RowOf(slots, row));
      }
      AnalyseRows(k, factors.out, degrees.out, kLast, is_pair, RowOf(slots, 0), RowOf(slots, 1),
                  out);
    }
  }

  template <class S>
  static GAUNT_LANES Strided<1, S> RowOf(S& slots, int row) {
    return Every<1>(slots, row * kWidth);
  }

  // What the poles contribute, and 0 elsewhere.
  template <bool kOther, class K, class InA, class InB, class Values, class Out>
  GAUNT_LANES void Begin(const K& k, const GridTable& table, int grid, const InA& a, const InB& b,
                         const Values& values, const Out& out) const {
    typename K::V upper, lower, upper_b, lower_b;
    PoleValues(k, table.PoleIn(), a, degrees.a, upper, lower);
    if (prepared != nullptr) {
      upper_b = values(0);
      lower_b = values(1);
    } else if (kOther) {
      PoleValues(k, table.PoleIn(), b, degrees.b, upper_b, lower_b);
    } else {
      upper_b = upper;
      lower_b = lower;
    }
    upper = Mul(upper, upper_b);
    lower = Mul(lower, lower_b);
    const auto even = Add(upper, lower), odd = Sub(upper, lower);
    for (int l = 0; l <= degrees.out; ++l) {
      for (int m = -l; m <= l; ++m) {
        const int i = CoefficientIndex(l, m);
        out(i, m != 0 ? k(0.0) : Mul(k(table.PoleOut(grid)[l]), l % 2 == 0 ? even : odd));
      }
    }
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_ANY_GRID_INL_H_
