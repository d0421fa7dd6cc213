// SPDX-License-Identifier: MIT
// Kernels of the SH basis: normalised recurrences over bands for each |m|, unrolled at compile time
// or as loops over tables.
#if defined(GAUNT_BASIS_BASIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_BASIS_BASIS_INL_H_
#undef GAUNT_BASIS_BASIS_INL_H_
#else
#define GAUNT_BASIS_BASIS_INL_H_
#endif

#include "basis/constants.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::basis::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// y_lm of one direction for all l < n:
//   y_l^m = q_l^m(z) c_m(x, y),   y_l^-m = q_l^m(z) s_m(x, y),
// where c_m + i s_m = (-1)^m sqrt2 (x + i y)^m and q_l^m is the associated Legendre function
// without its sin^m, times the norm. q is kept scaled so that the first row of each column is one
// constant.
template <int n>
struct Eval {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, Out&& out) const {
    using V = typename K::V;
    const V z = direction(2);
    V z2 = z;
    if constexpr (n > 2) z2 = Mul(z, z);
    out(0, k(kSectoral<0>));
    if constexpr (n > 1) {
      Zonal<1>(k, z, z2, k(kSectoral<0>), k(kSectoral<0>), out);
      const V x = direction(0), y = direction(1);
      Column<1>(k, x, y, z, z2, x, y, out);
    }
  }

 private:
  // Bands l.. of m = 0, from the two bands below.
  template <int l, class K, class V, class Out>
  static GAUNT_LANES void Zonal(const K& k, V z, V z2, V below, V below2, Out& out) {
    V value;
    if constexpr (l == 1) {
      value = Mul(k(kFirst<0>), z);
    } else if constexpr (l == 2) {
      value = MulAdd(k(kSecondSquare<0>), z2, k(kSecondConstant<0>));
    } else {
      value = Step<l, 0>(k, z, below, below2);
    }
    out(CoefficientIndex(l, 0), value);
    if constexpr (l + 1 < n) Zonal<l + 1>(k, z, z2, value, below, out);
  }

  // Bands m.. of +-m; c and s are Re and Im of (x + i y)^m.
  template <int m, class K, class V, class Out>
  static GAUNT_LANES void Column(const K& k, V x, V y, V z, V z2, V c, V s, Out& out) {
    out(CoefficientIndex(m, m), Mul(k(kSectoral<m>), c));
    out(CoefficientIndex(m, -m), Mul(k(kSectoral<m>), s));
    if constexpr (m + 1 < n) {
      const V first = Mul(k(kFirst<m>), z);
      Pair<m + 1, m>(first, c, s, out);
      if constexpr (m + 2 < n) {
        const V second = MulAdd(k(kSecondSquare<m>), z2, k(kSecondConstant<m>));
        Pair<m + 2, m>(second, c, s, out);
        if constexpr (m + 3 < n) Bands<m + 3, m>(k, z, second, first, c, s, out);
      }
      // (x + i y)^(m+1)
      const V next_c = MulSub(x, c, Mul(y, s));
      const V next_s = MulAdd(x, s, Mul(y, c));
      Column<m + 1>(k, x, y, z, z2, next_c, next_s, out);
    }
  }

  template <int l, int m, class K, class V, class Out>
  static GAUNT_LANES void Bands(const K& k, V z, V below, V below2, V c, V s, Out& out) {
    const V value = Step<l, m>(k, z, below, below2);
    Pair<l, m>(value, c, s, out);
    if constexpr (l + 1 < n) Bands<l + 1, m>(k, z, value, below, c, s, out);
  }

  // q_l = a (z q_{l-1} - b q_{l-2})
  template <int l, int m, class K, class V>
  static GAUNT_LANES V Step(const K& k, V z, V below, V below2) {
    return MulSub(Mul(k(kStep<l, m>), z), below, Mul(k(kStepBack<l, m>), below2));
  }

  template <int l, int m, class V, class Out>
  static GAUNT_LANES void Pair(V q, V c, V s, Out& out) {
    out(CoefficientIndex(l, m), Mul(q, c));
    out(CoefficientIndex(l, -m), Mul(q, s));
  }
};

