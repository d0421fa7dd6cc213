// SPDX-License-Identifier: MIT
// Zonal functions turned to directions as engines do it, compiled like a user's code.
#ifndef GAUNT_BENCH_ZONAL_BASELINE_H_
#define GAUNT_BENCH_ZONAL_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// A call per item, which evaluates the basis and multiplies each band. Up to order 6.
void ZonalEngine(int order, int channels, size_t count, const float* zonal, const float* directions,
                 float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_ZONAL_BASELINE_H_
