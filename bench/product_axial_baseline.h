// SPDX-License-Identifier: MIT
// Products with functions about z in scalar code, one channel, interleaved items, compiled like a
// user's code.
#ifndef GAUNT_BENCH_PRODUCT_AXIAL_BASELINE_H_
#define GAUNT_BENCH_PRODUCT_AXIAL_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// What an engine has: the non-zeros of the tensor, and of the matrix, in a list that each item runs
// through. Order 6.
void ZonalSparse(size_t count, const float* zonal, const float* b, float* out);
void HemisphereSparse(size_t count, const float* in, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PRODUCT_AXIAL_BASELINE_H_
