// SPDX-License-Identifier: MIT
#include "ambient_cube/ambient_cube_reference.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "basis/basis_reference.h"
#include "evaluate/evaluate_reference.h"
#include "rotate/rotate_reference.h"

namespace gaunt::ambient_cube {
namespace {

constexpr int kFaces = 6;
constexpr int kMostOrder = 6;
constexpr int kMostCoefficients = kMostOrder * kMostOrder;

// The function of one face: the squared cosine to its axis, on its half of the sphere.
double FaceFunction(int face, const double n[3]) {
  const double cosine = face % 2 == 0 ? n[face / 2] : -n[face / 2];
  return cosine > 0.0 ? cosine * cosine : 0.0;
}

void Solve(double matrix[kFaces][kFaces], double* x) {
  for (int column = 0; column < kFaces; ++column) {
    int pivot = column;
    for (int row = column; row < kFaces; ++row) {
      if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column])) pivot = row;
    }
    std::swap_ranges(matrix[column], matrix[column] + kFaces, matrix[pivot]);
    std::swap(x[column], x[pivot]);
    for (int row = 0; row < kFaces; ++row) {
      if (row == column) continue;
      const double factor = matrix[row][column] / matrix[column][column];
      for (int k = 0; k < kFaces; ++k) matrix[row][k] -= factor * matrix[column][k];
      x[row] -= factor * x[column];
    }
  }
  for (int row = 0; row < kFaces; ++row) x[row] /= matrix[row][row];
}

// Integrals of the products of two faces' functions, and of a face's function and the basis.
struct Moments {
  double faces[kFaces][kFaces];
  double basis[kFaces][kMostCoefficients];

  Moments() : faces{}, basis{} {
    for (int a = 0; a < kFaces; ++a) {
      for (int b = 0; b < kFaces; ++b) {
        faces[a][b] = IntegralReference(
            [&](const double n[3]) { return FaceFunction(a, n) * FaceFunction(b, n); });
      }
      for (int i = 0; i < kMostCoefficients; ++i) {
        basis[a][i] = IntegralReference([&](const double n[3]) {
          double y[kMostCoefficients];
          basis::EvalReference(kMostOrder, n, y);
          return FaceFunction(a, n) * y[i];
        });
      }
    }
  }
};

const Moments& TheMoments() {
  static const Moments moments;
  return moments;
}

// A_l / pi of the band of a coefficient.
double FactorOf(int i) {
  int l = 0;
  while ((l + 1) * (l + 1) <= i) ++l;
  return evaluate::CosineFactor(l);
}

}  // namespace

// In polar coordinates of each octant, where everything is a polynomial of sines and cosines.
double IntegralReference(const std::function<double(const double direction[3])>& function) {
  constexpr int kNodes = 20;
  const double quarter = std::acos(0.0);
  std::vector<double> nodes, weights;
  rotate::GaussLegendre(kNodes, &nodes, &weights);
  double sum = 0.0;
  for (int half = 0; half < 2; ++half) {
    for (size_t i = 0; i < nodes.size(); ++i) {
      const double theta = quarter * (half + 0.5 * (nodes[i] + 1.0));
      for (int turn = 0; turn < 4; ++turn) {
        for (size_t j = 0; j < nodes.size(); ++j) {
          const double phi = quarter * (turn + 0.5 * (nodes[j] + 1.0));
          const double n[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta)};
          sum += weights[i] * weights[j] * std::sin(theta) * function(n);
        }
      }
    }
  }
  return 0.25 * quarter * quarter * sum;
}

double EvaluateReference(const double cube[6], const double direction[3]) {
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  const double n[3] = {direction[0] / length, direction[1] / length, direction[2] / length};
  double sum = 0.0;
  for (int face = 0; face < kFaces; ++face) sum += cube[face] * FaceFunction(face, n);
  return sum;
}

// The normal equations.
void ClosestReference(int order, const double* radiance, double cube[6]) {
  double matrix[kFaces][kFaces];
  for (int face = 0; face < kFaces; ++face) {
    std::copy_n(TheMoments().faces[face], kFaces, matrix[face]);
    cube[face] = 0.0;
    for (int i = 0; i < order * order; ++i) {
      cube[face] += TheMoments().basis[face][i] * FactorOf(i) * radiance[i];
    }
  }
  Solve(matrix, cube);
}

void SampledReference(int order, const double* radiance, double cube[6]) {
  for (int face = 0; face < kFaces; ++face) {
    double axis[3] = {};
    axis[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    cube[face] = evaluate::IrradianceReference(order, radiance, axis);
  }
}

void ToShReference(int order, const double cube[6], double* radiance) {
  for (int i = 0; i < order * order; ++i) {
    double projection = 0.0;
    for (int face = 0; face < kFaces; ++face)
      projection += TheMoments().basis[face][i] * cube[face];
    radiance[i] = FactorOf(i) == 0.0 ? 0.0 : projection / FactorOf(i);
  }
}

}  // namespace gaunt::ambient_cube
