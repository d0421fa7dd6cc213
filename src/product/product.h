// SPDX-License-Identifier: MIT
// Products of two SH functions.
#ifndef GAUNT_PRODUCT_PRODUCT_H_
#define GAUNT_PRODUCT_PRODUCT_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::product {

inline constexpr int kMaxOrder = 10;  // of a factor
inline constexpr int kMaxOutOrder = 2 * kMaxOrder - 1;

// Of the factors and of the product, which is cut off at its order.
struct Orders {
  int a, b, out;
};

// Degrees without the bands that couple with nothing: none is above the sum of the others.
struct Degrees {
  int a, b, out;
};
constexpr Degrees Coupled(const Orders& orders) {
  const Degrees all = {orders.a - 1, orders.b - 1, orders.out - 1};
  const auto limit = [](int degree, int sum) { return degree < sum ? degree : sum; };
  return {limit(all.a, all.b + all.out), limit(all.b, all.a + all.out),
          limit(all.out, all.a + all.b)};
}

using ProductFn = void (*)(const Orders& orders, size_t channels, size_t count,
                           const simd::InView& a, const simd::InView& b, const simd::OutView& out);
using SquareFn = void (*)(int order, int out_order, size_t channels, size_t count,
                          const simd::InView& in, const simd::OutView& out);
// Products with a function b of which there are values at the points of the grid.
using PreparedFn = void (*)(const Orders& orders, const void* values, size_t channels, size_t count,
                            const simd::InView& a, const simd::OutView& out);

struct Table {
  ProductFn product;
  SquareFn square;
  PreparedFn prepared;  // of any orders
};

const Table& Kernels();

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_PRODUCT_H_
