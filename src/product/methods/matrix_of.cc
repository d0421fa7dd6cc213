// SPDX-License-Identifier: MIT
#include "product/methods/methods.h"
#include "product/tensor.h"

namespace gaunt::product::methods::dense {

std::vector<float> MatrixOf(int order, const float* f) {
  std::vector<float> matrix;
  const auto for_each = [order](const auto& visit) {
    for (int l = 0; l < order; ++l) {
      for (int m = -l; m <= l; ++m) visit(l, m);
    }
  };
  for_each([&](int l_out, int m_out) {
    for_each([&](int l_in, int m_in) {
      double entry = 0.0;
      for_each([&](int l, int m) {
        entry += Gaunt(l, m, l_in, m_in, l_out, m_out) * f[CoefficientIndex(l, m)];
      });
      matrix.push_back(static_cast<float>(entry));
    });
  });
  return matrix;
}

}  // namespace gaunt::product::methods::dense
