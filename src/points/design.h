// SPDX-License-Identifier: MIT
// Spherical designs: points whose plain mean integrates polynomials exactly.
#ifndef GAUNT_POINTS_DESIGN_H_
#define GAUNT_POINTS_DESIGN_H_

#include "points/point_set.h"
#include "points/repulsion.h"

namespace gaunt::points {

// Points, each with its opposite, whose mean is exact for polynomials of degree up to an odd
// strength. About strength^2 / 2 of them; empty if none were found. In canonical orientation. The
// last steps take sines and cosines, so machines agree to 1e-12 only.
PointSet SymmetricDesign(int strength, const ProgressFn& progress = nullptr);

// The largest |mean of y_lm|, 1 <= l <= strength: 0 for an exact design.
double DesignResidual(int strength, const PointSet& set);

}  // namespace gaunt::points

#endif  // GAUNT_POINTS_DESIGN_H_
