// SPDX-License-Identifier: MIT
// Trilinear interpolation by its definition, in double precision.
#ifndef GAUNT_GRID_GRID_REFERENCE_H_
#define GAUNT_GRID_GRID_REFERENCE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <map>

#include "gaunt/gaunt.h"

namespace gaunt::grid {

// Weights of indices; those without a weight are missing. Indices that are one probe add up.
using WeightsReference = std::map<uint32_t, double>;

// Whether an index takes part.
using IsValid = std::function<bool(uint32_t index)>;

struct TapsReference {
  WeightsReference weights;
  double sum = 0.0;                  // of the weights, before they are divided by it
  double coordinates = 0.0;          // of which floats round a share: the sum in the manual's bound
  uint32_t corner = GAUNT_NO_PROBE;  // the lowest of the eight, valid or not
  bool all_valid = false;
};

// Coordinates u are times 1 + nudge first, to reach the cells beside.
using Nudge = std::array<double, 3>;

TapsReference GridReference(const gaunt_grid& grid, const float* position, const IsValid& is_valid,
                            const Nudge& nudge = {});
TapsReference BricksReference(const gaunt_bricks& bricks, const gaunt_brick_cell* cells,
                              const float* position, const IsValid& is_valid,
                              const Nudge& nudge = {});

// The coordinate of a position along an axis, clamped to 0 .. last.
double CoordinateReference(double position, double origin, double spacing, double last);

}  // namespace gaunt::grid

#endif  // GAUNT_GRID_GRID_REFERENCE_H_
