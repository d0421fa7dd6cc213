// SPDX-License-Identifier: MIT
// Kernels of zonal functions: turned to a direction, and convolved with. They write products of two
// factors; where a kernel gets the planes that were there as well, it adds to them.
#if defined(GAUNT_ZONAL_ZONAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ZONAL_ZONAL_INL_H_
#undef GAUNT_ZONAL_ZONAL_INL_H_
#else
#define GAUNT_ZONAL_ZONAL_INL_H_
#endif

#include <utility>

#include "basis/basis-inl.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"
#include "zonal/constants.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::zonal::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Where products go: planes that are set to them.
template <class Out>
struct SetPlanes {
  Out out;
  GAUNT_LANES SetPlanes From(size_t p) const { return {out.From(p)}; }
  template <class V>
  GAUNT_LANES void operator()(size_t p, V a, V b) const {
    out(p, Mul(a, b));
  }
};
// Planes that they are added to.
template <class Out, class Before>
struct AddToPlanes {
  Out out;
  Before before;
  GAUNT_LANES AddToPlanes From(size_t p) const { return {out.From(p), before.From(p)}; }
  template <class V>
  GAUNT_LANES void operator()(size_t p, V a, V b) const {
    out(p, MulAdd(a, b, before(p)));
  }
};
template <class Out>
GAUNT_LANES SetPlanes<Out> ProductsTo(const Out& out) {
  return {out};
}
template <class Out, class Before>
GAUNT_LANES AddToPlanes<Out, Before> ProductsTo(const Out& out, const Before& before) {
  return {out, before};
}

// Factor l times plane lm, for all bands l < n.
template <int n>
struct ScaleBands {
  template <class InF, class In, class To>
  GAUNT_LANES void operator()(const InF& factor, const In& in, const To& to) const {
    Band<0>(factor, in, to);
  }

 private:
  template <int l, class InF, class In, class To>
  static GAUNT_LANES void Band(const InF& factor, const In& in, const To& to) {
    if constexpr (l < n) {
      Coefficients<l * l>(factor(l), in, to, std::make_index_sequence<2 * l + 1>());
      Band<l + 1>(factor, in, to);
    }
  }

  template <size_t first, class V, class In, class To, size_t... i>
  static GAUNT_LANES void Coefficients(V factor, const In& in, const To& to,
                                       std::index_sequence<i...>) {
    (to(first + i, factor, in(first + i)), ...);
  }
};

// Turns the zonal function of each channel to a direction. The basis, weighed by ZonalBands, is
// evaluated once and kept in slots, for one channel too: planes are best written in their order.
template <int n>
struct Rotate {
  size_t channels;

  template <class K, class InZ, class InD, class... Out>
  GAUNT_LANES void operator()(const K& k, const InZ& zonal, const InD& direction,
                              const Out&... out) const {
    typename K::template Slots<NumCoefficients(n)> y;
    basis::HWY_NAMESPACE::Eval<n, ZonalBands>()(k, direction, y);
    const auto to = ProductsTo(out...);
    for (size_t c = 0; c < channels; ++c) {
      ScaleBands<n>()(zonal.From(c * n), y, to.From(c * NumCoefficients(n)));
    }
  }
};

// Many zonal functions to one direction. Its weighed basis is part of the kernel: as planes of the
// batch it would be read from all over the pages that are being written.
template <int n>
struct RotateToOne {
  size_t channels;
  float y[NumCoefficients(n)];

  template <class K, class InZ, class... Out>
  GAUNT_LANES void operator()(const K& k, const InZ& zonal, const Out&... out) const {
    const auto to = ProductsTo(out...);
    for (size_t c = 0; c < channels; ++c) {
      ScaleBands<n>()(zonal.From(c * n), Basis<K>{k, y}, to.From(c * NumCoefficients(n)));
    }
  }

 private:
  template <class K>
  struct Basis {
    const K& k;
    const float* y;
    GAUNT_LANES typename K::V operator()(size_t i) const { return k(y[i]); }
  };
};

// sqrt(4 pi / (2l+1)) times a plane of each band.
struct WeighBands {
  size_t order;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, Out&& out) const {
    for (size_t l = 0; l < order; ++l) out(l, Mul(k(kTables.factor[l]), in(l)));
  }
};

// Convolves each channel with one kernel that has been weighed.
template <int n>
struct ConvolveWeighed {
  size_t channels;

  template <class K, class InH, class In, class Out>
  GAUNT_LANES void operator()(const K&, const InH& weighed, const In& in, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      ScaleBands<n>()(weighed, in.From(c * NumCoefficients(n)),
                      ProductsTo(out.From(c * NumCoefficients(n))));
    }
  }
};

template <int n>
struct Convolve {
  size_t channels;

  template <class K, class InH, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const InH& kernel, const In& in, const Out& out) const {
    typename K::template Slots<n> weighed;
    WeighBands{n}(k, kernel, weighed);
    ConvolveWeighed<n>{channels}(k, weighed, in, out);
  }
};

// Any order: takes y_lm as they are made, column by column, and multiplies them for each channel.
template <class InZ, class To>
struct EmitProducts {
  InZ zonal;
  To to;
  size_t order;
  size_t channels;

  template <class V>
  GAUNT_LANES void operator()(size_t i, V y) const {
    for (size_t c = 0; c < channels; ++c) {
      to(c * order * order + i, zonal(c * order + kTables.band[i]), y);
    }
  }
};

// One band of any order: a factor that has been weighed, times its planes.
struct ScaleBand {
  int l;

  template <class K, class InF, class In, class... Out>
  GAUNT_LANES void operator()(const K&, const InF& weighed, const In& in, const Out&... out) const {
    const auto factor = weighed(0);
    const auto to = ProductsTo(out...);
    const size_t planes = static_cast<size_t>(2 * l + 1);
    for (size_t p = 0; p < planes; ++p) to(p, factor, in(p));
  }
};

}  // namespace gaunt::zonal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ZONAL_ZONAL_INL_H_
