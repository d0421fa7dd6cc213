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

// (x + i y)(c + i s)
template <class V>
GAUNT_LANES void Turn(V x, V y, V& c, V& s) {
  const V next_c = MulSub(x, c, Mul(y, s));
  s = MulAdd(x, s, Mul(y, c));
  c = next_c;
}

// Weights::Band(l) y_lm of one direction for all bands l < n whose weight is not zero:
//   y_l^m = q_l^m(z) c_m(x, y),   y_l^-m = q_l^m(z) s_m(x, y),
// where c_m + i s_m = (-1)^m sqrt2 (x + i y)^m and q_l^m is the associated Legendre function
// without its sin^m, times the norm. q is kept scaled so that the first row of each column is one
// constant. Where no weight is zero, the constants of the recurrences carry them. Else the first
// three rows of a column, which are closed forms, take them up, unless others go on from them.
template <int n, class Weights = UnitBands>
struct Eval {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, Out&& out) const {
    using V = typename K::V;
    const V x = direction(0), y = direction(1), z = direction(2);
    V z2 = z;
    if constexpr (Wanted(2)) z2 = Mul(z, z);
    Column<0>(k, x, y, z, z2, x, y, out);
  }

 private:
  static constexpr double Weight(int l) { return l < n ? Weights::Band(l) : 0.0; }
  static constexpr bool AllWeighted() {
    for (int l = 0; l < n; ++l) {
      if (Weight(l) == 0.0) return false;
    }
    return true;
  }
  // Whether rows have their weights when they are made.
  static constexpr bool kCarried = AllWeighted();
  // Whether band `from` or one above it is.
  static constexpr bool Wanted(int from) {
    for (int l = from; l < n; ++l) {
      if (Weight(l) != 0.0) return true;
    }
    return false;
  }

  // Bands m.. of +-m; c and s are Re and Im of (x + i y)^m, for m > 0.
  template <int m, class K, class V, class Out>
  static GAUNT_LANES void Column(const K& k, V x, V y, V z, V z2, V c, V s, Out& out) {
    constexpr bool kGoesOn = Wanted(m + 3);
    constexpr bool kWeigh = kGoesOn && !kCarried;  // afterwards
    constexpr double kFirstWeight = kWeigh ? 1.0 : Weight(m + 1);
    constexpr double kSecondWeight = kWeigh ? 1.0 : Weight(m + 2);
    constexpr double kConstant = Weight(m) * kSectoral<m>;
    if constexpr (kConstant != 0.0) Emit<m, m>(k(kConstant), c, s, out);
    V first = z, second = z2;
    if constexpr (kFirstWeight != 0.0 && Wanted(m + 1)) {
      constexpr double kLinear = kFirstWeight * kFirst<m>;
      first = Mul(k(kLinear), z);
      Row<m + 1, m, kWeigh>(k, first, c, s, out);
    }
    if constexpr (kSecondWeight != 0.0 && Wanted(m + 2)) {
      constexpr double kSquare = kSecondWeight * kSecondSquare<m>;
      constexpr double kOffset = kSecondWeight * kSecondConstant<m>;
      second = MulAdd(k(kSquare), z2, k(kOffset));
      Row<m + 2, m, kWeigh>(k, second, c, s, out);
    }
    if constexpr (kGoesOn) Bands<m + 3, m>(k, z, second, first, c, s, out);
    if constexpr (Wanted(m + 1)) {
      if constexpr (m > 0) Turn(x, y, c, s);
      Column<m + 1>(k, x, y, z, z2, c, s, out);
    }
  }

  // q_l = a (z q_{l-1} - b q_{l-2})
  template <int l, int m, class K, class V, class Out>
  static GAUNT_LANES void Bands(const K& k, V z, V below, V below2, V c, V s, Out& out) {
    constexpr double kForward = kStep<l, m> * (kCarried ? Weight(l) / Weight(l - 1) : 1.0);
    constexpr double kBackward = kStepBack<l, m> * (kCarried ? Weight(l) / Weight(l - 2) : 1.0);
    const V value = MulSub(Mul(k(kForward), z), below, Mul(k(kBackward), below2));
    Row<l, m, !kCarried>(k, value, c, s, out);
    if constexpr (Wanted(l + 1)) Bands<l + 1, m>(k, z, value, below, c, s, out);
  }

  // A row that still has to be weighed, or has been.
  template <int l, int m, bool kWeigh, class K, class V, class Out>
  static GAUNT_LANES void Row(const K& k, V q, V c, V s, Out& out) {
    constexpr double kWeight = Weight(l);
    if constexpr (kWeigh && kWeight != 1.0 && kWeight != 0.0) q = Mul(k(kWeight), q);
    if constexpr (kWeight != 0.0) Emit<l, m>(q, c, s, out);
  }

  template <int l, int m, class V, class Out>
  static GAUNT_LANES void Emit(V q, V c, V s, Out& out) {
    if constexpr (m == 0) {
      out(CoefficientIndex(l, 0), q);
    } else {
      out(CoefficientIndex(l, m), Mul(q, c));
      out(CoefficientIndex(l, -m), Mul(q, s));
    }
  }
};

