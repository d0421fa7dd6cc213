// SPDX-License-Identifier: MIT
// The SH basis in many directions.
#ifndef GAUNT_BASIS_BASIS_H_
#define GAUNT_BASIS_BASIS_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::basis {

using EvalFn = void (*)(size_t count, const simd::InView& directions, const simd::OutView& out);

struct Table {
  EvalFn eval[kMaxUnrolledOrder + 1];  // [order]: 3 planes to order^2
};

const Table& Kernels();

}  // namespace gaunt::basis

#endif  // GAUNT_BASIS_BASIS_H_
