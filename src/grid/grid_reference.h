// SPDX-License-Identifier: MIT
// Trilinear interpolation by its definition, in double precision.
#ifndef GAUNT_GRID_GRID_REFERENCE_H_
#define GAUNT_GRID_GRID_REFERENCE_H_

#include <cstdint>
#include <functional>
#include <map>

#include "gaunt/gaunt.h"

namespace gaunt::grid {

// Weights of indices; those without a weight are missing. Indices that are one probe add up.
using WeightsReference = std::map<uint32_t, double>;

// Whether an index takes part.
using IsValid = std::function<bool(uint32_t index)>;

WeightsReference GridReference(const gaunt_grid& grid, const float* position,
                               const IsValid& is_valid);
WeightsReference BricksReference(const gaunt_bricks& bricks, const gaunt_brick_cell* cells,
                                 const float* position, const IsValid& is_valid);

// The coordinate of a position along an axis, clamped to 0 .. last.
double CoordinateReference(double position, double origin, double spacing, double last);

}  // namespace gaunt::grid

#endif  // GAUNT_GRID_GRID_REFERENCE_H_
