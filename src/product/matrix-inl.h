// SPDX-License-Identifier: MIT
// Products with one function by the matrix of its product, for low orders, where the matrix is small.
#if defined(GAUNT_PRODUCT_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_MATRIX_INL_H_
#undef GAUNT_PRODUCT_MATRIX_INL_H_
#else
#define GAUNT_PRODUCT_MATRIX_INL_H_
#endif

#include <utility>

#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// A square matrix of order n in memory, row by row. Each sum goes in halves, whose rounding errors
// add up to less, and n of them go side by side, which hides the latency of multiply-adds.
template <int n>
struct Matrix {
  const void* values;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    typename K::template Slots<kSize> results;
    for (int row = 0; row < kSize; row += n) {
      Rows(k, k.Floats(values).From(static_cast<size_t>(row * kSize)), in, results, row,
           std::make_integer_sequence<int, n>());
    }
    for (size_t p = 0; p < kSize; ++p) out(p, results(p));
  }

 private:
  static constexpr int kSize = NumCoefficients(n);
  static constexpr int kHalf = (kSize + 1) / 2;

  template <class K, class Values, class In, class S, int... i>
  static GAUNT_LANES void Rows(const K&, const Values& row, const In& in, S& results, int first,
                               std::integer_sequence<int, i...>) {
    typename K::template Slots<n> low, high;
    (low(i, Mul(row(i * kSize), in(0))), ...);
    if constexpr (kHalf < kSize) (high(i, Mul(row(i * kSize + kHalf), in(kHalf))), ...);
    for (size_t j = 1; j < kHalf; ++j) {
      const auto value = in(j);
      (low(i, MulAdd(row(i * kSize + j), value, low(i))), ...);
      if (j + kHalf >= kSize) continue;
      const auto other = in(j + kHalf);
      (high(i, MulAdd(row(i * kSize + j + kHalf), other, high(i))), ...);
    }
    if constexpr (kHalf < kSize) (low(i, Add(low(i), high(i))), ...);
    (results(static_cast<size_t>(first + i), low(i)), ...);
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_MATRIX_INL_H_
