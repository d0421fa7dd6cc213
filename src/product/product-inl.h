// SPDX-License-Identifier: MIT
// Kernels of products: which one each combination of orders has.
#if defined(GAUNT_PRODUCT_PRODUCT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_PRODUCT_INL_H_
#undef GAUNT_PRODUCT_PRODUCT_INL_H_
#else
#define GAUNT_PRODUCT_PRODUCT_INL_H_
#endif

#include "product/any_grid-inl.h"
#include "product/fixed_grid-inl.h"
#include "product/sparse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

// Orders that have kernels of their own, measured: sparse ones are faster as long as they are short.
template <int a, int b, int out>
struct KernelOf {
  using Product = FixedGrid<a, b, out, kLevel>;
};
#define GAUNT_SPARSE(a, b, out, factors)                                  \
  template <>                                                             \
  struct KernelOf<a, b, out> {                                            \
    using Product = Sparse<a, b, out, kSteps##a##x##b##To##out, factors>; \
  }
GAUNT_SPARSE(1, 1, 1, Factors::kSymmetric);
GAUNT_SPARSE(2, 2, 2, Factors::kSymmetric);
GAUNT_SPARSE(3, 3, 3, Factors::kSymmetric);
GAUNT_SPARSE(4, 4, 4, Factors::kSymmetric);
GAUNT_SPARSE(6, 6, 3, Factors::kSymmetric);
GAUNT_SPARSE(2, 6, 6, Factors::kOrdered);
GAUNT_SPARSE(3, 6, 6, Factors::kOrdered);
#undef GAUNT_SPARSE
template <int a, int b, int out>
using ProductKernel = typename KernelOf<a, b, out>::Product;

template <int n>
struct SquareOf {
  using Kernel = FixedGrid<n, n, n, kLevel, Second::kSame>;
};
template <>
struct SquareOf<1> {
  using Kernel = Sparse<1, 1, 1, kSteps1x1To1, Factors::kSame>;
};
template <>
struct SquareOf<2> {
  using Kernel = Sparse<2, 2, 2, kSteps2x2To2, Factors::kSame>;
};
template <>
struct SquareOf<3> {
  using Kernel = Sparse<3, 3, 3, kSteps3x3To3, Factors::kSame>;
};
template <>
struct SquareOf<4> {
  using Kernel = Sparse<4, 4, 4, kSteps4x4To4, Factors::kSame>;
};
template <int n>
using SquareKernel = typename SquareOf<n>::Kernel;

template <int n>
using PreparedKernel = FixedGrid<n, n, n, kLevel, Second::kPrepared>;

// The highest equal orders that have kernels of their own; above, all share those of any order.
inline constexpr int kMaxFixed = 8;

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_PRODUCT_INL_H_
