// SPDX-License-Identifier: MIT
#include "rotate/rotate_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"
#include "evaluate/evaluate_reference.h"

namespace gaunt::rotate {
namespace {

// Nodes and weights of Gauss-Legendre quadrature, by Newton's iteration.
void GaussLegendre(int n, std::vector<double>* nodes, std::vector<double>* weights) {
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::acos(-1.0) * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 100; ++step) {
      double below = 1.0, value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * below) / k;
        below = value;
        value = next;
      }
      slope = n * (x * value - below) / (x * x - 1.0);
      const double change = value / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    nodes->push_back(x);
    weights->push_back(2.0 / ((1.0 - x * x) * slope * slope));
  }
}

}  // namespace

void MatrixReference(const double quaternion[4], double matrix[9]) {
  const double length = std::hypot(std::hypot(quaternion[0], quaternion[1]),
                                   std::hypot(quaternion[2], quaternion[3]));
  double q[4] = {0.0, 0.0, 0.0, 1.0};
  if (length > 0.0) {
    for (int i = 0; i < 4; ++i) q[i] = quaternion[i] / length;
  }
  // Columns are the images of the axes: v' = v + 2 w (u x v) + 2 u x (u x v).
  for (int axis = 0; axis < 3; ++axis) {
    const double v[3] = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    const auto cross = [&](const double* b, double* out) {
      out[0] = q[1] * b[2] - q[2] * b[1];
      out[1] = q[2] * b[0] - q[0] * b[2];
      out[2] = q[0] * b[1] - q[1] * b[0];
    };
    double once[3], twice[3];
    cross(v, once);
    cross(once, twice);
    for (int row = 0; row < 3; ++row) {
      matrix[3 * row + axis] = v[row] + 2.0 * (q[3] * once[row] + twice[row]);
    }
  }
}

// out_i = int f(R^-1 s) y_i(s) ds, by a quadrature that is exact for the product of two such
// functions.
void RotateReference(int order, const double matrix[9], const double* in, double* out) {
  std::vector<double> nodes, weights;
  GaussLegendre(order, &nodes, &weights);
  const int columns = 2 * order;
  const double turn = 2.0 * std::acos(-1.0) / columns;
  std::vector<double> y(static_cast<size_t>(order * order));
  std::fill(out, out + order * order, 0.0);
  for (size_t row = 0; row < nodes.size(); ++row) {
    const double r = std::sqrt(1.0 - nodes[row] * nodes[row]);
    for (int column = 0; column < columns; ++column) {
      const double s[3] = {r * std::cos(turn * column), r * std::sin(turn * column), nodes[row]};
      double back[3];  // R^-1 = R^T
      for (int i = 0; i < 3; ++i) {
        back[i] = matrix[i] * s[0] + matrix[3 + i] * s[1] + matrix[6 + i] * s[2];
      }
      const double value = evaluate::ShReference(order, in, back) * weights[row] * turn;
      basis::EvalReference(order, s, y.data());
      for (size_t i = 0; i < y.size(); ++i) out[i] += value * y[i];
    }
  }
}

}  // namespace gaunt::rotate
