// SPDX-License-Identifier: MIT
// Kernel of row projections: Fourier moments of a run of texels.
#if defined(GAUNT_PROJECT_PROJECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_PROJECT_INL_H_
#undef GAUNT_PROJECT_PROJECT_INL_H_
#else
#define GAUNT_PROJECT_PROJECT_INL_H_
#endif

#include <limits>

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Sum over groups of texels times weights, in two sums so that neighbours do not wait for each
// other.
struct WeightedSum {
  template <class K, class InT, class InW>
  GAUNT_LANES typename K::V operator()(const K& k, const InT& texels, const InW& weights,
                                       size_t groups) const {
    typename K::V even = k(0.0), odd = k(0.0);
    size_t g = 0;
    for (; g + 2 <= groups; g += 2) {
      even = MulAdd(texels(g), weights(g), even);
      odd = MulAdd(texels(g + 1), weights(g + 1), odd);
    }
    if (g < groups) even = MulAdd(texels(g), weights(g), even);
    return Add(even, odd);
  }
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
