// SPDX-License-Identifier: MIT
#include "project/project_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"

namespace gaunt::project {
namespace {

// Adds one sample at a time to channels * order^2 sums.
class Sums {
 public:
  Sums(int order, int channels, double* out)
      : order_(order), channels_(channels), out_(out), y_(static_cast<size_t>(order * order)) {
    std::fill(out, out + channels * order * order, 0.0);
  }
  template <class Value>
  void Add(const double direction[3], double weight, const Value& value) {
    basis::EvalReference(order_, direction, y_.data());
    double* sum = out_;
    for (int c = 0; c < channels_; ++c) {
      const double weighted = weight * value(c);
      for (const double y : y_) *sum++ += weighted * y;
    }
  }

 private:
  int order_, channels_;
  double* out_;
  std::vector<double> y_;
};

}  // namespace

void EquirectReference(int order, int channels, int width, int height, const TexelFn& texel,
                       double* out) {
  const double pi = std::acos(-1.0);
  Sums sums(order, channels, out);
  for (int row = 0; row < height; ++row) {
    const double theta = pi * (row + 0.5) / height;
    const double solid_angle =
        2.0 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
    for (int column = 0; column < width; ++column) {
      const double phi = pi - 2.0 * pi * (column + 0.5) / width;
      const double direction[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta)};
      sums.Add(direction, solid_angle, [&](int c) { return texel(column, row, c); });
    }
  }
}

void CubeDirectionReference(int face, int column, int row, int size, double direction[3]) {
  const double u = (2.0 * column + 1.0) / size - 1.0, v = (2.0 * row + 1.0) / size - 1.0;
  const double to[6][3] = {{1.0, -v, -u}, {-1.0, -v, u}, {u, 1.0, v},
                           {u, -1.0, -v}, {u, -v, 1.0},  {-u, -v, -1.0}};
  for (int k = 0; k < 3; ++k) direction[k] = to[face][k] / std::sqrt(u * u + v * v + 1.0);
}

double CubeSolidAngleReference(int column, int row, int size) {
  // Of the rectangle from the middle of the face to (x, y).
  const auto corner = [](double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
  };
  const double left = 2.0 * column / size - 1.0, right = 2.0 * (column + 1) / size - 1.0;
  const double top = 2.0 * row / size - 1.0, bottom = 2.0 * (row + 1) / size - 1.0;
  return corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top);
}

void CubemapReference(int order, int channels, int size, const CubeTexelFn& texel, double* out) {
  Sums sums(order, channels, out);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        double direction[3];
        CubeDirectionReference(face, column, row, size, direction);
        sums.Add(direction, CubeSolidAngleReference(column, row, size),
                 [&](int c) { return texel(face, column, row, c); });
      }
    }
  }
}

void SamplesReference(int order, int channels, size_t count, const double* directions,
                      const double* values, const double* weights, double* out) {
  Sums sums(order, channels, out);
  for (size_t i = 0; i < count; ++i) {
    sums.Add(directions + 3 * i, weights[i], [&](int c) {
      return values[i * static_cast<size_t>(channels) + static_cast<size_t>(c)];
    });
  }
}

}  // namespace gaunt::project
