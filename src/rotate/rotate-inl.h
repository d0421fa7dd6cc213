// SPDX-License-Identifier: MIT
// Kernels of rotation by one quaternion or matrix per item: tensors up to order 3, turns of bands
// above.
#if defined(GAUNT_ROTATE_ROTATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_ROTATE_INL_H_
#undef GAUNT_ROTATE_ROTATE_INL_H_
#else
#define GAUNT_ROTATE_ROTATE_INL_H_
#endif

#include "rotate/bands-inl.h"
#include "rotate/plan-inl.h"
#include "rotate/tensor-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

// Up to this order tensors are faster.
inline constexpr int kMaxTensorOrder = 3;
// Up to this order the matrix is made where it is used, above in a loop of its own.
inline constexpr int kMaxFusedOrder = 2;

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_ROTATE_INL_H_
