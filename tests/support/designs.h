// SPDX-License-Identifier: MIT
// Spherical designs: 4 pi times the mean over the points is the integral over the sphere, for
// polynomials of a degree up to the design's strength.
#ifndef GAUNT_TESTS_SUPPORT_DESIGNS_H_
#define GAUNT_TESTS_SUPPORT_DESIGNS_H_

#include <stdexcept>

#include "points/point_set.h"
#include "tests/support/design_points.h"

namespace gaunt::test {

inline points::PointSet MakeSet(const double (*points)[3], int count) {
  points::PointSet set;
  for (int i = 0; i < count; ++i) set.push_back({points[i][0], points[i][1], points[i][2]});
  return set;
}

// The smallest of the committed designs that has at least this strength.
inline points::PointSet SphericalDesign(int strength) {
  for (const DesignPointsSet& design : kDesignPoints) {
    if (design.strength >= strength) return MakeSet(design.points, design.count);
  }
  throw std::out_of_range("no design of that strength; see tools/points.sh");
}

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_DESIGNS_H_
