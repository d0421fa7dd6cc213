// SPDX-License-Identifier: MIT
// Products with functions that are symmetric about an axis: zonal ones, the hemisphere, the cosine.
#ifndef GAUNT_PRODUCT_AXIAL_H_
#define GAUNT_PRODUCT_AXIAL_H_

#include "product/product.h"

namespace gaunt::product::axial {

// About +z. Orders.a is that of the zonal functions, which have one plane per band and channel.
using ZonalFn = ProductFn;
using FixedFn = void (*)(int order, size_t channels, size_t count, const simd::InView& in,
                         const simd::OutView& out);
// About an axis of each item, 3 planes of a unit vector.
using ZonalAxisFn = void (*)(const Orders& orders, size_t channels, size_t count,
                             const simd::InView& zonal, const simd::InView& axes,
                             const simd::InView& b, const simd::OutView& out);
using FixedAxisFn = void (*)(int order, size_t channels, size_t count, const simd::InView& axes,
                             const simd::InView& in, const simd::OutView& out);

struct Table {
  ZonalFn zonal;
  ZonalAxisFn zonal_axis;
  FixedFn hemisphere;
  FixedAxisFn hemisphere_axis;
  FixedFn cosine;
  FixedAxisFn cosine_axis;
};

const Table& Kernels();

}  // namespace gaunt::product::axial

#endif  // GAUNT_PRODUCT_AXIAL_H_
