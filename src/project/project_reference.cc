// SPDX-License-Identifier: MIT
#include "project/project_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"

namespace gaunt::project {

void EquirectReference(int order, int channels, const float* pixels, int width, int height,
                       ptrdiff_t pixel_stride, ptrdiff_t row_stride, double* out) {
  const double pi = std::acos(-1.0);
  const int n = order * order;
  std::vector<double> y(static_cast<size_t>(n));
  std::fill(out, out + channels * n, 0.0);
  for (int row = 0; row < height; ++row) {
    const double theta = pi * (row + 0.5) / height;
    const double solid_angle =
        2.0 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
    for (int column = 0; column < width; ++column) {
      const double phi = pi - 2.0 * pi * (column + 0.5) / width;
      const double direction[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta)};
      basis::EvalReference(order, direction, y.data());
      for (int c = 0; c < channels; ++c) {
        const double value =
            static_cast<double>(pixels[row * row_stride + column * pixel_stride + c]);
        for (int i = 0; i < n; ++i) {
          out[c * n + i] += value * y[static_cast<size_t>(i)] * solid_angle;
        }
      }
    }
  }
}

}  // namespace gaunt::project
