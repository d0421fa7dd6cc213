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
// multiply-adds. Each sum goes in halves, whose rounding errors add up to less: of columns
// first .. first + n.
template <class K, class Values, class In, class Sums, size_t... i>
GAUNT_LANES void SumColumns(const Values& row, size_t columns, const In& in, size_t first, size_t n,
                            Sums& low, std::index_sequence<i...>) {
  typename K::template Slots<sizeof...(i)> high;
  const size_t half = (n + 1) / 2, end = first + n, middle = first + half;
  (low(i, Mul(row(i * columns + first), in(first))), ...);
  if (n == 1) return;
  (high(i, Mul(row(i * columns + middle), in(middle))), ...);
  for (size_t j = first + 1; j < middle; ++j) {
    const auto value = in(j);
    (low(i, MulAdd(row(i * columns + j), value, low(i))), ...);
    if (j + half == end) break;
    const auto other = in(j + half);
    (high(i, MulAdd(row(i * columns + j + half), other, high(i))), ...);
  }
  (low(i, Add(low(i), high(i))), ...);
}
// Rows that are long go in quarters.
template <class K, class Values, class In, class Out, size_t... i>
GAUNT_LANES void MultiplyRowsOf(const K&, const Values& row, const In& in, const Out& out,
                                size_t columns, std::index_sequence<i...> rows) {
  constexpr size_t kLong = 64;
  typename K::template Slots<sizeof...(i)> sums, more;
  const size_t most = columns > kLong ? (columns + 1) / 2 : columns;
  SumColumns<K>(row, columns, in, 0, most, sums, rows);
  if (most < columns) {
    SumColumns<K>(row, columns, in, most, columns - most, more, rows);
    (sums(i, Add(sums(i), more(i))), ...);
  }
  (out(i, sums(i)), ...);
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
