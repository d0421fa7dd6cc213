// SPDX-License-Identifier: MIT
// The ambient cube as engines have it, compiled like a user's code. Interleaved items: order 3 of
// RGB, six RGB texels, normals.
#ifndef GAUNT_BENCH_AMBIENT_CUBE_BASELINE_H_
#define GAUNT_BENCH_AMBIENT_CUBE_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// E/pi of order 3 at the six axes.
void AmbientCubeEngineSample(size_t count, const float* radiance, float* cube);
// The source's lookup, of a cube and a normal each, and of one cube.
void AmbientCubeEngineEvaluate(size_t count, const float* cubes, const float* normals, float* out);
void AmbientCubeEngineEvaluateOne(size_t count, const float* cube, const float* normals,
                                  float* out);
// The sum over the faces of radiance of order 3.
void AmbientCubeEngineToSh(size_t count, const float* cubes, float* radiance);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_AMBIENT_CUBE_BASELINE_H_
