// SPDX-License-Identifier: MIT
// The SH basis in many directions, its gradient, and directions of unit length.
#ifndef GAUNT_BASIS_BASIS_H_
#define GAUNT_BASIS_BASIS_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::basis {

// Orders whose kernels are unrolled; loops are as fast from there up.
inline constexpr int kMaxUnrolled = 10;
inline constexpr int kMaxUnrolledGradient = 6;

using EvalFn = void (*)(size_t count, const simd::InView& directions, const simd::OutView& out);
using GradientFn = void (*)(size_t count, const simd::InView& directions, const simd::OutView& dx,
                            const simd::OutView& dy, const simd::OutView& dz);

struct Table {
  EvalFn eval[kMaxUnrolled + 1];  // [order]: 3 planes to order^2
  void (*eval_any)(int order, size_t count, const simd::InView& directions,
                   const simd::OutView& out);
  // [order]: order^2 planes of each component of the gradient on the sphere
  GradientFn gradient[kMaxUnrolledGradient + 1];
  void (*gradient_any)(int order, size_t count, const simd::InView& directions,
                       const simd::OutView& dx, const simd::OutView& dy, const simd::OutView& dz);
  void (*normalize)(size_t count, const simd::InView& in, const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::basis

#endif  // GAUNT_BASIS_BASIS_H_
