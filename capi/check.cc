// SPDX-License-Identifier: MIT
#include "check.h"

#include <algorithm>
#include <utility>

namespace gaunt::capi {
namespace {

// No array is larger than this, so sums of a few such spans cannot overflow.
constexpr ptrdiff_t kMaxSpan = PTRDIFF_MAX / 8;

ptrdiff_t Magnitude(ptrdiff_t stride) { return stride < 0 ? -stride : stride; }

// (n - 1) * stride, or false if it is absurd. Without a division: this runs on every call.
bool SpanOf(size_t n, ptrdiff_t stride, ptrdiff_t* span) {
  *span = 0;
  if (n <= 1 || stride == 0) return true;
  constexpr size_t kHalfWord = size_t{1} << (4 * sizeof(size_t));
  const size_t magnitude =
      stride < 0 ? size_t{0} - static_cast<size_t>(stride) : static_cast<size_t>(stride);
  if ((n >= kHalfWord || magnitude >= kHalfWord) &&
      n - 1 > static_cast<size_t>(kMaxSpan) / magnitude) {
    return false;
  }
  const size_t product = (n - 1) * magnitude;
  if (product > static_cast<size_t>(kMaxSpan)) return false;
  *span = stride < 0 ? -static_cast<ptrdiff_t>(product) : static_cast<ptrdiff_t>(product);
  return true;
}

}  // namespace

void MemoryCheck::Fail(gaunt_status status) {
  // They are numbered in the order in which they are looked for.
  if (status_ == GAUNT_OK || status > status_) status_ = status;
}

gaunt_status MemoryCheck::status() const { return status_; }

MemoryCheck& MemoryCheck::In(const gaunt_view* view, size_t planes) {
  AddView(view, count_, planes, Kind::kIn);
  return *this;
}
MemoryCheck& MemoryCheck::Out(const gaunt_view* view, size_t planes) {
  AddView(view, count_, planes, Kind::kOut);
  return *this;
}
MemoryCheck& MemoryCheck::OutInPlace(const gaunt_view* view, size_t planes) {
  AddView(view, count_, planes, Kind::kOutInPlace);
  return *this;
}
MemoryCheck& MemoryCheck::OutItem(const gaunt_view* view, size_t planes) {
  AddView(view, 1, planes, Kind::kOut);
  return *this;
}
MemoryCheck& MemoryCheck::InRecords(const void* data, size_t records, size_t bytes, size_t stride) {
  AddRecords(data, records, bytes, stride, Kind::kIn);
  return *this;
}
MemoryCheck& MemoryCheck::OutRecords(const void* data, size_t records, size_t bytes,
                                     size_t stride) {
  AddRecords(data, records, bytes, stride, Kind::kOut);
  return *this;
}

void MemoryCheck::AddView(const gaunt_view* view, size_t count, size_t planes, Kind kind) {
  if (count == 0) return;
  if (view == nullptr || view->data == nullptr) return Fail(GAUNT_ERROR_NULL);

  Memory& m = memories_[used_];  // in place: copies of it cost as much as the checks
  m.is_view = true;
  m.origin = reinterpret_cast<uintptr_t>(view->data);
  m.plane_count = planes;
  m.tile_items = view->tile_items == 0 ? count : std::min(view->tile_items, count);
  m.items_in_tile = m.tile_items;
  m.tiles = (count - 1) / m.tile_items + 1;
  m.item_stride = m.items_in_tile > 1 ? view->item_stride : 0;
  m.tile_stride = m.tiles > 1 ? view->tile_stride : 0;
  m.plane_stride = planes > 1 ? view->plane_stride : 0;

  constexpr ptrdiff_t kFloat = sizeof(float);
  if (m.origin % alignof(float) != 0 || m.item_stride % kFloat != 0 ||
      m.plane_stride % kFloat != 0 || m.tile_stride % kFloat != 0) {
    return Fail(GAUNT_ERROR_LAYOUT);
  }
  ptrdiff_t items, tiles, rows;
  if (!SpanOf(m.items_in_tile, m.item_stride, &items) || !SpanOf(m.tiles, m.tile_stride, &tiles) ||
      !SpanOf(planes, m.plane_stride, &rows)) {
    return Fail(GAUNT_ERROR_RANGE);
  }
  const auto extend = [](Range range, ptrdiff_t span) {
    return Range{range.from + std::min<ptrdiff_t>(span, 0),
                 range.to + std::max<ptrdiff_t>(span, 0)};
  };
  m.planes = extend({0, kFloat}, rows);
  m.tile = extend(m.planes, items);
  m.all = extend(m.tile, tiles);
  if (kind != Kind::kIn && !Nests(m)) return Fail(GAUNT_ERROR_LAYOUT);
  Add(m, kind);
}

void MemoryCheck::AddRecords(const void* data, size_t records, size_t bytes, size_t stride,
                             Kind kind) {
  if (records == 0) return;
  if (data == nullptr) return Fail(GAUNT_ERROR_NULL);
  ptrdiff_t span;
  if (stride < bytes || stride > static_cast<size_t>(kMaxSpan) ||
      !SpanOf(records, static_cast<ptrdiff_t>(stride), &span)) {
    return Fail(GAUNT_ERROR_RANGE);
  }
  Memory& m = memories_[used_];
  m.is_view = false;
  m.origin = reinterpret_cast<uintptr_t>(data);
  m.all = {0, span + static_cast<ptrdiff_t>(bytes)};
  Add(m, kind);
}

void MemoryCheck::Add(const Memory& memory, Kind kind) {
  // An array does not wrap around the end of memory.
  if (static_cast<uintptr_t>(-memory.all.from) > memory.origin ||
      static_cast<uintptr_t>(memory.all.to) > UINTPTR_MAX - memory.origin) {
    return Fail(GAUNT_ERROR_RANGE);
  }
  if (kind != Kind::kIn) {
    for (int i = 0; i < used_; ++i) {
      const bool in_place = kind == Kind::kOutInPlace && Same(memory, memories_[i]);
      if (!in_place && !Apart(memory, memories_[i])) Fail(GAUNT_ERROR_OVERLAP);
    }
  }
  ++used_;
}

// Whether elements of an output are surely distinct: in the order of their strides, each dimension
// steps over all that the smaller ones span.
bool MemoryCheck::Nests(const Memory& m) {
  struct Dimension {
    size_t n;
    ptrdiff_t stride;
  };
  Dimension a = {m.items_in_tile, Magnitude(m.item_stride)};
  Dimension b = {m.plane_count, Magnitude(m.plane_stride)};
  Dimension c = {m.tiles, Magnitude(m.tile_stride)};
  if (b.stride < a.stride) std::swap(a, b);
  if (c.stride < b.stride) std::swap(b, c);
  if (b.stride < a.stride) std::swap(a, b);
  ptrdiff_t span = sizeof(float);
  for (const Dimension& dimension : {a, b, c}) {
    if (dimension.n <= 1) continue;
    if (dimension.stride < span) return false;
    span += static_cast<ptrdiff_t>(dimension.n - 1) * dimension.stride;
  }
  return true;
}

bool MemoryCheck::Same(const Memory& a, const Memory& b) {
  return a.is_view && b.is_view && a.origin == b.origin && a.item_stride == b.item_stride &&
         a.plane_stride == b.plane_stride && a.tile_stride == b.tile_stride &&
         a.tile_items == b.tile_items && a.plane_count == b.plane_count;
}

bool MemoryCheck::Apart(const Memory& a, const Memory& b) {
  // Ranges of both relative to a's origin; modular arithmetic is exact where it matters.
  const ptrdiff_t shift = static_cast<ptrdiff_t>(b.origin - a.origin);
  const auto disjoint = [&](const Range& x, const Range& y) {
    return shift + y.from >= x.to || x.from >= shift + y.to;
  };
  const auto together = [&](const Range& x, const Range& y) {
    return std::max(x.to, shift + y.to) - std::min(x.from, shift + y.from);
  };
  if (a.origin + static_cast<uintptr_t>(a.all.to) <=
          b.origin + static_cast<uintptr_t>(b.all.from) ||
      b.origin + static_cast<uintptr_t>(b.all.to) <=
          a.origin + static_cast<uintptr_t>(a.all.from)) {
    return true;
  }
  // Ranges meet, so the origins are near and `shift` cannot have overflowed. Fields of one record?
  if (!a.is_view || !b.is_view || a.item_stride != b.item_stride ||
      a.tile_stride != b.tile_stride || a.tile_items != b.tile_items) {
    return false;
  }
  const ptrdiff_t item = Magnitude(a.item_stride), tile = Magnitude(a.tile_stride);
  const bool inside_item = disjoint(a.planes, b.planes) && together(a.planes, b.planes) <= item &&
                           (a.tiles == 1 || tile >= static_cast<ptrdiff_t>(a.items_in_tile) * item);
  const bool inside_tile =
      a.tiles > 1 && disjoint(a.tile, b.tile) && together(a.tile, b.tile) <= tile;
  return inside_item || inside_tile;
}

namespace {

template <typename View, typename Byte>
View Normalised(const gaunt_view& view, size_t count, Byte* data) {
  View result = {data, view.item_stride, view.plane_stride, view.tile_stride, view.tile_items};
  if (result.tile_items >= count) result.tile_items = 0;
  if (result.tile_items == 0) result.tile_stride = 0;
  return result;
}

}  // namespace

simd::InView InputOf(const gaunt_view& view, size_t count) {
  simd::InView result =
      Normalised<simd::InView>(view, count, reinterpret_cast<const unsigned char*>(view.data));
  if (count == 1) result.item_stride = 0;  // a broadcast of the one item
  return result;
}

simd::OutView OutputOf(const gaunt_view& view, size_t count) {
  simd::OutView result =
      Normalised<simd::OutView>(view, count, reinterpret_cast<unsigned char*>(view.data));
  if (count == 1) result.item_stride = sizeof(float);
  return result;
}

}  // namespace gaunt::capi