// Any order goes by loops over the same recurrences, in one of two orders of the same arithmetic:
// column after column, which keeps a column's values in registers, or band after band, which writes
// planes in their order.

// Turns q_{l-1}^m into q_l^m, and q_{l-2} into q_{l-1}.
template <class K, class V>
GAUNT_LANES void Advance(const K& k, int l, int m, V z, V& q, V& below) {
  const Step& step = kBands.steps[StepIndex(l, m)];
  const V next = MulSub(Mul(k(step.forward), z), q, Mul(k(step.backward), below));
  below = q;
  q = next;
}

template <class V, class Out>
GAUNT_LANES void EmitPair(int l, int m, V q, V c, V s, Out& out) {
  out(static_cast<size_t>(CoefficientIndex(l, m)), Mul(q, c));
  out(static_cast<size_t>(CoefficientIndex(l, -m)), Mul(q, s));
}

// y_l0 for l < order.
struct EvalZonal {
  int order;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, Out&& out) const {
    using V = typename K::V;
    const V z = direction(2);
    V q = k(kBands.sectoral[0]), below = k(0.0);
    out(0, q);
    for (int l = 1; l < order; ++l) {
      Advance(k, l, 0, z, q, below);
      out(static_cast<size_t>(CoefficientIndex(l, 0)), q);
    }
  }
};

// y_l^+-m and y_l^+-(m+1) for l < order, where both columns exist: one recurrence alone would wait
// for its own results. c and s are Re and Im of (x + i y)^m, and become those of the power m + 2.
struct EvalColumnPair {
  int order;
  int m;

  template <class K, class V, class Out>
  GAUNT_LANES void operator()(const K& k, V x, V y, V z, V& c, V& s, Out&& out) const {
    V c1 = c, s1 = s;
    Turn(x, y, c1, s1);
    V q0 = k(kBands.sectoral[m]), below0 = k(0.0);
    V q1 = k(kBands.sectoral[m + 1]), below1 = k(0.0);
    EmitPair(m, m, q0, c, s, out);
    Advance(k, m + 1, m, z, q0, below0);
    EmitPair(m + 1, m, q0, c, s, out);
    EmitPair(m + 1, m + 1, q1, c1, s1, out);
    for (int l = m + 2; l < order; ++l) {
      Advance(k, l, m, z, q0, below0);
      Advance(k, l, m + 1, z, q1, below1);
      EmitPair(l, m, q0, c, s, out);
      EmitPair(l, m + 1, q1, c1, s1, out);
    }
    Turn(x, y, c1, s1);
    c = c1, s = s1;
  }
};

// y_l^+-m for l < order.
struct EvalColumn {
  int order;
  int m;

  template <class K, class V, class Out>
  GAUNT_LANES void operator()(const K& k, V z, V c, V s, Out&& out) const {
    V q = k(kBands.sectoral[m]), below = k(0.0);
    EmitPair(m, m, q, c, s, out);
    for (int l = m + 1; l < order; ++l) {
      Advance(k, l, m, z, q, below);
      EmitPair(l, m, q, c, s, out);
    }
  }
};

