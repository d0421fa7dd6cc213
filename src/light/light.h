// SPDX-License-Identifier: MIT
// Lights taken out of SH coefficients.
#ifndef GAUNT_LIGHT_LIGHT_H_
#define GAUNT_LIGHT_LIGHT_H_

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::light {

using ExtractFn = void (*)(size_t channels, size_t count, const simd::InView& in,
                           const simd::InView& directions, const simd::OutView& colours,
                           const simd::OutView& ambient);

struct Table {
  // Bands 0 and 1 of each channel, `coefficients` planes apart.
  void (*direction)(size_t coefficients, size_t channels, const float* weights, size_t count,
                    const simd::InView& in, const simd::OutView& directions);
  ExtractFn extract_radiance[kMaxUnrolledOrder + 1];  // [order], from order 2
  ExtractFn extract_irradiance[kMaxUnrolledOrder + 1];
};

const Table& Kernels();

}  // namespace gaunt::light

#endif  // GAUNT_LIGHT_LIGHT_H_
