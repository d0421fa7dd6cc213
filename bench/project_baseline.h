// SPDX-License-Identifier: MIT
// Projection as the scalar loop that engines have, compiled like a user's code: a direction and a
// weight per texel, the basis of the direction, sums in float.
#ifndef GAUNT_BENCH_PROJECT_BASELINE_H_
#define GAUNT_BENCH_PROJECT_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// Six faces of size^2 texels of 4 floats, of which 3 go to out[3 * order^2]; order 3 or 6.
void CubemapEngine(int order, size_t size, const float* const faces[6], float* out);
// Texels of 3 floats.
void EquirectEngine(int order, size_t width, size_t height, const float* texels, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PROJECT_BASELINE_H_
