// SPDX-License-Identifier: MIT
#include "product/product_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <tuple>
#include <vector>

#include "basis/basis_reference.h"
#include "rotate/rotate_reference.h"

namespace gaunt::product {
namespace {

struct Node {
  double z;
  double weight;
  std::vector<double> y;  // the basis
};

// Nodes that integrate products of basis functions exactly, whose degrees sum up to `degree`, over
// `least` < z < 1.
using Nodes = std::vector<Node>;

Nodes MakeNodes(int order, int degree, double least) {
  std::vector<double> cosines, weights;
  rotate::GaussLegendre(degree / 2 + 1, &cosines, &weights);
  const int columns = degree + 1;
  const double turn = 2.0 * std::acos(-1.0) / columns, scale = (1.0 - least) / 2.0;
  Nodes nodes;
  for (size_t row = 0; row < cosines.size(); ++row) {
    const double z = least + scale * (1.0 + cosines[row]), r = std::sqrt((1.0 - z) * (1.0 + z));
    for (int column = 0; column < columns; ++column) {
      const double direction[3] = {r * std::cos(turn * column), r * std::sin(turn * column), z};
      Node node = {z, scale * weights[row] * turn,
                   std::vector<double>(static_cast<size_t>(order * order))};
      basis::EvalReference(order, direction, node.y.data());
      nodes.push_back(std::move(node));
    }
  }
  return nodes;
}

// Kept from call to call.
const Nodes& NodesOf(int order, int degree, double least) {
  static std::mutex mutex;
  static std::map<std::tuple<int, int, double>, Nodes> known;
  const std::lock_guard<std::mutex> lock(mutex);
  Nodes& nodes = known[{order, degree, least}];
  if (nodes.empty()) nodes = MakeNodes(order, degree, least);
  return nodes;
}

double ValueAt(const Node& node, const double* coefficients, int order) {
  return std::inner_product(coefficients, coefficients + order * order, node.y.begin(), 0.0);
}

// Adds the coefficients of a function that is `value` at the node.
void Add(const Node& node, double value, int order, double* out) {
  for (size_t i = 0; i < static_cast<size_t>(order * order); ++i) {
    out[i] += node.weight * value * node.y[i];
  }
}

}  // namespace

void ProductReference(int order_a, int order_b, int order_out, const double* a, const double* b,
                      double* out) {
  std::fill(out, out + order_out * order_out, 0.0);
  const int degree = order_a + order_b + order_out - 3;
  const int order = std::max({order_a, order_b, order_out});
  for (const Node& node : NodesOf(order, degree, -1.0)) {
    Add(node, ValueAt(node, a, order_a) * ValueAt(node, b, order_b), order_out, out);
  }
}

void HemisphereReference(int order, const double* in, double* out) {
  std::fill(out, out + order * order, 0.0);
  for (const Node& node : NodesOf(order, 2 * order - 2, 0.0)) {
    Add(node, ValueAt(node, in, order), order, out);
  }
}

void CosineReference(int order, const double* in, double* out) {
  std::fill(out, out + order * order, 0.0);
  for (const Node& node : NodesOf(order, 2 * order - 1, 0.0)) {
    Add(node, node.z * ValueAt(node, in, order), order, out);
  }
}

}  // namespace gaunt::product
