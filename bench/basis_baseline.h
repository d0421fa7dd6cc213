// SPDX-License-Identifier: MIT
// The basis as a scalar loop over interleaved directions: the kernel's own factored polynomials,
// one direction at a time, compiled like a user's code.
#ifndef GAUNT_BENCH_BASIS_BASELINE_H_
#define GAUNT_BENCH_BASIS_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

void BasisScalar3(size_t count, const float* directions, float* out);
void BasisScalar6(size_t count, const float* directions, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_BASIS_BASELINE_H_
