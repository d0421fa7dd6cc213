// SPDX-License-Identifier: MIT
// Irradiance as engines evaluate it on the CPU, compiled like a user's code.
#ifndef GAUNT_BENCH_EVALUATE_BASELINE_H_
#define GAUNT_BENCH_EVALUATE_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// E/pi of one RGB probe of order 3 for interleaved normals: a call per normal, from coefficients
// that are convolved already.
void IrradianceEngineOneProbe(size_t count, const float* normals, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_EVALUATE_BASELINE_H_
