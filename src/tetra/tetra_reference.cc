// SPDX-License-Identifier: MIT
#include "tetra/tetra_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaunt::tetra {
namespace {

using Point = std::array<double, 3>;

// Six times the volume, with a sign.
double Volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  double m[3][3];
  for (size_t k = 0; k < 3; ++k) {
    m[0][k] = b[k] - a[k];
    m[1][k] = c[k] - a[k];
    m[2][k] = d[k] - a[k];
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

double Distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::array<Point, 4> CornersOf(const MeshReference& mesh, uint32_t tetrahedron) {
  std::array<Point, 4> corners;
  for (size_t i = 0; i < 4; ++i) corners[i] = mesh.vertices[mesh.tetrahedra[tetrahedron][i]];
  return corners;
}

}  // namespace

std::array<double, 4> BarycentricsReference(const MeshReference& mesh, uint32_t tetrahedron,
                                            const Point& position) {
  const std::array<Point, 4> v = CornersOf(mesh, tetrahedron);
  const double all = Volume(v[0], v[1], v[2], v[3]);
  std::array<double, 4> result;
  for (size_t i = 0; i < 4; ++i) {
    std::array<Point, 4> moved = v;
    moved[i] = position;
    result[i] = Volume(moved[0], moved[1], moved[2], moved[3]) / all;
  }
  return result;
}

FoundReference FindReference(const MeshReference& mesh, const Point& position) {
  FoundReference found = {0, -std::numeric_limits<double>::infinity()};
  for (uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const std::array<double, 4> b = BarycentricsReference(mesh, t, position);
    const double least = *std::min_element(b.begin(), b.end());
    if (std::isfinite(b[0] + b[1] + b[2] + b[3]) && least > found.least) found = {t, least};
  }
  return found;
}

double AspectReference(const MeshReference& mesh, uint32_t tetrahedron) {
  const std::array<Point, 4> v = CornersOf(mesh, tetrahedron);
  double longest = 0.0, largest = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < i; ++j) longest = std::max(longest, Distance(v[i], v[j]));
    // Heron's formula of the face that lies opposite.
    const Point &a = v[(i + 1) % 4], &b = v[(i + 2) % 4], &c = v[(i + 3) % 4];
    const double x = Distance(a, b), y = Distance(b, c), z = Distance(c, a), s = (x + y + z) / 2;
    largest = std::max(largest, std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z))));
  }
  const double height = std::abs(Volume(v[0], v[1], v[2], v[3])) / (2.0 * largest);
  return longest / height;
}

}  // namespace gaunt::tetra
