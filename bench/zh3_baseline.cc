// SPDX-License-Identifier: MIT
#include "bench/zh3_baseline.h"

#include <algorithm>
#include <cmath>

namespace gaunt::bench {
namespace {

struct Vec3 {
  float x, y, z;
};

float Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 BandOf(const float* f) { return {-f[3], -f[1], f[2]}; }

Vec3 LuminanceAxis(const float* f, int stride) {
  const float weights[3] = {0.2126f, 0.7152f, 0.0722f};
  Vec3 sum = {0.0f, 0.0f, 0.0f};
  for (int c = 0; c < 3; ++c) {
    const Vec3 band = BandOf(f + c * stride);
    sum.x += weights[c] * band.x;
    sum.y += weights[c] * band.y;
    sum.z += weights[c] * band.z;
  }
  const float length = std::sqrt(Dot(sum, sum));
  if (!(length > 0.0f)) return {0.0f, 0.0f, 0.0f};
  return {sum.x / length, sum.y / length, sum.z / length};
}

// Out of line: engines call them across files, once per item.
[[gnu::noinline]] void Hallucinate(const float* f, float* k2) {
  const Vec3 axis = LuminanceAxis(f, 4);
  for (int c = 0; c < 3; ++c, f += 4) {
    const float ratio =
        f[0] > 0.0f ? std::min(std::abs(Dot(axis, BandOf(f))) / f[0], 1.7320508f) : 0.0f;
    k2[c] = f[0] * (0.08f * ratio + 0.6f * ratio * ratio);
  }
}

[[gnu::noinline]] void Solve(const float* f, float* k2) {
  const Vec3 a = LuminanceAxis(f, 9);
  const float root = 1.7320508f;
  const float band[5] = {root * a.x * a.y, -root * a.y * a.z, 1.5f * a.z * a.z - 0.5f,
                         -root * a.x * a.z, 0.5f * root * (a.x * a.x - a.y * a.y)};
  for (int c = 0; c < 3; ++c, f += 9) {
    k2[c] = 0.0f;
    for (int m = 0; m < 5; ++m) k2[c] += band[m] * f[4 + m];
  }
}

[[gnu::noinline]] void Irradiance(const float* f, const float* k2, const Vec3& n, float* out) {
  const Vec3 axis = LuminanceAxis(f, 4);
  const float cosine = Dot(axis, n);
  const float zonal = 0.0788478913f * (3.0f * cosine * cosine - 1.0f);
  for (int c = 0; c < 3; ++c, f += 4) {
    out[c] = 0.2820947918f * f[0] + 0.3257350079f * Dot(BandOf(f), n) + zonal * k2[c];
  }
}

[[gnu::noinline]] void Geomerics(const float* f, const Vec3& n, float* out) {
  for (int c = 0; c < 3; ++c, f += 4) {
    const Vec3 band = BandOf(f);
    const float length = std::sqrt(Dot(band, band));
    const float mean = 0.2820947918f * f[0];
    const float s = f[0] > 0.0f ? std::min(length / (1.7320508f * f[0]), 1.0f) : 0.0f;
    const float q = length > 0.0f ? 0.5f * (1.0f + Dot(band, n) / length) : 0.5f;
    const float p = 1.0f + 2.0f * s, a = (1.0f - s) / (1.0f + s);
    out[c] = mean * (a + (1.0f - a) * (p + 1.0f) * std::pow(std::max(q, 0.0f), p));
  }
}

}  // namespace

void Zh3EngineHallucinate(size_t count, const float* sh2, float* k2) {
  for (size_t i = 0; i < count; ++i) Hallucinate(sh2 + 12 * i, k2 + 3 * i);
}

void Zh3EngineSolve(size_t count, const float* sh3, float* k2) {
  for (size_t i = 0; i < count; ++i) Solve(sh3 + 27 * i, k2 + 3 * i);
}

void Zh3EngineIrradiance(size_t count, const float* sh2, const float* k2, const float* normals,
                         float* out) {
  for (size_t i = 0; i < count; ++i) {
    const float* const n = normals + 3 * i;
    Irradiance(sh2 + 12 * i, k2 + 3 * i, {n[0], n[1], n[2]}, out + 3 * i);
  }
}

void GeomericsEngine(size_t count, const float* sh2, const float* normals, float* out) {
  for (size_t i = 0; i < count; ++i) {
    const float* const n = normals + 3 * i;
    Geomerics(sh2 + 12 * i, {n[0], n[1], n[2]}, out + 3 * i);
  }
}

}  // namespace gaunt::bench
