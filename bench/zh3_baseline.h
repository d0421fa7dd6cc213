// SPDX-License-Identifier: MIT
// ZH3 and Geomerics' lobe as engines have them, from the published shaders, compiled like a user's
// code. Interleaved items of RGB: order 2, k2, normals.
#ifndef GAUNT_BENCH_ZH3_BASELINE_H_
#define GAUNT_BENCH_ZH3_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// Luminance axis. k2 of the curve 0.08 r + 0.6 r^2.
void Zh3EngineHallucinate(size_t count, const float* sh2, float* k2);
// k2 of order 3.
void Zh3EngineSolve(size_t count, const float* sh3, float* k2);
// E/pi of a probe and a normal each.
void Zh3EngineIrradiance(size_t count, const float* sh2, const float* k2, const float* normals,
                         float* out);

// E/pi of a probe and a normal each.
void GeomericsEngine(size_t count, const float* sh2, const float* normals, float* out);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_ZH3_BASELINE_H_
