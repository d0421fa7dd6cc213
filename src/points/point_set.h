// SPDX-License-Identifier: MIT
// Sets of points on the unit sphere, and what is measured of them.
#ifndef GAUNT_POINTS_POINT_SET_H_
#define GAUNT_POINTS_POINT_SET_H_

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gaunt::points {

using Point = std::array<double, 3>;
using PointSet = std::vector<Point>;

inline double Dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point Cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// a + t b
inline Point Along(const Point& a, double t, const Point& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
inline Point Opposite(const Point& a) { return Along(Point{}, -1.0, a); }  // without -0
inline Point Normalized(const Point& a) {
  const double length = std::sqrt(Dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
// |a - b|^2, exact to the last bits for near points, where 2 - 2 Dot(a, b) is not.
inline double SquaredDistance(const Point& a, const Point& b) {
  const Point difference = Along(a, -1.0, b);
  return Dot(difference, difference);
}
// Any unit vector at a right angle to a unit vector.
Point Perpendicular(const Point& a);

// Independent uniform points, the same for a seed on every machine.
PointSet RandomPoints(int count, uint32_t seed);

// The smallest angle between two points; 2 pi for less than two points.
double Separation(const PointSet& set);

// The largest angle that a direction can have to the point nearest to it.
double CoveringRadius(const PointSet& set);

// The set turned, mirrored if need be, and sorted so that sets that differ only in that become one:
// two nearest neighbours lie at +z and in the half plane y = 0, x > 0, and z never increases.
PointSet Canonical(const PointSet& set);

}  // namespace gaunt::points

#endif  // GAUNT_POINTS_POINT_SET_H_
