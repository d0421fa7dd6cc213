// SPDX-License-Identifier: MIT
// Minimises a sum over pairs of points on the sphere by damped Newton steps. Only operations that
// IEEE 754 defines to the bit are used, so that results are the same on every machine.
#ifndef GAUNT_POINTS_DESCENT_H_
#define GAUNT_POINTS_DESCENT_H_

#include <functional>
#include <vector>

#include "points/point_set.h"

namespace gaunt::points {

// A function of the cosine between two points, with its derivatives by that cosine.
struct PairTerm {
  double value, slope, curvature;
};
using PairFunction = std::function<PairTerm(double squared_distance)>;

// The sum over all pairs of different points, each counted once.
double SumOverPairs(const PairFunction& function, const PointSet& points);

enum class Step {
  kNewton,      // for every function
  kGaussNewton  // for an inner product of features of the points, whose sum is to vanish
};

struct Descent {
  PointSet points;
  double value = 0.0;     // of the sum over pairs
  double gradient = 0.0;  // its Euclidean norm along the sphere
};

// Descends from a start until the gradient is as small as rounding lets it be. Gives up where that
// takes too long: see the gradient.
Descent Descend(const PairFunction& function, Step step, const PointSet& start);

// One undamped step with a gradient, in space, that is known better than the function gives it.
// None where the function does not determine one.
PointSet GaussNewtonStep(const PairFunction& function, const PointSet& points,
                         const std::vector<Point>& gradient);

}  // namespace gaunt::points

#endif  // GAUNT_POINTS_DESCENT_H_
