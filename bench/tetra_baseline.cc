// SPDX-License-Identifier: MIT
#include "bench/tetra_baseline.h"

#include <algorithm>

namespace gaunt::bench {
namespace {

struct Vec3 {
  float x, y, z;
};
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Out of line: engines call it once per object.
[[gnu::noinline]] int32_t Find(const std::vector<EngineTetrahedron>& mesh, const Vec3& p,
                               int32_t at, uint32_t* indices, float* weights) {
  float b[4] = {};
  for (size_t step = 0; step < mesh.size(); ++step) {
    const EngineTetrahedron& t = mesh[static_cast<size_t>(at)];
    const Vec3 from = p - Vec3{t.corner[0], t.corner[1], t.corner[2]};
    b[3] = 1.0f;
    for (int i = 0; i < 3; ++i) {
      b[i] = Dot({t.matrix[3 * i], t.matrix[3 * i + 1], t.matrix[3 * i + 2]}, from);
      b[3] -= b[i];
    }
    int lowest = 0;
    for (int i = 1; i < 4; ++i) {
      if (b[i] < b[lowest]) lowest = i;
    }
    if (b[lowest] >= -1e-6f || t.neighbours[lowest] < 0) break;
    at = t.neighbours[lowest];
  }
  float sum = 0.0f;
  for (int i = 0; i < 4; ++i) {
    indices[i] = mesh[static_cast<size_t>(at)].corners[i];
    weights[i] = std::max(b[i], 0.0f);
    sum += weights[i];
  }
  for (int i = 0; i < 4; ++i) weights[i] /= sum;
  return at;
}

}  // namespace

std::vector<EngineTetrahedron> EngineMesh(const std::vector<float>& vertices,
                                          const std::vector<uint32_t>& corners,
                                          const std::vector<uint32_t>& neighbours) {
  std::vector<EngineTetrahedron> mesh(corners.size() / 4);
  for (size_t t = 0; t < mesh.size(); ++t) {
    Vec3 v[4];
    for (size_t i = 0; i < 4; ++i) {
      const uint32_t corner = corners[4 * t + i];
      mesh[t].corners[i] = corner;
      mesh[t].neighbours[i] = static_cast<int32_t>(neighbours[4 * t + i]);
      v[i] = {vertices[3 * corner], vertices[3 * corner + 1], vertices[3 * corner + 2]};
    }
    const Vec3 a = v[0] - v[3], b = v[1] - v[3], c = v[2] - v[3];
    const float volume = Dot(a, Cross(b, c));
    const Vec3 rows[3] = {Cross(b, c), Cross(c, a), Cross(a, b)};
    for (size_t i = 0; i < 3; ++i) {
      mesh[t].matrix[3 * i] = rows[i].x / volume;
      mesh[t].matrix[3 * i + 1] = rows[i].y / volume;
      mesh[t].matrix[3 * i + 2] = rows[i].z / volume;
    }
    mesh[t].corner[0] = v[3].x;
    mesh[t].corner[1] = v[3].y;
    mesh[t].corner[2] = v[3].z;
  }
  return mesh;
}

void TetrahedraEngine(const std::vector<EngineTetrahedron>& mesh, size_t count,
                      const float* positions, uint32_t* tetrahedra, uint32_t* indices,
                      float* weights) {
  for (size_t i = 0; i < count; ++i) {
    const float* const p = positions + 3 * i;
    tetrahedra[i] =
        static_cast<uint32_t>(Find(mesh, {p[0], p[1], p[2]}, static_cast<int32_t>(tetrahedra[i]),
                                   indices + 4 * i, weights + 4 * i));
  }
}

}  // namespace gaunt::bench
