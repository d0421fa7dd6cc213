// SPDX-License-Identifier: MIT
// Kernels that apply one planned rotation to many items.
#if defined(GAUNT_ROTATE_PLAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_PLAN_INL_H_
#undef GAUNT_ROTATE_PLAN_INL_H_
#else
#define GAUNT_ROTATE_PLAN_INL_H_
#endif

#include <array>
#include <utility>

#include "rotate/plan.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Entries of row m, of the cosines or, if negative, of the sines, by the m of their columns.
constexpr const float* RowOf(int l, const float* matrices, int m) {
  return m >= 0 ? matrices + m * (l + 1) : matrices + (l + 1) * (l + 1) - (m + 1) * l - 1;
}

// Band l of one channel, unrolled. Slots hold the turned cosines from l up, the sines below.
template <int l>
struct ApplyBand {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Plan& plan, const In& in, const Out& out) const {
    typename K::template Slots<2 * l + 1> turned, mixed;
    const float* const matrices = plan.matrices + MatricesIndex(l);
    First(k, plan.first, in, turned, Pairs());
    Mix(k, matrices, turned, mixed, Rows());
    Last(k, plan.last, mixed, out, Pairs());
  }

 private:
  using Pairs = std::make_integer_sequence<int, l + 1>;
  using Rows = std::make_integer_sequence<int, 2 * l + 1>;

  // Side by side, not nested: compilers take minutes over the latter.
  template <class K, class In, class To, int... m>
  static GAUNT_LANES void First(const K& k, const PlannedTurn& turn, const In& in, To& to,
                                std::integer_sequence<int, m...>) {
    (FirstPair<m>(k, turn, in, to), ...);
  }
  template <class K, class From, class Out, int... m>
  static GAUNT_LANES void Last(const K& k, const PlannedTurn& turn, const From& from,
                               const Out& out, std::integer_sequence<int, m...>) {
    (LastPair<m>(k, turn, from, out), ...);
  }
  template <class K, class From, class To, int... row>
  static GAUNT_LANES void Mix(const K& k, const float* matrices, const From& from, To& to,
                              std::integer_sequence<int, row...>) {
    (MixRow<row>(k, matrices, from, to), ...);
  }

  template <int m, class K, class In, class To>
  static GAUNT_LANES void FirstPair(const K& k, const PlannedTurn& turn, const In& in, To& to) {
    if constexpr (m == 0) {
      to(l, in(l));
    } else {
      const auto p = in(Plane(turn, m)), q = in(Plane(turn, -m)), tangent = k(turn.tangent[m]);
      to(l + m, NegMulAdd(tangent, q, p));
      to(l - m, MulAdd(tangent, p, q));
    }
  }

  template <int m, class K, class From, class Out>
  static GAUNT_LANES void LastPair(const K& k, const PlannedTurn& turn, const From& from,
                                   const Out& out) {
    if constexpr (m == 0) {
      out(l, from(l));
    } else {
      const auto p = from(l + m), q = from(l - m), tangent = k(turn.tangent[m]);
      out(Plane(turn, m), NegMulAdd(tangent, q, p));
      out(Plane(turn, -m), MulAdd(tangent, p, q));
    }
  }

  static GAUNT_LANES size_t Plane(const PlannedTurn& turn, int m) {
    return static_cast<size_t>(l + turn.side[m < 0 ? -m : m] * m);
  }

  template <int row, class K, class From, class To>
  static GAUNT_LANES void MixRow(const K& k, const float* matrices, const From& from, To& to) {
    constexpr int kSide = row < l ? -1 : 1;
    to(row, Sum<l, kSide>(k, RowOf(l, matrices, row - l), from));
  }

  // Of the products of coefficients side * m with the row's entries, m down to the first.
  template <int m, int side, class K, class From>
  static GAUNT_LANES typename K::V Sum(const K& k, const float* row, const From& from) {
    if constexpr (m == (side < 0 ? 1 : 0)) {
      return Mul(k(row[m]), from(l + side * m));
    } else {
      return MulAdd(k(row[m]), from(l + side * m), Sum<m - 1, side>(k, row, from));
    }
  }
};

// Band l of one channel, in loops.
struct ApplyAnyBand {
  int l;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Plan& plan, const In& in, const Out& out) const {
    typename K::template Slots<2 * kMaxOrder - 1> turned, mixed;
    turned(Index(0), in(Index(0)));
    for (int m = 1; m <= l; ++m) {
      const int side = plan.first.side[m];
      const auto p = in(Index(side * m)), q = in(Index(-side * m)), tangent = k(plan.first.tangent[m]);
      turned(Index(m), NegMulAdd(tangent, q, p));
      turned(Index(-m), MulAdd(tangent, p, q));
    }
    const float* const matrices = plan.matrices + MatricesIndex(l);
    for (int m = -l; m <= l; ++m) {
      mixed(Index(m), Sum(k, RowOf(l, matrices, m), m < 0 ? -1 : 1, turned));
    }
    out(Index(0), mixed(Index(0)));
    for (int m = 1; m <= l; ++m) {
      const int side = plan.last.side[m];
      const auto p = mixed(Index(m)), q = mixed(Index(-m)), tangent = k(plan.last.tangent[m]);
      out(Index(side * m), NegMulAdd(tangent, q, p));
      out(Index(-side * m), MulAdd(tangent, p, q));
    }
  }

 private:
  size_t Index(int m) const { return static_cast<size_t>(l + m); }

  template <class K, class From>
  GAUNT_LANES typename K::V Sum(const K& k, const float* row, int side, const From& from) const {
    int m = side < 0 ? 1 : 0;
    auto sum = Mul(k(row[m]), from(Index(side * m)));
    for (++m; m <= l; ++m) sum = MulAdd(k(row[m]), from(Index(side * m)), sum);
    return sum;
  }
};

// Bands that are unrolled.
inline constexpr int kPlannedUnrolledBands = 10;

// One function per band, which all orders share.
template <class K, class In, class Out>
struct ApplyFunctions {
  using Function = void (*)(const K& k, const Plan& plan, const In& in, const Out& out);

  template <int l>
  static HWY_NOINLINE void Unrolled(const K& k, const Plan& plan, const In& in, const Out& out) {
    ApplyBand<l>()(k, plan, in, out);
  }
  static HWY_NOINLINE void Any(int l, const K& k, const Plan& plan, const In& in, const Out& out) {
    ApplyAnyBand{l}(k, plan, in, out);
  }

  template <int... l>
  static constexpr std::array<Function, sizeof...(l)> Make(std::integer_sequence<int, l...>) {
    return {&Unrolled<l>...};
  }
  static constexpr std::array<Function, kPlannedUnrolledBands> kUnrolled =
      Make(std::make_integer_sequence<int, kPlannedUnrolledBands>());
};

struct ApplyPlan {
  int order;
  size_t channels;
  const Plan& plan;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    using Functions = ApplyFunctions<K, In, Out>;
    for (size_t c = 0; c < channels; ++c) {
      const size_t first = c * static_cast<size_t>(NumCoefficients(order));
      for (int l = 0; l < order; ++l) {
        const In from = in.From(first + static_cast<size_t>(l * l));
        const Out to = out.From(first + static_cast<size_t>(l * l));
        if (l < kPlannedUnrolledBands) {
          Functions::kUnrolled[static_cast<size_t>(l)](k, plan, from, to);
        } else {
          Functions::Any(l, k, plan, from, to);
        }
      }
    }
  }
};

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_PLAN_INL_H_