// y_lm of one direction for first <= |m| < last and |m| <= l < order.
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
      EvalZonal{order}(k, direction, out);
      ++m;
    }
    if (m >= last) return;
    V c = x, s = y;
    for (int power = 1; power < m; ++power) Turn(x, y, c, s);
    for (; m + 1 < last; m += 2) EvalColumnPair{order, m}(k, x, y, z, c, s, out);
    if (m < last) EvalColumn{order, m}(k, z, c, s, out);
  }
};

// What EvalBand keeps from band to band: q_{l-1} and q_{l-2} of each column, where q_l takes the
// place of q_{l-2}, and Re and Im of the powers of x + i y.
constexpr size_t StateQ(int l, int m) { return static_cast<size_t>(l % 2 * kMaxOrder + m); }
constexpr size_t StateCosine(int m) { return static_cast<size_t>(2 * kMaxOrder + m); }
constexpr size_t StateSine(int m) { return static_cast<size_t>(3 * kMaxOrder + m); }
inline constexpr size_t kStatePlanes = 4 * kMaxOrder;

// y_lm of one direction for band l, after the bands below it; plane l + m of `out`.
struct EvalBand {
  int l;

  template <class K, class In, class StateIn, class StateOut, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, const StateIn& before,
                              const StateOut& state, const Out& out) const {
    using V = typename K::V;
    const V sectoral = k(kBands.sectoral[l]);
    if (l == 0) {
      state(StateQ(0, 0), sectoral);
      out(0, sectoral);
      return;
    }
    const V z = direction(2);
    for (int m = 0; m + 1 < l; ++m) {
      V q = before(StateQ(l - 1, m)), below = before(StateQ(l, m));
      Advance(k, l, m, z, q, below);
      Set(before, state, out, m, q);
    }
    const V forward = Mul(k(kBands.steps[StepIndex(l, l - 1)].forward), z);
    Set(before, state, out, l - 1, Mul(forward, before(StateQ(l - 1, l - 1))));
    const V x = direction(0), y = direction(1);
    V c = x, s = y;
    if (l > 1) {
      c = before(StateCosine(l - 1)), s = before(StateSine(l - 1));
      Turn(x, y, c, s);
    }
    state(StateCosine(l), c);
    state(StateSine(l), s);
    state(StateQ(l, l), sectoral);
    out(static_cast<size_t>(2 * l), Mul(sectoral, c));
    out(0, Mul(sectoral, s));
  }

 private:
  template <class StateIn, class StateOut, class Out, class V>
  GAUNT_LANES void Set(const StateIn& before, const StateOut& state, const Out& out, int m,
                       V q) const {
    state(StateQ(l, m), q);
    if (m == 0) return out(static_cast<size_t>(l), q);
    out(static_cast<size_t>(l + m), Mul(q, before(StateCosine(m))));
    out(static_cast<size_t>(l - m), Mul(q, before(StateSine(m))));
  }
};

// Gradient on the sphere of a band's planes first <= m < last, from the band itself. With the
// generators of rotation G = d x grad, which mix neighbours in m, the part of grad y along the
// sphere is G y x d: nothing is divided, so the poles are like any other point.
struct GradientBand {
  int l;
  int first;
  int last;

