// SPDX-License-Identifier: MIT
// Bands of every channel, one after the other.
#if defined(GAUNT_ROTATE_EACH_BAND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_EACH_BAND_INL_H_
#undef GAUNT_ROTATE_EACH_BAND_INL_H_
#else
#define GAUNT_ROTATE_EACH_BAND_INL_H_
#endif

#include <array>
#include <utility>

#include "rotate/rotate.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Orders that have a kernel of their own, with all bands inlined. Those above share one, where
// bands are functions.
inline constexpr int kMaxInlinedOrder = 8;
inline constexpr int kAnyOrder = 0;

template <template <int> class Band, int kBands, class K, class Context, class In, class Out>
class BandFunctions {
 public:
  static void Call(int l, const K& k, const Context& context, const In& in, const Out& out) {
    kFunctions[static_cast<size_t>(l)](k, context, in, out);
  }

 private:
  using Function = void (*)(const K& k, const Context& context, const In& in, const Out& out);

  template <int l>
  static HWY_NOINLINE void Run(const K& k, const Context& context, const In& in, const Out& out) {
    Band<l>()(k, context, in, out);
  }
  template <int... l>
  static constexpr std::array<Function, kBands> Make(std::integer_sequence<int, l...>) {
    return {&Run<l>...};
  }
  static constexpr std::array<Function, kBands> kFunctions =
      Make(std::make_integer_sequence<int, kBands>());
};

template <template <int> class Band, class K, class Context, class In, class Out, int... l>
GAUNT_LANES void InlineBands(const K& k, const Context& context, const In& in, const Out& out,
                             std::integer_sequence<int, l...>) {
  (Band<l>()(k, context, in.From(l * l), out.From(l * l)), ...);
}

// Band<l>()(k, context, in, out) for each band l < order of each channel, whose planes begin at m =
// -l; n is the order or kAnyOrder, for orders up to kBands.
template <int n, template <int> class Band, int kBands = kMaxOrder, class K, class Context,
          class In, class Out>
GAUNT_LANES void ForEachBand(const K& k, int order, size_t channels, const Context& context,
                             const In& in, const Out& out) {
  for (size_t c = 0; c < channels; ++c) {
    const size_t first = c * static_cast<size_t>(NumCoefficients(order));
    const auto from = in.From(first);
    const auto to = out.From(first);
    if constexpr (n != kAnyOrder) {
      InlineBands<Band>(k, context, from, to, std::make_integer_sequence<int, n>());
    } else {
      for (int l = 0; l < order; ++l) {
        const size_t band = static_cast<size_t>(l * l);
        BandFunctions<Band, kBands, K, Context, In, Out>::Call(l, k, context, from.From(band),
                                                       to.From(band));
      }
    }
  }
}

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_EACH_BAND_INL_H_