// y_lm of one direction for first <= |m| < last and |m| <= l < order, for any order. Columns go in
// pairs: one recurrence alone would wait for its own results.
struct EvalColumns {
  int order;
  int first;
  int last;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, Out&& out) const {
    using V = typename K::V;
    const V x = direction(0), y = direction(1), z = direction(2);
    int m = first;
    if (m == 0) {
      Zonal(k, z, out);
      ++m;
    }
    if (m >= last) return;
    // Re and Im of (x + i y)^m
    V c = x, s = y;
    for (int power = 1; power < m; ++power) Turn(x, y, c, s);
    for (; m + 1 < last; m += 2) {
      V next_c = c, next_s = s;
      Turn(x, y, next_c, next_s);
      Pair(k, m, z, c, s, next_c, next_s, out);
      c = next_c, s = next_s;
      Turn(x, y, c, s);
    }
    if (m < last) Single(k, m, z, c, s, out);
  }

 private:
  template <class V>
  static GAUNT_LANES void Turn(V x, V y, V& c, V& s) {
    const V next_c = MulSub(x, c, Mul(y, s));
    s = MulAdd(x, s, Mul(y, c));
    c = next_c;
  }

  // q_l, which becomes `below`; the former `below` becomes `below2`.
  template <class K, class V>
  static GAUNT_LANES void Advance(const K& k, const Step& step, V z, V& below, V& below2) {
    const V value = MulSub(Mul(k(step.forward), z), below, Mul(k(step.backward), below2));
    below2 = below;
    below = value;
  }

  template <class K, class V, class Out>
  GAUNT_LANES void Zonal(const K& k, V z, Out& out) const {
    V q = k(kColumns.sectoral[0]), below = k(0.0);
    out(0, q);
    for (int l = 1; l < order; ++l) {
      Advance(k, kColumns.steps[l - 1], z, q, below);
      out(static_cast<size_t>(CoefficientIndex(l, 0)), q);
    }
  }

  template <class K, class V, class Out>
  GAUNT_LANES void Single(const K& k, int m, V z, V c, V s, Out& out) const {
    V q = k(kColumns.sectoral[m]), below = k(0.0);
    const Step* step = kColumns.steps + ColumnBegin(m);
    Emit(m, m, q, c, s, out);
    for (int l = m + 1; l < order; ++l) {
      Advance(k, *step++, z, q, below);
      Emit(l, m, q, c, s, out);
    }
  }

  // Columns m and m + 1.
  template <class K, class V, class Out>
  GAUNT_LANES void Pair(const K& k, int m, V z, V c0, V s0, V c1, V s1, Out& out) const {
    V q0 = k(kColumns.sectoral[m]), below0 = k(0.0);
    V q1 = k(kColumns.sectoral[m + 1]), below1 = k(0.0);
    const Step* step0 = kColumns.steps + ColumnBegin(m);
    const Step* step1 = kColumns.steps + ColumnBegin(m + 1);
    Emit(m, m, q0, c0, s0, out);
    Advance(k, *step0++, z, q0, below0);
    Emit(m + 1, m, q0, c0, s0, out);
    Emit(m + 1, m + 1, q1, c1, s1, out);
    for (int l = m + 2; l < order; ++l) {
      Advance(k, *step0++, z, q0, below0);
      Advance(k, *step1++, z, q1, below1);
      Emit(l, m, q0, c0, s0, out);
      Emit(l, m + 1, q1, c1, s1, out);
    }
  }

  template <class V, class Out>
  static GAUNT_LANES void Emit(int l, int m, V q, V c, V s, Out& out) {
    out(static_cast<size_t>(CoefficientIndex(l, m)), Mul(q, c));
    out(static_cast<size_t>(CoefficientIndex(l, -m)), Mul(q, s));
  }
};

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_BASIS_BASIS_INL_H_
