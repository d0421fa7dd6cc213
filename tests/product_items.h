// SPDX-License-Identifier: MIT
// Products of items that lie back to back, one channel, and what gaunt.h states of their errors.
#ifndef GAUNT_TESTS_PRODUCT_ITEMS_H_
#define GAUNT_TESTS_PRODUCT_ITEMS_H_

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"
#include "product/product_reference.h"
#include "tests/support/random.h"

namespace gaunt::test {

struct Orders {
  uint32_t a, b, out;
};

inline std::string Name(const Orders& n) {
  return std::to_string(n.a) + "x" + std::to_string(n.b) + "to" + std::to_string(n.out);
}

// Relative to the norms of both factors.
constexpr double ProductTolerance(uint32_t n_a, uint32_t n_b) {
  return n_a <= 6 && n_b <= 6 ? 4e-7 : 6e-7;
}

template <class T>
double Norm(const T* values, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += double{values[i]} * double{values[i]};
  return std::sqrt(sum);
}

using Floats = std::vector<float>;

inline double Norm(const Floats& item) { return Norm(item.data(), item.size()); }

inline Floats RandomItems(Random& random, size_t floats) {
  Floats items(floats);
  random.Fill(items.data(), floats, -1.0, 1.0);
  return items;
}

inline gaunt_view ViewOf(const Floats& items, uint32_t n) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(items.data()), size_t{n} * n, &view);
  return view;
}

inline Floats ProductOf(const Orders& n, const Floats& a, const Floats& b) {
  const size_t count = a.size() / (n.a * n.a);
  Floats out(count * n.out * n.out);
  const gaunt_view va = ViewOf(a, n.a), vb = ViewOf(b, n.b), vo = ViewOf(out, n.out);
  EXPECT_EQ(gaunt_product(n.a, n.b, n.out, 1, count, &va, &vb, &vo), GAUNT_OK);
  return out;
}

inline Floats SquareOf(uint32_t n, uint32_t n_out, const Floats& a) {
  const size_t count = a.size() / (n * n);
  Floats out(count * n_out * n_out);
  const gaunt_view va = ViewOf(a, n), vo = ViewOf(out, n_out);
  EXPECT_EQ(gaunt_product_square(n, n_out, 1, count, &va, &vo), GAUNT_OK);
  return out;
}

// Of one item.
inline std::vector<double> ExactProduct(const Orders& n, const float* a, const float* b) {
  std::vector<double> out(n.out * n.out);
  product::ProductReference(static_cast<int>(n.a), static_cast<int>(n.b), static_cast<int>(n.out),
                            std::vector<double>(a, a + n.a * n.a).data(),
                            std::vector<double>(b, b + n.b * n.b).data(), out.data());
  return out;
}

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_PRODUCT_ITEMS_H_
