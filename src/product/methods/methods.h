// SPDX-License-Identifier: MIT
// Other ways to make the products, to compare with and to check against; the library has none of
// them. Orders of both factors and of the product are the same, and outputs are not in place.
#ifndef GAUNT_PRODUCT_METHODS_METHODS_H_
#define GAUNT_PRODUCT_METHODS_METHODS_H_

#include <vector>

#include "product/product.h"

namespace gaunt::product::methods {

inline constexpr int kMinOrder = 2;

using MethodFn = void (*)(size_t count, const simd::InView& a, const simd::InView& b,
                          const simd::OutView& out);

// By the Gaunt coefficients themselves. Straight code of order 7 would be as large, and as long to
// compile, as that of all orders below; it is counted, though.
namespace sparse {
inline constexpr int kMaxOrder = 6;
inline constexpr int kMaxCountedOrder = 7;
struct Table {
  MethodFn by_output[kMaxOrder + 1];  // [order]
  MethodFn by_pairs[kMaxOrder + 1];
};
const Table& Kernels();
}  // namespace sparse

// On the grid, with each level of what sums over its orbits leave out.
namespace levels {
inline constexpr int kMaxOrder = 8;
inline constexpr int kLevels = 4;
struct Table {
  MethodFn product[kLevels][kMaxOrder + 1];  // [level][order]
};
const Table& Kernels();
}  // namespace levels

// One function for all items, by the matrix of its product.
namespace dense {
using ApplyFn = void (*)(const float* matrix, size_t count, const simd::InView& in,
                         const simd::OutView& out);
struct Table {
  ApplyFn apply[product::kMaxOrder + 1];  // [order]; order^2 rows and columns
};
const Table& Kernels();
// Of products with f.
std::vector<float> MatrixOf(int order, const float* f);
}  // namespace dense

}  // namespace gaunt::product::methods

#endif  // GAUNT_PRODUCT_METHODS_METHODS_H_
