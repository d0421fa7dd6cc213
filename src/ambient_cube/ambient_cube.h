// SPDX-License-Identifier: MIT
// The ambient cube: E/pi of RGB by six values, one for each direction of the axes.
#ifndef GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_H_
#define GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_H_

#include <cstddef>

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::ambient_cube {

enum Mode { kClosest, kSampled };

using ProjectFn = void (*)(Mode mode, size_t count, const simd::InView& radiance,
                           const simd::OutView& cube);
using ToShFn = void (*)(size_t count, const simd::InView& cube, const simd::OutView& radiance);

struct Table {
  ProjectFn project[kMaxUnrolledOrder + 1];  // [order]
  ToShFn to_sh[kMaxUnrolledOrder + 1];
  void (*evaluate)(size_t count, const simd::InView& cube, const simd::InView& normals,
                   const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::ambient_cube

#endif  // GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_H_
