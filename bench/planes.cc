// SPDX-License-Identifier: MIT
#include "bench/planes.h"

#include <memory>

namespace gaunt::bench {

constexpr size_t kLine = 64;

const char* Name(Layout layout) {
  switch (layout) {
    case Layout::kPlanar: return "planar";
    case Layout::kInterleaved: return "interleaved";
    case Layout::kTiled: return "tiled";
    case Layout::kBroadcast: return "broadcast";
  }
  return "";
}

Planes::Planes(Layout layout, size_t count, size_t planes)
    : count_(layout == Layout::kBroadcast ? 1 : count),
      planes_(planes),
      memory_((count_ + 64) * planes + 64) {
  void* at = memory_.data();
  size_t room = memory_.size() * sizeof(float);
  float* data = static_cast<float*>(std::align(kLine, kLine, at, room));
  switch (layout) {
    case Layout::kPlanar:
      gaunt_view_planar(data, static_cast<ptrdiff_t>(count * sizeof(float)), &view_);
      break;
    case Layout::kInterleaved: gaunt_view_interleaved(data, planes, &view_); break;
    case Layout::kTiled: gaunt_view_tiled(data, planes, &view_); break;
    case Layout::kBroadcast: gaunt_view_broadcast(data, &view_); break;
  }
}

void Planes::Fill(const std::function<void(size_t item, float* planes)>& make) {
  std::vector<float> item(planes_);
  for (size_t i = 0; i < count_; ++i) {
    make(i, item.data());
    for (size_t p = 0; p < planes_; ++p) *Element(i, p) = item[p];
  }
}

std::vector<double> Planes::Item(size_t item) const {
  std::vector<double> values(planes_);
  for (size_t p = 0; p < planes_; ++p) values[p] = *Element(count_ == 1 ? 0 : item, p);
  return values;
}

float* Planes::Element(size_t item, size_t plane) const {
  ptrdiff_t bytes = static_cast<ptrdiff_t>(plane) * view_.plane_stride;
  if (view_.tile_items == 0) {
    bytes += static_cast<ptrdiff_t>(item) * view_.item_stride;
  } else {
    bytes += static_cast<ptrdiff_t>(item / view_.tile_items) * view_.tile_stride +
             static_cast<ptrdiff_t>(item % view_.tile_items) * view_.item_stride;
  }
  return view_.data + bytes / static_cast<ptrdiff_t>(sizeof(float));
}

}  // namespace gaunt::bench
