// SPDX-License-Identifier: MIT
// ZH3: order 2 and a zonal band 2; and the non-linear evaluation of order 2 by Geomerics.
#ifndef GAUNT_ZH3_ZH3_H_
#define GAUNT_ZH3_ZH3_H_

#include <cstddef>

#include "simd/view.h"

namespace gaunt::zh3 {

// Which axis: index of the arrays below.
enum AxisMode { kSharedAxis, kAxisEach, kAxisModes };

struct Table {
  // `axis` may be null.
  void (*solve[kAxisModes])(size_t count, const simd::InView& sh3, const simd::OutView& k2,
                            const simd::OutView* axis);
  void (*refit[kAxisModes])(size_t count, const simd::InView& sh3, const simd::OutView& sh2,
                            const simd::OutView& k2);
  void (*hallucinate[kAxisModes])(float linear, float quadratic, const float* weights, size_t count,
                                  const simd::InView& sh2, const simd::OutView& k2);
  void (*expand[kAxisModes])(size_t count, const simd::InView& sh2, const simd::InView& k2,
                             const simd::OutView& sh3);
  void (*irradiance[kAxisModes])(size_t count, const simd::InView& sh2, const simd::InView& k2,
                                 const simd::InView& normals, const simd::OutView& out);
  void (*geomerics)(size_t count, const simd::InView& sh2, const simd::InView& normals,
                    const simd::OutView& out);
};

const Table& Kernels();

// The curve k2 / L_0 = linear r + quadratic r^2 that is closest to probes. False where they do not
// tell.
bool FitCurve(AxisMode mode, size_t count, const simd::InView& sh3, double* linear,
              double* quadratic);

}  // namespace gaunt::zh3

#endif  // GAUNT_ZH3_ZH3_H_
