// SPDX-License-Identifier: MIT
// SH functions evaluated in directions, their irradiance, and sums and blends of coefficients.
#ifndef GAUNT_EVALUATE_EVALUATE_H_
#define GAUNT_EVALUATE_EVALUATE_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::evaluate {

inline constexpr int kConstantPlanes = 28;  // 7 float4
inline constexpr int kMatrixPlanes = 16;    // of a channel

using EvaluateFn = void (*)(size_t channels, size_t count, const simd::InView& coefficients,
                            const simd::InView& directions, const simd::OutView& out);
using EvaluateAnyFn = void (*)(int order, size_t channels, size_t count,
                               const simd::InView& coefficients, const simd::InView& directions,
                               const simd::OutView& out);

struct Table {
  EvaluateFn sh[kMaxUnrolledOrder + 1];          // [order]
  EvaluateFn irradiance[kMaxUnrolledOrder + 1];  // [order], E/pi
  EvaluateAnyFn sh_any;
  EvaluateAnyFn irradiance_any;
  void (*constants)(size_t count, const simd::InView& radiance, const simd::OutView& out);
  void (*matrix)(size_t channels, size_t count, const simd::InView& radiance,
                 const simd::OutView& out);
  void (*dot)(size_t coefficients, size_t channels, size_t count, const simd::InView& a,
              const simd::InView& b, const simd::OutView& out);
  void (*blend)(size_t planes, size_t count, const simd::InView& a, const simd::InView& b,
                const simd::InView& t, const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::evaluate

#endif  // GAUNT_EVALUATE_EVALUATE_H_
