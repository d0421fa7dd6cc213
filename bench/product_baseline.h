// SPDX-License-Identifier: MIT
// Products in scalar code, one channel, interleaved items, compiled like a user's code. Both factors
// and the product have the same order.
#ifndef GAUNT_BENCH_PRODUCT_BASELINE_H_
#define GAUNT_BENCH_PRODUCT_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// What tools have: a loop over a table of the Gaunt coefficients that are not 0. Up to order 10.
void ProductByTable(int order, size_t count, const float* a, const float* b, float* out);

// What engines have: straight code, factored pair by pair, as in D3DX and DirectXMath.
inline constexpr int kMinPairsOrder = 2;
inline constexpr int kMaxPairsOrder = 6;
using ProductBaseline = void (*)(size_t count, const float* a, const float* b, float* out);
ProductBaseline ProductByPairs(int order);

// One function for all, by the matrix of its product.
void ProductByMatrix(int order, const float* matrix, size_t count, const float* in, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PRODUCT_BASELINE_H_
