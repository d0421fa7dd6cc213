// SPDX-License-Identifier: MIT
// The basis in scalar code over interleaved directions, compiled like a user's code:
// Factored is the kernel's own arithmetic, one direction at a time; Engine is what engines have, a
// function for one direction with a polynomial for each coefficient.
#ifndef GAUNT_BENCH_BASIS_BASELINE_H_
#define GAUNT_BENCH_BASIS_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// The engines' function, up to order 6. Out of line: they call it across files.
[[gnu::noinline]] void BasisEngineEval(float* y, int order, const float direction[3]);

void BasisFactored3(size_t count, const float* directions, float* out);
void BasisFactored6(size_t count, const float* directions, float* out);
void BasisEngine3(size_t count, const float* directions, float* out);
void BasisEngine6(size_t count, const float* directions, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_BASIS_BASELINE_H_
