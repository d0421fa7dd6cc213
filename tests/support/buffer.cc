// SPDX-License-Identifier: MIT
#include "tests/support/buffer.h"

#include <cstring>

namespace gaunt::test {
namespace {

// A NaN of its own, so that kernels which read it are found out by their results.
float Canary() {
  const uint32_t bits = 0x7FC0BEEF;
  float canary;
  std::memcpy(&canary, &bits, sizeof(canary));
  return canary;
}

bool SameBits(float a, float b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

constexpr size_t kMargin = 24;  // floats before and after
constexpr size_t kLine = 16;    // floats of a cache line

}  // namespace

const std::vector<Layout>& Layouts() {
  static const std::vector<Layout> layouts = {
      Layout::kPlanar, Layout::kPlanarPowerOfTwo, Layout::kInterleaved, Layout::kRecord,
      Layout::kTiled,  Layout::kOddTiles,         Layout::kBackwards,   Layout::kScattered};
  return layouts;
}

std::string Name(Layout layout) {
  switch (layout) {
    case Layout::kPlanar: return "planar";
    case Layout::kPlanarPowerOfTwo: return "planar_4k";
    case Layout::kInterleaved: return "interleaved";
    case Layout::kRecord: return "record";
    case Layout::kTiled: return "tiled";
    case Layout::kOddTiles: return "odd_tiles";
    case Layout::kBackwards: return "backwards";
    case Layout::kScattered: return "scattered";
    case Layout::kBroadcast: return "broadcast";
  }
  return "";
}

Buffer::Buffer(Layout layout, size_t count, size_t planes, Start start)
    : count_(count), planes_(planes) {
  const ptrdiff_t n = static_cast<ptrdiff_t>(count), p = static_cast<ptrdiff_t>(planes);
  ptrdiff_t item = 0, plane = 1, tile = 0, first = 0, floats = 0;
  size_t tile_items = 0;
  switch (layout) {
    case Layout::kPlanar:
      item = 1, plane = start == Start::kLine ? (n + 31) / 16 * 16 : n + 3, floats = p * plane;
      break;
    case Layout::kPlanarPowerOfTwo: item = 1, plane = 1024, floats = p * plane; break;
    case Layout::kInterleaved: item = p, floats = n * p; break;
    case Layout::kRecord: item = p + 5, first = 2, floats = n * item; break;
    case Layout::kTiled:
      item = 1, plane = 16, tile = 16 * p, tile_items = 16, floats = (n + 15) / 16 * tile;
      break;
    case Layout::kOddTiles:
      item = 1, plane = 5, tile = 5 * p + 1, tile_items = 5, floats = (n + 4) / 5 * tile;
      break;
    case Layout::kBackwards: item = -1, plane = n + 1, first = n - 1, floats = p * plane; break;
    case Layout::kScattered: item = 3, plane = 3 * n + 1, floats = p * plane; break;
    case Layout::kBroadcast: floats = p; break;
  }
  if (first < 0) first = 0;
  memory_.assign(static_cast<size_t>(floats) + 2 * kMargin + kLine, Canary());
  if (start == Start::kLine) {
    const size_t past =
        reinterpret_cast<uintptr_t>(memory_.data() + kMargin + first) / sizeof(float);
    first += static_cast<ptrdiff_t>((kLine - past % kLine) % kLine);
  }
  constexpr ptrdiff_t kFloat = sizeof(float);
  view_ = {memory_.data() + kMargin + first, item * kFloat, plane * kFloat, tile * kFloat,
           tile_items};
}

Buffer::Buffer(const Buffer& other)
    : count_(other.count_), planes_(other.planes_), view_(other.view_), memory_(other.memory_) {
  view_.data = memory_.data() + (other.view_.data - other.memory_.data());
}

size_t Buffer::Index(size_t item, size_t plane) const {
  ptrdiff_t bytes = static_cast<ptrdiff_t>(plane) * view_.plane_stride;
  if (view_.tile_items == 0) {
    bytes += static_cast<ptrdiff_t>(item) * view_.item_stride;
  } else {
    bytes += static_cast<ptrdiff_t>(item / view_.tile_items) * view_.tile_stride +
             static_cast<ptrdiff_t>(item % view_.tile_items) * view_.item_stride;
  }
  return static_cast<size_t>(view_.data - memory_.data() +
                             bytes / static_cast<ptrdiff_t>(sizeof(float)));
}

float Buffer::Get(size_t item, size_t plane) const { return memory_[Index(item, plane)]; }
void Buffer::Set(size_t item, size_t plane, float value) { memory_[Index(item, plane)] = value; }

bool Buffer::CanariesIntact() const {
  std::vector<char> element(memory_.size());
  for (size_t i = 0; i < count_; ++i) {
    for (size_t p = 0; p < planes_; ++p) element[Index(i, p)] = 1;
  }
  for (size_t k = 0; k < memory_.size(); ++k) {
    if (!element[k] && !SameBits(memory_[k], Canary())) return false;
  }
  return true;
}

}  // namespace gaunt::test
