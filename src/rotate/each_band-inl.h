// SPDX-License-Identifier: MIT
// Bands of every channel, one after the other.
#if defined(GAUNT_ROTATE_EACH_BAND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_EACH_BAND_INL_H_
#undef GAUNT_ROTATE_EACH_BAND_INL_H_
#else
#define GAUNT_ROTATE_EACH_BAND_INL_H_
#endif

#include <utility>

#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Orders whose bands are inlined into one kernel. Above, bands are functions that all orders share.
inline constexpr int kMaxInlinedOrder = 6;

template <class Band, class K, class Context, class In, class Out>
HWY_NOINLINE void CallBand(const K& k, const Context& context, const In& in, const Out& out) {
  Band()(k, context, in, out);
}

template <int n, template <int> class Band, class K, class Context, class In, class Out, int... l>
GAUNT_LANES void ForBands(const K& k, const Context& context, const In& in, const Out& out,
                          std::integer_sequence<int, l...>) {
  if constexpr (n <= kMaxInlinedOrder) {
    (Band<l>()(k, context, in.From(l * l), out.From(l * l)), ...);
  } else {
    (CallBand<Band<l>>(k, context, in.From(l * l), out.From(l * l)), ...);
  }
}

// Band<l>()(k, context, in, out) for each band l < n of each channel, whose planes begin at m = -l.
template <int n, template <int> class Band, class K, class Context, class In, class Out>
GAUNT_LANES void ForEachBand(const K& k, size_t channels, const Context& context, const In& in,
                             const Out& out) {
  for (size_t c = 0; c < channels; ++c) {
    const size_t first = c * NumCoefficients(n);
    ForBands<n, Band>(k, context, in.From(first), out.From(first),
                      std::make_integer_sequence<int, n>());
  }
}

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_EACH_BAND_INL_H_
