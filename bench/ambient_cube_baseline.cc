// SPDX-License-Identifier: MIT
#include "bench/ambient_cube_baseline.h"

namespace gaunt::bench {
namespace {

const float kAxes[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// Out of line: engines call them across files, once per item.
[[gnu::noinline]] void Irradiance(const float* f, const float n[3], float* out) {
  const float x = n[0], y = n[1], z = n[2];
  const float basis[9] = {0.282094792f,
                          -0.325735008f * y,
                          0.325735008f * z,
                          -0.325735008f * x,
                          0.273137108f * x * y,
                          -0.273137108f * y * z,
                          0.078847891f * (3.0f * z * z - 1.0f),
                          -0.273137108f * x * z,
                          0.136568554f * (x * x - y * y)};
  for (int c = 0; c < 3; ++c) {
    float sum = 0.0f;
    for (int i = 0; i < 9; ++i) sum += basis[i] * f[9 * c + i];
    out[c] = sum;
  }
}

[[gnu::noinline]] void AmbientLight(const float n[3], const float* cube, float* out) {
  const float xx = n[0] * n[0], yy = n[1] * n[1], zz = n[2] * n[2];
  const float* const x = cube + (n[0] < 0.0f ? 3 : 0);
  const float* const y = cube + (n[1] < 0.0f ? 9 : 6);
  const float* const z = cube + (n[2] < 0.0f ? 15 : 12);
  for (int c = 0; c < 3; ++c) out[c] = xx * x[c] + yy * y[c] + zz * z[c];
}

[[gnu::noinline]] void AddFace(const float n[3], const float* face, float* f) {
  const float factors[9] = {0.590817950f,
                            -1.151242546f * n[1],
                            1.151242546f * n[2],
                            -1.151242546f * n[0],
                            0.0f,
                            0.0f,
                            1.056887279f * (3.0f * n[2] * n[2] - 1.0f),
                            0.0f,
                            1.830582466f * (n[0] * n[0] - n[1] * n[1])};
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 9; ++i) f[9 * c + i] += factors[i] * face[c];
  }
}

}  // namespace

void AmbientCubeEngineSample(size_t count, const float* radiance, float* cube) {
  for (size_t i = 0; i < count; ++i) {
    for (int face = 0; face < 6; ++face) {
      Irradiance(radiance + 27 * i, kAxes[face], cube + 18 * i + 3 * face);
    }
  }
}

void AmbientCubeEngineEvaluate(size_t count, const float* cubes, const float* normals, float* out) {
  for (size_t i = 0; i < count; ++i) AmbientLight(normals + 3 * i, cubes + 18 * i, out + 3 * i);
}

void AmbientCubeEngineEvaluateOne(size_t count, const float* cube, const float* normals,
                                  float* out) {
  for (size_t i = 0; i < count; ++i) AmbientLight(normals + 3 * i, cube, out + 3 * i);
}

void AmbientCubeEngineToSh(size_t count, const float* cubes, float* radiance) {
  for (size_t i = 0; i < count; ++i, radiance += 27) {
    for (int p = 0; p < 27; ++p) radiance[p] = 0.0f;
    for (int face = 0; face < 6; ++face) AddFace(kAxes[face], cubes + 18 * i + 3 * face, radiance);
  }
}

}  // namespace gaunt::bench
