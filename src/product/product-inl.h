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

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

template <int a, int b, int out>
using ProductKernel = FixedGrid<a, b, out, kLevel>;
template <int n>
using SquareKernel = FixedGrid<n, n, n, kLevel, Second::kSame>;
template <int n>
using PreparedKernel = FixedGrid<n, n, n, kLevel, Second::kPrepared>;

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_PRODUCT_INL_H_
