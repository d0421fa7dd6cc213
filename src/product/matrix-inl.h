// SPDX-License-Identifier: MIT
// Products with one function by the matrix of its product, for low orders, where the matrix is small.
#if defined(GAUNT_PRODUCT_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_MATRIX_INL_H_
#undef GAUNT_PRODUCT_MATRIX_INL_H_
#else
#define GAUNT_PRODUCT_MATRIX_INL_H_
#endif

#include <utility>

#include "product/transform-inl.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Of a matrix in memory, some rows times the input, side by side, which hides the latency of
// multiply-adds. Each sum goes in halves, whose rounding errors add up to less.
template <class K, class Values, class In, class Out, size_t... i>
GAUNT_LANES void MultiplyRowsOf(const K&, const Values& row, const In& in, const Out& out, size_t n,
                                std::index_sequence<i...>) {
  typename K::template Slots<sizeof...(i)> low, high;
  const size_t half = (n + 1) / 2;
  (low(i, Mul(row(i * n), in(0))), ...);
  if (n == 1) return (out(i, low(i)), ...);
  (high(i, Mul(row(i * n + half), in(half))), ...);
  for (size_t j = 1; j < half; ++j) {
    const auto value = in(j);
    (low(i, MulAdd(row(i * n + j), value, low(i))), ...);
    if (j + half == n) break;
    const auto other = in(j + half);
    (high(i, MulAdd(row(i * n + j + half), other, high(i))), ...);
  }
  (out(i, Add(low(i), high(i))), ...);
}

// The matrix of functions of order n, known when it is compiled; n rows go at a time.
template <int n>
struct Matrix {
  const void* values;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    constexpr size_t kSize = NumCoefficients(n);
    typename K::template Slots<NumCoefficients(n)> results;  // the output may be in place
    for (size_t row = 0; row < kSize; row += n) {
      MultiplyRowsOf(k, k.Floats(values).From(row * kSize), in,
                     Every<1>(results, static_cast<int>(row)), kSize,
                     std::make_index_sequence<n>());
    }
    for (size_t p = 0; p < kSize; ++p) out(p, results(p));
  }
};

// Any matrix. An output may not be in place.
struct AnyMatrix {
  const void* values;
  int rows, columns;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    int i = 0;
    for (; rows - i >= 4 && rows - i != 5; i += 4) Block<4>(k, i, in, out);
    if (rows - i == 5) return Block<5>(k, i, in, out);
    for (; i < rows; ++i) Block<1>(k, i, in, out);
  }

 private:
  template <int kRows, class K, class In, class Out>
  GAUNT_LANES void Block(const K& k, int first, const In& in, const Out& out) const {
    MultiplyRowsOf(k, k.Floats(values).From(static_cast<size_t>(first * columns)), in,
                   out.From(static_cast<size_t>(first)), static_cast<size_t>(columns),
                   std::make_index_sequence<static_cast<size_t>(kRows)>());
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_MATRIX_INL_H_
