// SPDX-License-Identifier: MIT
// Trilinear interpolation between probes on a lattice: which eight of them, and how much of each.
#ifndef GAUNT_GRID_GRID_H_
#define GAUNT_GRID_GRID_H_

#include <cstddef>
#include <cstdint>

#include "simd/view.h"

namespace gaunt::grid {

inline constexpr size_t kTaps = 8;
// Where a probe beside is not valid, fractions of a cell keep this distance from 0 and 1: the others
// always have a weight to share.
inline constexpr double kLeastFraction = 0x1p-20;

// Coordinates of a position: (position - origin) scale, from 0 to `last` along each axis.
struct Lattice {
  float origin[3];
  float scale[3];
  float last[3];
};

// A probe at every whole coordinate.
struct Grid {
  Lattice lattice;
  uint32_t first;
  uint32_t strides[3];
};

// Cells between whole coordinates, each of which names a brick: pairs of the first probe and the
// cells that the brick covers along each axis.
struct Bricks {
  Lattice lattice;
  const uint32_t* cells;
  uint32_t cell_strides[3];
  uint32_t probes;      // along each edge of a brick
  uint32_t strides[3];  // of a brick's probes
  uint32_t last_first;  // of the bricks that lie inside the probes
};

// Bits of the probes that take part, or null: all do.
using ValidBits = const uint32_t*;

struct Table {
  void (*grid)(const Grid& grid, size_t count, const simd::InView& positions, ValidBits valid,
               uint32_t* indices, float* weights);
  void (*bricks)(const Bricks& bricks, size_t count, const simd::InView& positions, ValidBits valid,
                 uint32_t* indices, float* weights);
};

const Table& Kernels();

}  // namespace gaunt::grid

#endif  // GAUNT_GRID_GRID_H_
