// SPDX-License-Identifier: MIT
// Points that repel each other like equal charges (Thomson's problem).
#ifndef GAUNT_POINTS_REPULSION_H_
#define GAUNT_POINTS_REPULSION_H_

#include <functional>

#include "points/point_set.h"

namespace gaunt::points {

// Shares of the work done, 0 to 1; may be null.
using ProgressFn = std::function<void(double)>;

// The sum over pairs of 1 / |p - q|.
double CoulombEnergy(const PointSet& set);

// The set of least energy among those that 20 random starts come to rest at, in canonical
// orientation; empty if none does. Tested to be the least energy known (Wales and Ulker 2006) for
// some numbers of points up to 37.
PointSet Repulsion(int count, const ProgressFn& progress = nullptr);

// A local minimum of the energy of points together with their opposites: the points only.
PointSet AntipodalRepulsion(int half_count, uint32_t seed);

}  // namespace gaunt::points

#endif  // GAUNT_POINTS_REPULSION_H_
