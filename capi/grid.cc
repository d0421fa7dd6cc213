// SPDX-License-Identifier: MIT
#include "grid/grid.h"

#include <cmath>

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::grid::Bricks;
using gaunt::grid::Grid;
using gaunt::grid::kTaps;
using gaunt::grid::Lattice;

namespace {

constexpr uint32_t kMaxSize = 65536;
constexpr uint64_t kMaxCells = 1u << 28;
constexpr uint32_t kMaxBrickProbes = 256;

gaunt_status CheckLattice(const uint32_t (&size)[3], const float (&origin)[3],
                          const float (&spacing)[3]) {
  for (int a = 0; a < 3; ++a) {
    const float step = std::fabs(spacing[a]);
    GAUNT_REQUIRE(InRange(size[a], 1, kMaxSize), GAUNT_ERROR_RANGE);
    GAUNT_REQUIRE(std::isfinite(origin[a]), GAUNT_ERROR_RANGE);
    GAUNT_REQUIRE(step >= 1e-30f && step <= 1e30f, GAUNT_ERROR_RANGE);
  }
  return GAUNT_OK;
}

Lattice LatticeOf(const float (&origin)[3], const float (&spacing)[3], const uint32_t (&last)[3]) {
  Lattice lattice;
  for (int a = 0; a < 3; ++a) {
    lattice.origin[a] = origin[a];
    lattice.scale[a] = 1.0f / spacing[a];
    lattice.last[a] = static_cast<float>(last[a]);
  }
  return lattice;
}

// Strides as they are, or those of x fastest.
void StridesOf(const uint32_t (&strides)[3], const uint32_t (&size)[3], uint32_t (&out)[3]) {
  const bool is_default = strides[0] == 0 && strides[1] == 0 && strides[2] == 0;
  out[0] = is_default ? 1 : strides[0];
  out[1] = is_default ? size[0] : strides[1];
  out[2] = is_default ? size[0] * size[1] : strides[2];
}

// From the first index to the largest.
uint64_t SpanOf(const uint32_t (&size)[3], const uint32_t (&strides)[3]) {
  uint64_t span = 0;
  for (int a = 0; a < 3; ++a) span += (size[a] - uint64_t{1}) * strides[a];
  return span;
}

// Bits of `probes` probes, where there are some.
MemoryCheck& AddValid(MemoryCheck& check, size_t count, const uint32_t* valid, uint64_t probes) {
  if (valid == nullptr || count == 0) return check;
  constexpr size_t kWord = sizeof(*valid);
  return check.InRecords(valid, static_cast<size_t>((probes + 31) / 32), kWord, kWord);
}

MemoryCheck& AddTaps(MemoryCheck& check, size_t count, const uint32_t* indices,
                     const float* weights) {
  return check.OutRecords(indices, count * kTaps, sizeof(*indices), sizeof(*indices))
      .OutRecords(weights, count * kTaps, sizeof(*weights), sizeof(*weights));
}

}  // namespace

extern "C" {

gaunt_status gaunt_grid_taps(const gaunt_grid* grid, size_t count, const gaunt_view* positions,
                             const uint32_t* valid, uint32_t* indices, float* weights) {
  GAUNT_REQUIRE(grid != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(grid->struct_size == sizeof(*grid), GAUNT_ERROR_STRUCT);
  GAUNT_CHECK(CheckLattice(grid->size, grid->origin, grid->spacing));
  Grid kernel_grid;
  StridesOf(grid->strides, grid->size, kernel_grid.strides);
  const uint64_t largest = grid->first + SpanOf(grid->size, kernel_grid.strides);
  GAUNT_REQUIRE(largest < GAUNT_NO_PROBE, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(count <= SIZE_MAX / kTaps, GAUNT_ERROR_RANGE);
  MemoryCheck check(count);
  check.In(positions, 3);
  AddValid(check, count, valid, largest + 1);
  GAUNT_CHECK(AddTaps(check, count, indices, weights).status());
  if (count == 0) return GAUNT_OK;
  const uint32_t last[3] = {grid->size[0] - 1, grid->size[1] - 1, grid->size[2] - 1};
  kernel_grid.lattice = LatticeOf(grid->origin, grid->spacing, last);
  kernel_grid.first = grid->first;
  gaunt::grid::Kernels().grid(kernel_grid, count, InputOf(*positions, count), valid, indices,
                              weights);
  return GAUNT_OK;
}

gaunt_status gaunt_brick_taps(const gaunt_bricks* bricks, const gaunt_brick_cell* cells,
                              size_t count, const gaunt_view* positions, const uint32_t* valid,
                              uint32_t* indices, float* weights) {
  static_assert(sizeof(gaunt_brick_cell) == 2 * sizeof(uint32_t), "cells are pairs");
  GAUNT_REQUIRE(bricks != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(bricks->struct_size == sizeof(*bricks), GAUNT_ERROR_STRUCT);
  GAUNT_CHECK(CheckLattice(bricks->size, bricks->origin, bricks->spacing));
  const uint64_t cell_count = uint64_t{bricks->size[0]} * bricks->size[1] * bricks->size[2];
  GAUNT_REQUIRE(cell_count <= kMaxCells, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(InRange(bricks->probes, 2, kMaxBrickProbes), GAUNT_ERROR_RANGE);
  const uint32_t edge[3] = {bricks->probes, bricks->probes, bricks->probes};
  Bricks kernel_bricks;
  StridesOf(bricks->strides, edge, kernel_bricks.strides);
  const uint64_t span = SpanOf(edge, kernel_bricks.strides);
  GAUNT_REQUIRE(span < bricks->probe_count, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(count <= SIZE_MAX / kTaps, GAUNT_ERROR_RANGE);
  MemoryCheck check(count);
  check.In(positions, 3);
  check.InRecords(cells, count == 0 ? 0 : static_cast<size_t>(cell_count), sizeof(*cells),
                  sizeof(*cells));
  AddValid(check, count, valid, bricks->probe_count);
  GAUNT_CHECK(AddTaps(check, count, indices, weights).status());
  if (count == 0) return GAUNT_OK;
  kernel_bricks.lattice = LatticeOf(bricks->origin, bricks->spacing, bricks->size);
  kernel_bricks.cells = reinterpret_cast<const uint32_t*>(cells);
  StridesOf({0, 0, 0}, bricks->size, kernel_bricks.cell_strides);
  kernel_bricks.probes = bricks->probes;
  kernel_bricks.last_first = bricks->probe_count - 1 - static_cast<uint32_t>(span);
  gaunt::grid::Kernels().bricks(kernel_bricks, count, InputOf(*positions, count), valid, indices,
                                weights);
  return GAUNT_OK;
}

}  // extern "C"
