// SPDX-License-Identifier: MIT
#include "bench/grid_baseline.h"

#include <algorithm>
#include <cmath>

namespace gaunt::bench {
namespace {

struct Vec3 {
  float x, y, z;
};

bool IsValid(const uint32_t* valid, uint32_t index) {
  return valid == nullptr || (valid[index >> 5] >> (index & 31) & 1) != 0;
}

void Blend(const Vec3& f, uint32_t first, uint32_t step_y, uint32_t step_z, const uint32_t* valid,
           uint32_t* indices, float* weights) {
  float sum = 0.0f;
  for (uint32_t t = 0; t < 8; ++t) {
    const bool x = (t & 1) != 0, y = (t & 2) != 0, z = (t & 4) != 0;
    const uint32_t index = first + (x ? 1 : 0) + (y ? step_y : 0) + (z ? step_z : 0);
    const float weight = (x ? f.x : 1.0f - f.x) * (y ? f.y : 1.0f - f.y) * (z ? f.z : 1.0f - f.z);
    const bool is_valid = IsValid(valid, index);
    indices[t] = is_valid ? index : GAUNT_NO_PROBE;
    weights[t] = is_valid ? weight : 0.0f;
    sum += weights[t];
  }
  if (valid != nullptr && sum > 0.0f) {
    for (int t = 0; t < 8; ++t) weights[t] /= sum;
  }
}

float Coordinate(float position, float origin, float inverse, uint32_t last) {
  return std::clamp((position - origin) * inverse, 0.0f, static_cast<float>(last));
}

// Out of line: engines call them across files, once per object.
[[gnu::noinline]] void FindGrid(const gaunt_grid& grid, const Vec3& inverse, const Vec3& p,
                                const uint32_t* valid, uint32_t* indices, float* weights) {
  const uint32_t* const size = grid.size;
  Vec3 u = {Coordinate(p.x, grid.origin[0], inverse.x, size[0] - 1),
            Coordinate(p.y, grid.origin[1], inverse.y, size[1] - 1),
            Coordinate(p.z, grid.origin[2], inverse.z, size[2] - 1)};
  const uint32_t x = std::min(static_cast<uint32_t>(u.x), size[0] - 2);
  const uint32_t y = std::min(static_cast<uint32_t>(u.y), size[1] - 2);
  const uint32_t z = std::min(static_cast<uint32_t>(u.z), size[2] - 2);
  u = {u.x - static_cast<float>(x), u.y - static_cast<float>(y), u.z - static_cast<float>(z)};
  Blend(u, x + size[0] * (y + size[1] * z), size[0], size[0] * size[1], valid, indices, weights);
}

[[gnu::noinline]] void FindBrick(const gaunt_bricks& bricks, const gaunt_brick_cell* cells,
                                 const Vec3& inverse, const Vec3& p, uint32_t* indices,
                                 float* weights) {
  const uint32_t* const size = bricks.size;
  const Vec3 u = {Coordinate(p.x, bricks.origin[0], inverse.x, size[0]),
                  Coordinate(p.y, bricks.origin[1], inverse.y, size[1]),
                  Coordinate(p.z, bricks.origin[2], inverse.z, size[2])};
  const uint32_t x = std::min(static_cast<uint32_t>(u.x), size[0] - 1);
  const uint32_t y = std::min(static_cast<uint32_t>(u.y), size[1] - 1);
  const uint32_t z = std::min(static_cast<uint32_t>(u.z), size[2] - 1);
  const gaunt_brick_cell& cell = cells[x + size[0] * (y + size[1] * z)];
  if (cell.first == GAUNT_NO_PROBE) {
    std::fill_n(indices, 8, GAUNT_NO_PROBE);
    std::fill_n(weights, 8, 0.0f);
    return;
  }
  const uint32_t edge = bricks.probes;
  const auto inside = [&](float v, uint32_t c, uint32_t* whole) {
    const float begin = static_cast<float>(c - c % cell.size);
    const float t = (v - begin) / static_cast<float>(cell.size) * static_cast<float>(edge - 1);
    *whole = std::min(static_cast<uint32_t>(t), edge - 2);
    return t - static_cast<float>(*whole);
  };
  uint32_t c[3];
  Vec3 f;
  f.x = inside(u.x, x, &c[0]);
  f.y = inside(u.y, y, &c[1]);
  f.z = inside(u.z, z, &c[2]);
  Blend(f, cell.first + c[0] + edge * (c[1] + edge * c[2]), edge, edge * edge, nullptr, indices,
        weights);
}

}  // namespace

void GridEngine(const gaunt_grid& grid, size_t count, const float* positions, const uint32_t* valid,
                uint32_t* indices, float* weights) {
  const Vec3 inverse = {1.0f / grid.spacing[0], 1.0f / grid.spacing[1], 1.0f / grid.spacing[2]};
  for (size_t i = 0; i < count; ++i) {
    const float* const p = positions + 3 * i;
    FindGrid(grid, inverse, {p[0], p[1], p[2]}, valid, indices + 8 * i, weights + 8 * i);
  }
}

void BricksEngine(const gaunt_bricks& bricks, const gaunt_brick_cell* cells, size_t count,
                  const float* positions, uint32_t* indices, float* weights) {
  const Vec3 inverse = {1.0f / bricks.spacing[0], 1.0f / bricks.spacing[1],
                        1.0f / bricks.spacing[2]};
  for (size_t i = 0; i < count; ++i) {
    const float* const p = positions + 3 * i;
    FindBrick(bricks, cells, inverse, {p[0], p[1], p[2]}, indices + 8 * i, weights + 8 * i);
  }
}

}  // namespace gaunt::bench
