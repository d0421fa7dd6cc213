// SPDX-License-Identifier: MIT
#include "bench/project_baseline.h"

#include <cmath>

#include "bench/basis_baseline.h"

namespace gaunt::bench {
namespace {

void AddTexel(int order, const float direction[3], float weight, const float* texel, float* out) {
  float y[36];
  (order == 3 ? BasisEngine3 : BasisEngine6)(1, direction, y);
  const int n = order * order;
  const float r = weight * texel[0], g = weight * texel[1], b = weight * texel[2];
  for (int i = 0; i < n; ++i) {
    out[i] += r * y[i];
    out[n + i] += g * y[i];
    out[2 * n + i] += b * y[i];
  }
}

}  // namespace

void CubemapEngine(int order, size_t size, const float* const faces[6], float* out) {
  for (int i = 0; i < 3 * order * order; ++i) out[i] = 0.0f;
  const float scale = 2.0f / static_cast<float>(size);
  for (int face = 0; face < 6; ++face) {
    const float* texel = faces[face];
    for (size_t row = 0; row < size; ++row) {
      const float v = scale * (static_cast<float>(row) + 0.5f) - 1.0f;
      for (size_t column = 0; column < size; ++column, texel += 4) {
        const float u = scale * (static_cast<float>(column) + 0.5f) - 1.0f;
        const float r2 = u * u + v * v + 1.0f, scale_to_unit = 1.0f / std::sqrt(r2);
        float x, y, z;
        switch (face) {
          case 0: x = 1.0f, y = -v, z = -u; break;
          case 1: x = -1.0f, y = -v, z = u; break;
          case 2: x = u, y = 1.0f, z = v; break;
          case 3: x = u, y = -1.0f, z = -v; break;
          case 4: x = u, y = -v, z = 1.0f; break;
          default: x = -u, y = -v, z = -1.0f; break;
        }
        const float direction[3] = {x * scale_to_unit, y * scale_to_unit, z * scale_to_unit};
        AddTexel(order, direction, scale * scale * scale_to_unit / r2, texel, out);
      }
    }
  }
}

void EquirectEngine(int order, size_t width, size_t height, const float* texels, float* out) {
  for (int i = 0; i < 3 * order * order; ++i) out[i] = 0.0f;
  constexpr float kPi = 3.14159265f;
  const float turn = 2.0f * kPi / static_cast<float>(width);
  const float step = kPi / static_cast<float>(height);
  for (size_t row = 0; row < height; ++row) {
    const float theta = step * (static_cast<float>(row) + 0.5f);
    const float sine = std::sin(theta), z = std::cos(theta);
    for (size_t column = 0; column < width; ++column, texels += 3) {
      const float phi = kPi - turn * (static_cast<float>(column) + 0.5f);
      const float direction[3] = {sine * std::cos(phi), sine * std::sin(phi), z};
      AddTexel(order, direction, turn * step * sine, texels, out);
    }
  }
}

}  // namespace gaunt::bench
