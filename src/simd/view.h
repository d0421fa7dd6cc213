// SPDX-License-Identifier: MIT
// The layout of a batch as the kernels' drivers see it: gaunt_view without the C API around it.
#ifndef GAUNT_SIMD_VIEW_H_
#define GAUNT_SIMD_VIEW_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::simd {

// Element (item i, plane p) lies at
//   data + (i / tile_items) * tile_stride + (i % tile_items) * item_stride + p * plane_stride
// with strides in bytes; tile_items 0 means that one tile holds every item.
template <typename Byte>
struct BasicView {
  Byte* data;
  ptrdiff_t item_stride;
  ptrdiff_t plane_stride;
  ptrdiff_t tile_stride;
  size_t tile_items;

  bool IsBroadcast() const { return item_stride == 0 && tile_stride == 0; }

  // Address of plane 0 of item i.
  Byte* Item(size_t i) const {
    if (i == 0) return data;  // the usual call, and divisions are slow
    if (tile_items == 0) return data + static_cast<ptrdiff_t>(i) * item_stride;
    return data + static_cast<ptrdiff_t>(i / tile_items) * tile_stride +
           static_cast<ptrdiff_t>(i % tile_items) * item_stride;
  }

  // The same items, beginning at plane p.
  BasicView FromPlane(size_t p) const {
    BasicView view = *this;
    view.data += static_cast<ptrdiff_t>(p) * plane_stride;
    return view;
  }
};

using InView = BasicView<const unsigned char>;
using OutView = BasicView<unsigned char>;

// Contiguous items of `planes` floats each.
inline InView InterleavedIn(const float* data, size_t planes) {
  return {reinterpret_cast<const unsigned char*>(data), static_cast<ptrdiff_t>(planes * 4), 4, 0,
          0};
}
inline OutView InterleavedOut(float* data, size_t planes) {
  return {reinterpret_cast<unsigned char*>(data), static_cast<ptrdiff_t>(planes * 4), 4, 0, 0};
}
// One item for every i.
inline InView BroadcastIn(const float* data) {
  return {reinterpret_cast<const unsigned char*>(data), 0, 4, 0, 0};
}
// Contiguous planes of `capacity` items each.
inline InView PlanarIn(const float* data, size_t capacity) {
  return {reinterpret_cast<const unsigned char*>(data), 4, static_cast<ptrdiff_t>(capacity * 4), 0,
          0};
}

}  // namespace gaunt::simd

#endif  // GAUNT_SIMD_VIEW_H_
