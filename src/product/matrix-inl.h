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

// A square matrix in memory, row by row. Rows go in blocks that hide the latency of multiply-adds.
template <int kSize>
struct Matrix {
  const void* values;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    typename K::template Slots<kSize> results;
    for (int row = 0; row < kSize; row += kBlock) {
      if (row > kSize - kBlock) row = kSize - kBlock;  // the last may overlap the one before
      Block(k, k.Floats(values).From(static_cast<size_t>(row * kSize)), in, results, row,
            std::make_integer_sequence<int, kBlock>());
    }
    for (int p = 0; p < kSize; ++p) out(static_cast<size_t>(p), results(static_cast<size_t>(p)));
  }

 private:
  static constexpr int kBlock = kSize < 9 ? kSize : kSize % 8 == 0 ? 8 : 9;

  template <class K, class Rows, class In, class S, int... i>
  static GAUNT_LANES void Block(const K&, const Rows& rows, const In& in, S& results, int row,
                                std::integer_sequence<int, i...>) {
    typename K::template Slots<kBlock> sums;
    (sums(i, Mul(rows(i * kSize), in(0))), ...);
    for (size_t j = 1; j < kSize; ++j) {
      const auto value = in(j);
      (sums(i, MulAdd(rows(i * kSize + j), value, sums(i))), ...);
    }
    (results(static_cast<size_t>(row + i), sums(i)), ...);
  }
};

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_MATRIX_INL_H_
