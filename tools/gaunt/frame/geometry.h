// SPDX-License-Identifier: MIT
// Vectors, rays and boxes.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_GEOMETRY_H_
#define GAUNT_TOOLS_GAUNT_FRAME_GEOMETRY_H_

#include <algorithm>
#include <cmath>

namespace gaunt::tool {

struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
inline double Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vec3& a) { return std::sqrt(Dot(a, a)); }
inline Vec3 Normalize(const Vec3& a) { return (1.0 / Length(a)) * a; }
inline double Luminance(const Vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

struct Ray {
  Vec3 origin, direction;
};

struct Bounds {
  Vec3 low, high;
  bool Contains(const Vec3& p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z &&
           p.z <= high.z;
  }
};

// The index-th of `count` directions spread evenly over the sphere (spherical Fibonacci).
inline Vec3 SphereDirection(int index, int count) {
  constexpr double kGoldenAngle = 2.39996322972865332;
  const double z = 1.0 - (2.0 * index + 1.0) / count;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(kGoldenAngle * index), r * std::sin(kGoldenAngle * index), z};
}

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_GEOMETRY_H_
