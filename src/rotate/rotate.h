// SPDX-License-Identifier: MIT
// Rotation of SH coefficients.
#ifndef GAUNT_ROTATE_ROTATE_H_
#define GAUNT_ROTATE_ROTATE_H_

#include <limits>

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::rotate {

inline constexpr int kMaxOrder = 16;

// A quaternion whose components are all smaller is the identity: the least normal float.
inline constexpr double kSmallestComponent = std::numeric_limits<float>::min();

using RotateFn = void (*)(size_t channels, size_t count, const simd::InView& rotations,
                          const simd::InView& in, const simd::OutView& out);

struct Table {
  RotateFn quaternion[kMaxOrder + 1];  // [order]; rotations are 4 planes x y z w
  RotateFn matrix[kMaxOrder + 1];      // [order]; rotations are 9 planes, row-major
  // The largest entry of |R^T R - 1| of all matrices; infinite if one is not finite.
  float (*deviation)(size_t count, const simd::InView& matrices);
};

const Table& Kernels();

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_ROTATE_H_
