// SPDX-License-Identifier: MIT
// Trilinear taps as engines find them, one position after the other, compiled like a user's code.
#ifndef GAUNT_BENCH_GRID_BASELINE_H_
#define GAUNT_BENCH_GRID_BASELINE_H_

#include <cstddef>
#include <cstdint>

#include "gaunt/gaunt.h"

namespace gaunt::bench {

// x fastest. `valid` may be null; positions are interleaved.
void GridEngine(const gaunt_grid& grid, size_t count, const float* positions, const uint32_t* valid,
                uint32_t* indices, float* weights);

// Bricks back to back.
void BricksEngine(const gaunt_bricks& bricks, const gaunt_brick_cell* cells, size_t count,
                  const float* positions, uint32_t* indices, float* weights);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_GRID_BASELINE_H_
