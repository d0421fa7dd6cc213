// SPDX-License-Identifier: MIT
// Kernels of projections.
#if defined(GAUNT_PROJECT_PROJECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_PROJECT_INL_H_
#undef GAUNT_PROJECT_PROJECT_INL_H_
#else
#define GAUNT_PROJECT_PROJECT_INL_H_
#endif

#include <limits>
#include <utility>

#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// The lane type once per index, for packs of local values.
template <class K, size_t>
struct LaneOf {
  using V = typename K::V;
};

template <size_t kRows, class Indices>
struct MomentsAt;

// Sums over steps of texels(row, step) tables(i, step), out(row, i, sum), for each i < kMoments; of
// the texels of `main` and then of `tail`. Two rows at once share what is read of the tables, and
// neither waits for itself; one row alone gives the same sums.
template <size_t kRows, size_t kMoments>
using Moments = MomentsAt<kRows, std::make_index_sequence<kMoments>>;

template <size_t kRows, size_t... i>
struct MomentsAt<kRows, std::index_sequence<i...>> {
  template <class K, class Texels, class Tables, class Out>
  GAUNT_LANES void operator()(const K& k, const Texels& main, size_t main_steps, const Texels& tail,
                              size_t tail_steps, const Tables& tables, Out&& out) const {
    Run(k, main, main_steps, tail, tail_steps, tables, out, Zero<i>(k)..., Zero<i>(k)...);
  }

 private:
  template <size_t, class K>
  static GAUNT_LANES typename K::V Zero(const K& k) {
    return k(0.0);
  }

  template <class K, class Texels, class Tables, class Out>
  static GAUNT_LANES void Run(const K& k, const Texels& main, size_t main_steps, const Texels& tail,
                              size_t tail_steps, const Tables& tables, Out& out,
                              typename LaneOf<K, i>::V... upper,
                              typename LaneOf<K, i>::V... lower) {
    for (size_t step = 0; step < main_steps; ++step) {
      Step(k, main, step, tables, step, upper..., lower...);
    }
    for (size_t step = 0; step < tail_steps; ++step) {
      Step(k, tail, step, tables, main_steps + step, upper..., lower...);
    }
    (out(0, i, upper), ...);
    if constexpr (kRows == 2) (out(1, i, lower), ...);
  }

  template <class K, class Texels, class Tables>
  static GAUNT_LANES void Step(const K& k, const Texels& texels, size_t step, const Tables& tables,
                               size_t at, typename LaneOf<K, i>::V&... upper,
                               typename LaneOf<K, i>::V&... lower) {
    const typename K::V first = texels(0, step), second = kRows == 2 ? texels(1, step) : k(0.0);
    (AddBoth(first, second, tables(i, at), upper, lower), ...);
  }

  template <class V>
  static GAUNT_LANES void AddBoth(V first, V second, V table, V& upper, V& lower) {
    upper = MulAdd(first, table, upper);
    if constexpr (kRows == 2) lower = MulAdd(second, table, lower);
  }
};

// Weights dOmega |d|^-even and dOmega |d|^-odd of texels of side h at u on row v of a face, where
// d = (u, v, 1). With R = 1 / |d|^2, the solid angle is the integral of R^(3/2) over the texel; by
// Taylor's theorem around its centre, up to h^4,
//   dOmega = h^2 R^(3/2) (1 + h^2 R (9 - 15 R) / 24
//                           + h^4 R^2 (7/128 - 91/192 R + (63/128 + 21/32 u^2 v^2) R^2)).
// What is left out is below 5e-3 h^6.
struct CubeWeights {
  double v, h;
  int even, odd;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, Out&& out) const {
    using V = typename K::V;
    const V u = in(0), u2 = Mul(u, u), v2 = k(v * v), h2 = k(h * h);
    const V r = Div(k(1.0), Add(u2, k(1.0 + v * v))), root = Sqrt(r), area = Mul(h2, r);
    const V square = MulAdd(Mul(u2, v2), k(21.0 / 32.0), k(63.0 / 128.0));
    const V fourth = MulAdd(MulAdd(square, r, k(-91.0 / 192.0)), r, k(7.0 / 128.0));
    const V second = MulAdd(area, fourth, MulAdd(r, k(-15.0 / 24.0), k(9.0 / 24.0)));
    const V solid_angle = Mul(Mul(area, root), MulAdd(area, second, k(1.0)));
    out(0, Power(solid_angle, r, even / 2));
    out(1, Power(Mul(solid_angle, root), r, (odd - 1) / 2));
  }

 private:
  template <class V>
  static GAUNT_LANES V Power(V value, V factor, int exponent) {
    for (int i = 0; i < exponent; ++i) value = Mul(value, factor);
    return value;
  }
};

// weight x^i for i = 0 .. degree.
struct Powers {
  int degree;

  template <class K, class V, class Out>
  GAUNT_LANES void operator()(const K&, V weight, V x, Out&& out) const {
    for (int i = 0; i <= degree; ++i) {
      out(static_cast<size_t>(i), weight);
      if (i < degree) weight = Mul(weight, x);
    }
  }
};

// Adds weight value_c y_lm(direction) to the sums of coefficients that the basis visits, channel by
// channel, in the order of its visits.
template <class Basis, int kChannels, class Sums>
struct AddSamples {
  Basis basis;
  Sums sums;

  template <class K, class Direction, class Values, class Weights>
  GAUNT_LANES void operator()(const K& k, const Direction& direction, const Values& values,
                              const Weights& weights) const {
    typename K::template Slots<kChannels> weighted;
    const typename K::V weight = weights(0);
    for (size_t c = 0; c < kChannels; ++c) weighted(c, Mul(weight, values(c)));
    basis(k, direction, Adder<K>{sums, weighted, 0});
  }

 private:
  template <class K>
  struct Adder {
    const Sums& sums;
    const typename K::template Slots<kChannels>& weighted;
    size_t next;

    GAUNT_LANES void operator()(size_t, typename K::V y) {
      for (size_t c = 0; c < kChannels; ++c, ++next) {
        sums(next, MulAdd(weighted(c), y, sums(next)));
      }
    }
  };
};

// Zero for what is negative, infinite or not a number.
struct Clamp {
  template <class K, class V>
  GAUNT_LANES V operator()(const K& k, V v) const {
    return IfThenElseZero(And(Gt(v, k(0.0)), Lt(v, k(std::numeric_limits<double>::infinity()))), v);
  }
};

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROJECT_PROJECT_INL_H_
