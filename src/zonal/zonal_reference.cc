// SPDX-License-Identifier: MIT
#include "zonal/zonal_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "basis/basis_reference.h"
#include "rotate/rotate_reference.h"

namespace gaunt::zonal {
namespace {

struct Node {
  double direction[3];
  double weight;
  std::vector<double> y;
};

// Nodes that integrate the product of two functions of an order exactly, and the basis there.
template <class Visit>
void ForEachNode(int order, const Visit& visit) {
  std::vector<double> cosines, weights;
  rotate::GaussLegendre(order, &cosines, &weights);
  const double turn = std::acos(-1.0) / order;
  for (size_t row = 0; row < cosines.size(); ++row) {
    const double z = cosines[row], r = std::sqrt(1.0 - z * z);
    for (int column = 0; column < 2 * order; ++column) {
      Node node = {{r * std::cos(turn * column), r * std::sin(turn * column), z},
                   weights[row] * turn,
                   std::vector<double>(static_cast<size_t>(order * order))};
      basis::EvalReference(order, node.direction, node.y.data());
      visit(node);
    }
  }
}

// Kept from call to call, where they are not too many.
const std::vector<Node>& NodesOf(int order) {
  static thread_local std::map<int, std::vector<Node>> nodes;
  std::vector<Node>& known = nodes[order];
  if (known.empty()) ForEachNode(order, [&](const Node& node) { known.push_back(node); });
  return known;
}

double Dot(const double* a, const double* b, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

// y_l0 = sqrt((2l+1) / (4 pi)) P_l.
double ZonalReference(int order, const double* zonal, double cosine) {
  double sum = 0.0, below = 0.0, legendre = 1.0;
  for (int l = 0; l < order; ++l) {
    sum += zonal[l] * std::sqrt((2.0 * l + 1.0) / (4.0 * std::acos(-1.0))) * legendre;
    const double next = ((2.0 * l + 1.0) * cosine * legendre - l * below) / (l + 1.0);
    below = legendre;
    legendre = next;
  }
  return sum;
}

void RotateReference(int order, const double* zonal, const double direction[3], double* out) {
  constexpr int kMostKept = 16;
  const double length = std::sqrt(Dot(direction, direction, 3));
  std::fill(out, out + order * order, 0.0);
  const auto add = [&](const Node& node) {
    const double cosine = Dot(node.direction, direction, 3) / length;
    const double value = node.weight * ZonalReference(order, zonal, cosine);
    for (size_t i = 0; i < node.y.size(); ++i) out[i] += value * node.y[i];
  };
  if (order > kMostKept) return ForEachNode(order, add);
  for (const Node& node : NodesOf(order)) add(node);
}

void ConvolveReference(int order, const double* kernel, const double* in, double* out) {
  std::fill(out, out + order * order, 0.0);
  const std::vector<Node>& nodes = NodesOf(order);
  std::vector<double> f;
  for (const Node& t : nodes) f.push_back(t.weight * Dot(t.y.data(), in, t.y.size()));
  for (const Node& s : nodes) {
    double value = 0.0;
    for (size_t j = 0; j < nodes.size(); ++j) {
      value += f[j] * ZonalReference(order, kernel, Dot(s.direction, nodes[j].direction, 3));
    }
    for (size_t i = 0; i < s.y.size(); ++i) out[i] += s.weight * value * s.y[i];
  }
}

}  // namespace gaunt::zonal
