// SPDX-License-Identifier: MIT
// What a walk leaves over, one position at a time and in double precision.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tetra/tetra.h"

namespace gaunt::tetra {
namespace {

struct Vector {
  double x, y, z;
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double t, const Vector& a) { return {t * a.x, t * a.y, t * a.z}; }
double Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Barycentrics of a position; false where the tetrahedron is flat.
bool Barycentrics(const Mesh& mesh, uint32_t tetrahedron, const Vector& p, double* b) {
  Record record;
  std::memcpy(&record, mesh.records + size_t{tetrahedron} * sizeof(Record), sizeof(record));
  if (std::isnan(record.rows[0][0])) return false;
  const Vector from = p - Vector{record.corner[0], record.corner[1], record.corner[2]};
  b[3] = 1.0;
  for (int i = 0; i < 3; ++i) {
    b[i] = Dot({record.rows[i][0], record.rows[i][1], record.rows[i][2]}, from);
    b[3] -= b[i];
  }
  return true;
}

// The closest point so far.
struct Closest {
  double squared = std::numeric_limits<double>::infinity();
  double weights[kCorners] = {};

  void Offer(const Vector& from_p, const double (&w)[kCorners]) {
    const double distance = Dot(from_p, from_p);
    if (!(distance < squared)) return;
    squared = distance;
    std::copy_n(w, kCorners, weights);
  }
};

// Vertices are given relative to the position.
void OfferEdge(const Vector (&v)[kCorners], int i, int j, Closest* closest) {
  const Vector edge = v[j] - v[i];
  const double squared = Dot(edge, edge);
  const double t = squared > 0.0 ? std::clamp(-Dot(v[i], edge) / squared, 0.0, 1.0) : 0.0;
  double weights[kCorners] = {};
  weights[i] = 1.0 - t;
  weights[j] = t;
  closest->Offer(v[i] + t * edge, weights);
}

// The inside of a triangle; false if it has no point below the position.
bool OfferTriangle(const Vector (&v)[kCorners], int i, int j, int k, Closest* closest) {
  const Vector normal = Cross(v[j] - v[i], v[k] - v[i]);
  const double squared = Dot(normal, normal);
  if (!(squared > 0.0)) return false;
  double weights[kCorners] = {};
  weights[j] = Dot(Cross(v[k] - v[i], v[i]), normal) / squared;
  weights[k] = Dot(Cross(v[i], v[j] - v[i]), normal) / squared;
  weights[i] = 1.0 - weights[j] - weights[k];
  if (!(weights[i] >= 0.0 && weights[j] >= 0.0 && weights[k] >= 0.0)) return false;
  closest->Offer((Dot(v[i], normal) / squared) * normal, weights);
  return true;
}

// The nearest point of a tetrahedron's surface.
Closest NearestOf(const Mesh& mesh, uint32_t tetrahedron, const Vector& p) {
  Corners corners;
  std::memcpy(&corners, mesh.corners + size_t{tetrahedron} * sizeof(Corners), sizeof(corners));
  Vector v[kCorners];
  for (int i = 0; i < kCorners; ++i) {
    // Whatever happened to the bytes, nothing outside them is read.
    const size_t index = std::min(corners.vertices[i], mesh.last_vertex);
    Vertex vertex;
    std::memcpy(&vertex, mesh.vertices + index * sizeof(Vertex), sizeof(vertex));
    v[i] = Vector{vertex.at[0], vertex.at[1], vertex.at[2]} - p;
  }
  // Of faces that the position is beyond, or of all of a flat one.
  double b[kCorners];
  if (!Barycentrics(mesh, tetrahedron, p, b)) std::fill_n(b, kCorners, 0.0);
  const double least = *std::min_element(b, b + kCorners);
  Closest closest;
  for (int i = 0; i < kCorners; ++i) {
    if (b[i] > std::max(least, 0.0)) continue;
    const int j = (i + 1) % kCorners, k = (i + 2) % kCorners, l = (i + 3) % kCorners;
    if (OfferTriangle(v, j, k, l, &closest)) continue;
    OfferEdge(v, j, k, &closest);
    OfferEdge(v, k, l, &closest);
    OfferEdge(v, l, j, &closest);
  }
  return closest;
}

bool IsInside(const Mesh& mesh, uint32_t tetrahedron, const Vector& p, double* weights) {
  double b[kCorners];
  if (!Barycentrics(mesh, tetrahedron, p, b)) return false;
  for (int i = 0; i < kCorners; ++i) weights[i] = std::max(b[i], 0.0);
  return *std::min_element(b, b + kCorners) >= kInside;
}

// Looks at all tetrahedra: for the first that holds the position, or else for the nearest.
void Search(const Mesh& mesh, const Vector& p, uint32_t* tetrahedron, double* weights) {
  for (uint32_t t = 0; t < mesh.tetrahedra; ++t) {
    if (IsInside(mesh, t, p, weights)) {
      *tetrahedron = t;
      return;
    }
  }
  Closest closest;
  for (uint32_t t = 0; t < mesh.tetrahedra; ++t) {
    const Closest candidate = NearestOf(mesh, t, p);
    if (!(candidate.squared < closest.squared)) continue;
    closest = candidate;
    *tetrahedron = t;
  }
  std::copy_n(closest.weights, kCorners, weights);
}

}  // namespace

void FindNearest(const Mesh& mesh, const float* position, bool is_lost, uint32_t* tetrahedron,
                 float* weights) {
  const Vector p = {position[0], position[1], position[2]};
  double found[kCorners];
  if (is_lost) {
    Search(mesh, p, tetrahedron, found);
  } else {
    std::copy_n(NearestOf(mesh, *tetrahedron, p).weights, kCorners, found);
  }
  const double sum = found[0] + found[1] + found[2] + found[3];
  for (int i = 0; i < kCorners; ++i) weights[i] = static_cast<float>(found[i] / sum);
}

}  // namespace gaunt::tetra
