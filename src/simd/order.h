// SPDX-License-Identifier: MIT
// Orders, channels and the index sequences that tables are built from.
#ifndef GAUNT_SIMD_ORDER_H_
#define GAUNT_SIMD_ORDER_H_

#include <cstddef>
#include <utility>

namespace gaunt {

// The highest order of families that go by recurrences: basis, evaluate, project, zonal.
inline constexpr int kMaxOrder = 64;
// Orders whose kernels are unrolled at compile time.
inline constexpr int kMaxUnrolledOrder = 6;
inline constexpr int kMaxChannels = 4;

constexpr int NumCoefficients(int order) { return order * order; }
constexpr int CoefficientIndex(int l, int m) { return l * (l + 1) + m; }
constexpr int BandOf(int i) {
  int l = 0;
  while ((l + 1) * (l + 1) <= i) ++l;
  return l;
}

// A table indexed by order has a null entry 0 so that the order is the index.
template <int kMax>
using Orders = std::make_integer_sequence<int, kMax + 1>;

}  // namespace gaunt

#endif  // GAUNT_SIMD_ORDER_H_