  // Plane m - first of dx, dy and dz.
  template <class K, class In, class Band, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, const Band& band, const Out& dx,
                              const Out& dy, const Out& dz) const {
    using V = typename K::V;
    const V x = direction(0), y = direction(1), z = direction(2);
    for (int m = first; m < last; ++m) {
      V gx, gy, gz;
      Generators(k, band, m, gx, gy, gz);
      const size_t plane = static_cast<size_t>(m - first);
      dx(plane, MulSub(gy, z, Mul(gz, y)));
      dy(plane, MulSub(gz, x, Mul(gx, z)));
      dz(plane, MulSub(gx, y, Mul(gy, x)));
    }
  }

 private:
  size_t Plane(int m) const { return static_cast<size_t>(l + m); }

  template <class K, class Band, class V>
  GAUNT_LANES void Generators(const K& k, const Band& band, int m, V& gx, V& gy, V& gz) const {
    const int a = m < 0 ? -m : m;
    if (m == 0) {
      gx = Mix(k, band, 0, false, -1.0);
      gy = Mix(k, band, 0, true, 1.0);
      gz = k(0.0);
    } else if (m > 0) {
      gx = Neg(Mix(k, band, a, false, 1.0));
      gy = Mix(k, band, a, true, -1.0);
      gz = Mul(k(-a), band(Plane(-a)));
    } else {
      gx = Mix(k, band, a, true, 1.0);
      gy = Mix(k, band, a, false, -1.0);
      gz = Mul(k(a), band(Plane(a)));
    }
  }

  // Planes a + 1 and, times `sign`, a - 1, of cosines or of sines, by the ladder's factors. Column 0
  // lacks a factor of sqrt2, and has no sine; for a = 0 both neighbours are one.
  template <class K, class Band>
  GAUNT_LANES typename K::V Mix(const K& k, const Band& band, int a, bool cosine,
                                double sign) const {
    using V = typename K::V;
    constexpr double kRoot2 = ConstexprSqrt(2.0);
    const int side = cosine ? 1 : -1;
    if (l == 0) return k(0.0);
    if (a == 0) {
      return Mul(k(sign * kRoot2 * kBands.ladder[StepIndex(l, 0)]), band(Plane(side)));
    }
    const bool has_up = a<l, has_down = a> 1 || cosine;
    V mix = k(0.0);
    if (has_down) {
      const double factor = (a == 1 ? kRoot2 : 1.0) * kBands.ladder[StepIndex(l, a - 1)];
      mix = Mul(k(sign * factor), band(Plane(side * (a - 1))));
    }
    if (!has_up) return mix;
    return MulAdd(k(kBands.ladder[StepIndex(l, a)]), band(Plane(side * (a + 1))), mix);
  }
};

// The gradient of all bands l < n, unrolled.
template <int n>
struct EvalGradient {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& direction, const Out& dx, const Out& dy,
                              const Out& dz) const {
    typename K::template Slots<NumCoefficients(n)> y;
    Eval<n>()(k, direction, y);
    All(k, direction, y, dx, dy, dz, std::make_integer_sequence<int, NumCoefficients(n)>());
  }

 private:
  template <class Slots>
  struct BandOfSlots {
    const Slots& slots;
    size_t first;
    GAUNT_LANES auto operator()(size_t p) const { return slots(first + p); }
  };

  // Side by side, not nested: compilers take minutes over the latter.
  template <class K, class In, class Slots, class Out, int... i>
  static GAUNT_LANES void All(const K& k, const In& direction, const Slots& y, const Out& dx,
                              const Out& dy, const Out& dz, std::integer_sequence<int, i...>) {
    (Coefficient<i>(k, direction, y, dx, dy, dz), ...);
  }

  template <int i, class K, class In, class Slots, class Out>
  static GAUNT_LANES void Coefficient(const K& k, const In& direction, const Slots& y,
                                      const Out& dx, const Out& dy, const Out& dz) {
    constexpr int l = BandOf(i), m = i - CoefficientIndex(l, 0);
    GradientBand{l, m, m + 1}(k, direction, BandOfSlots<Slots>{y, l * l}, dx.From(i), dy.From(i),
                              dz.From(i));
  }
};

// d / |d|, or (0, 0, 1) where d is zero or not finite. Scaled by the largest component first, so that
// nothing overflows or underflows on the way.
struct Normalize {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    using V = typename K::V;
    const V scale = Max(Max(Abs(in(0)), Abs(in(1))), Abs(in(2)));
    const V x = Div(in(0), scale), y = Div(in(1), scale), z = Div(in(2), scale);
    const V squared = MulAdd(x, x, MulAdd(y, y, Mul(z, z)));
    const V inverse = Div(k(1.0), Sqrt(squared));
    const V ux = Mul(x, inverse), uy = Mul(y, inverse), uz = Mul(z, inverse);
    // A step of Newton's: it halves the error of the length.
    const V excess = MulAdd(ux, ux, MulAdd(uy, uy, MulSub(uz, uz, k(1.0))));
    const V step = Mul(k(-0.5), excess);
    const auto valid = Gt(squared, k(0.5));  // else it is not a number
    out(0, IfThenElseZero(valid, MulAdd(ux, step, ux)));
    out(1, IfThenElseZero(valid, MulAdd(uy, step, uy)));
    out(2, IfThenElse(valid, MulAdd(uz, step, uz), k(1.0)));
  }
};

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_BASIS_BASIS_INL_H_
