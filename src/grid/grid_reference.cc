// SPDX-License-Identifier: MIT
#include "grid/grid_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gaunt::grid {
namespace {

// Probes `indices` at the corners of a cell, and a position at `f` inside it.
TapsReference Blend(const uint32_t (&indices)[2][2][2], const double (&f)[3],
                    const IsValid& is_valid) {
  TapsReference taps;
  taps.corner = indices[0][0][0];
  taps.all_valid = true;
  for (const auto& slice : indices) {
    for (const auto& row : slice) {
      taps.all_valid = taps.all_valid && is_valid(row[0]) && is_valid(row[1]);
    }
  }
  const double least = taps.all_valid ? 0.0 : std::ldexp(1.0, -20);
  for (int z = 0; z < 2; ++z) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        const uint32_t index = indices[z][y][x];
        if (!is_valid(index)) continue;
        // Tent functions of the distance from the probe.
        const int corner[3] = {x, y, z};
        double weight = 1.0;
        for (int a = 0; a < 3; ++a) {
          const double kept = std::min(std::max(f[a], least), 1.0 - least);
          weight *= 1.0 - std::abs(kept - corner[a]);
        }
        taps.sum += weight;
        if (weight > 0.0) taps.weights[index] += weight;
      }
    }
  }
  for (auto& [index, weight] : taps.weights) weight /= taps.sum;
  return taps;
}

// A lattice of size^3 probes and a position in its coordinates.
TapsReference BlendLattice(const uint32_t (&size)[3], uint64_t first, const uint32_t (&strides)[3],
                           const double (&u)[3], const IsValid& is_valid) {
  uint64_t step[3] = {strides[0], strides[1], strides[2]};
  if (step[0] + step[1] + step[2] == 0) {
    step[0] = 1;
    step[1] = size[0];
    step[2] = uint64_t{size[0]} * size[1];
  }
  uint32_t indices[2][2][2];
  double f[3];
  uint64_t node[3][2];
  for (int a = 0; a < 3; ++a) {
    const double most = std::max(0.0, size[a] - 2.0);
    const double cell = std::min(std::floor(u[a]), most);
    f[a] = u[a] - cell;
    node[a][0] = static_cast<uint64_t>(cell);
    node[a][1] = std::min<uint64_t>(node[a][0] + 1, size[a] - 1);
  }
  for (int z = 0; z < 2; ++z) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        indices[z][y][x] = static_cast<uint32_t>(first + node[0][x] * step[0] +
                                                 node[1][y] * step[1] + node[2][z] * step[2]);
      }
    }
  }
  return Blend(indices, f, is_valid);
}

}  // namespace

double CoordinateReference(double position, double origin, double spacing, double last) {
  return std::min(std::max((position - origin) / spacing, 0.0), last);
}

TapsReference GridReference(const gaunt_grid& grid, const float* position, const IsValid& is_valid,
                            const Nudge& nudge) {
  double u[3];
  for (size_t a = 0; a < 3; ++a) {
    if (std::isnan(position[a])) return {};
    const double last = grid.size[a] - 1.0;
    u[a] = CoordinateReference(position[a], grid.origin[a], grid.spacing[a], last);
    u[a] = std::min(u[a] * (1.0 + nudge[a]), last);
  }
  TapsReference taps = BlendLattice(grid.size, grid.first, grid.strides, u, is_valid);
  taps.coordinates = u[0] + u[1] + u[2];
  return taps;
}

TapsReference BricksReference(const gaunt_bricks& bricks, const gaunt_brick_cell* cells,
                              const float* position, const IsValid& is_valid, const Nudge& nudge) {
  double u[3];
  uint64_t cell[3];
  for (size_t a = 0; a < 3; ++a) {
    if (std::isnan(position[a])) return {};
    const double last = bricks.size[a];
    u[a] = CoordinateReference(position[a], bricks.origin[a], bricks.spacing[a], last);
    u[a] = std::min(u[a] * (1.0 + nudge[a]), last);
    cell[a] = std::min<uint64_t>(static_cast<uint64_t>(u[a]), bricks.size[a] - 1);
  }
  const gaunt_brick_cell& named =
      cells[cell[0] + bricks.size[0] * (cell[1] + bricks.size[1] * cell[2])];
  const uint32_t edge = bricks.probes;
  const bool is_default = bricks.strides[0] + uint64_t{bricks.strides[1]} + bricks.strides[2] == 0;
  const uint64_t steps = is_default
                             ? 1 + edge + uint64_t{edge} * edge
                             : bricks.strides[0] + uint64_t{bricks.strides[1]} + bricks.strides[2];
  if (named.size == 0 || named.size > 65536 ||
      named.first + (edge - 1) * steps >= bricks.probe_count) {
    return {};
  }
  double v[3], coordinates = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double begin = static_cast<double>(cell[a] / named.size * named.size);
    v[a] = std::min((u[a] - begin) / named.size, 1.0) * (edge - 1.0);
    coordinates += v[a] + (edge - 1.0) * u[a] / named.size;
  }
  TapsReference taps = BlendLattice({edge, edge, edge}, named.first, bricks.strides, v, is_valid);
  taps.coordinates = coordinates;
  return taps;
}

}  // namespace gaunt::grid
