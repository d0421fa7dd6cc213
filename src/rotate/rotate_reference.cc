// SPDX-License-Identifier: MIT
#include "rotate/rotate_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <vector>

#include "basis/basis_reference.h"

namespace gaunt::rotate {

// By Newton's iteration.
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

namespace {

// Exact for the product of two functions of an order.
struct Quadrature {
  struct Node {
    double s[3];
    double weight;
    std::vector<double> y;  // the basis
  };
  std::vector<Node> nodes;

  explicit Quadrature(int order) {
    std::vector<double> z, weights;
    GaussLegendre(order, &z, &weights);
    const int columns = 2 * order;
    const double turn = 2.0 * std::acos(-1.0) / columns;
    for (size_t row = 0; row < z.size(); ++row) {
      const double r = std::sqrt(1.0 - z[row] * z[row]);
      for (int column = 0; column < columns; ++column) {
        Node node = {{r * std::cos(turn * column), r * std::sin(turn * column), z[row]},
                     weights[row] * turn,
                     std::vector<double>(static_cast<size_t>(order * order))};
        basis::EvalReference(order, node.s, node.y.data());
        nodes.push_back(std::move(node));
      }
    }
  }
};

const Quadrature& QuadratureOf(int order) {
  static std::mutex mutex;
  static std::map<int, Quadrature> known;
  const std::lock_guard<std::mutex> lock(mutex);
  return known.try_emplace(order, order).first->second;
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

// out_i = int f(R^-1 s) y_i(s) ds.
void RotateReference(int order, size_t channels, const double matrix[9], const double* in,
                     double* out) {
  const Quadrature& quadrature = QuadratureOf(order);
  const size_t coefficients = static_cast<size_t>(order * order);
  std::vector<double> there(coefficients);
  std::fill(out, out + channels * coefficients, 0.0);
  for (const Quadrature::Node& node : quadrature.nodes) {
    double back[3];  // R^-1 = R^T
    for (int i = 0; i < 3; ++i) {
      back[i] = matrix[i] * node.s[0] + matrix[3 + i] * node.s[1] + matrix[6 + i] * node.s[2];
    }
    basis::EvalReference(order, back, there.data());
    for (size_t c = 0; c < channels; ++c) {
      const double* const f = in + c * coefficients;
      const double value = std::inner_product(there.begin(), there.end(), f, 0.0) * node.weight;
      for (size_t i = 0; i < coefficients; ++i) out[c * coefficients + i] += value * node.y[i];
    }
  }
}

}  // namespace gaunt::rotate
