// SPDX-License-Identifier: MIT
// Zonal functions, which are symmetric about an axis: turned to directions, and convolved with.
#ifndef GAUNT_ZONAL_ZONAL_H_
#define GAUNT_ZONAL_ZONAL_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::zonal {

using RotateFn = void (*)(size_t channels, size_t count, const simd::InView& zonal,
                          const simd::InView& directions, const simd::OutView& out);
using RotateAnyFn = void (*)(int order, size_t channels, size_t count, const simd::InView& zonal,
                             const simd::InView& directions, const simd::OutView& out);
using ConvolveFn = void (*)(size_t channels, size_t count, const simd::InView& kernel,
                            const simd::InView& in, const simd::OutView& out);

struct Table {
  RotateFn rotate[kMaxUnrolledOrder + 1];      // [order]
  RotateFn rotate_add[kMaxUnrolledOrder + 1];  // [order]; `out` is read too
  ConvolveFn convolve[kMaxUnrolledOrder + 1];  // [order]
  RotateAnyFn rotate_any;
  RotateAnyFn rotate_add_any;
  void (*convolve_any)(int order, size_t channels, size_t count, const simd::InView& kernel,
                       const simd::InView& in, const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::zonal

#endif  // GAUNT_ZONAL_ZONAL_H_
