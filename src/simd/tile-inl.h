// SPDX-License-Identifier: MIT
// Stack tiles: 16 items of planes, plane after plane, which stand in for batches that a kernel cannot
// use where they lie. Conversion between them and any layout. Never touches an element outside the
// described ones.
#if defined(GAUNT_SIMD_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_TILE_INL_H_
#undef GAUNT_SIMD_TILE_INL_H_
#else
#define GAUNT_SIMD_TILE_INL_H_
#endif

#include <algorithm>
#include <cstring>

#include "simd/transpose-inl.h"
#include "simd/view.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

// Items of a stack tile: as many as the widest vector has lanes, and a cache line of each plane.
inline constexpr size_t kTileItems = kMaxLanes;
inline constexpr ptrdiff_t kTileStride = kTileItems * sizeof(float);

// Where the planes of item i begin, of the tiles that start at `tile`.
template <typename Float>
GAUNT_LANES Float* InTiles(Float* tile, size_t planes, size_t i) {
  return tile + i / kTileItems * planes * kTileItems + i % kTileItems;
}

// Planes of a tile, from an item on.
GAUNT_LANES PlanesIn TileIn(const float* tile) {
  return {reinterpret_cast<const unsigned char*>(tile), kTileStride};
}
GAUNT_LANES PlanesOut TileOut(float* tile) {
  return {reinterpret_cast<unsigned char*>(tile), kTileStride};
}

// The layouts that the fast conversions know: contiguous items per plane, or planes per item.
enum class RowShape {
  kOther,    // any strides
  kPlanes,   // contiguous items
  kRows,     // at least four planes
  kTriples,  // three
  kPacked3,  // three, back to back
  kPacked9   // nine, back to back
};

// Whether items are rows of contiguous planes, back to back.
template <typename View>
bool IsPacked(const View& view, size_t planes) {
  return view.tile_items == 0 && view.plane_stride == sizeof(float) &&
         view.item_stride == static_cast<ptrdiff_t>(planes * sizeof(float));
}

// Whether runs of so many items, which begin at multiples of it, are contiguous in each plane.
template <typename View>
bool IsContiguous(const View& view, size_t run) {
  return view.item_stride == sizeof(float) && view.tile_items % run == 0;
}

template <typename View>
RowShape ShapeOf(const View& view, size_t planes) {
  if (view.tile_items % hn::Lanes(LaneTag()) != 0) return RowShape::kOther;
  if (view.item_stride == sizeof(float)) return RowShape::kPlanes;
  if (!GAUNT_TRANSPOSES || view.plane_stride != 4) return RowShape::kOther;
#if GAUNT_WIDE_TRANSPOSES
  if (view.tile_items == 0 && view.item_stride == static_cast<ptrdiff_t>(planes * sizeof(float))) {
    if (planes == 3) return RowShape::kPacked3;
    if (planes == 9) return RowShape::kPacked9;
  }
#endif
  return planes >= 4 ? RowShape::kRows : planes == 3 ? RowShape::kTriples : RowShape::kOther;
}

#if GAUNT_TRANSPOSES

// A group of lanes of items, from rows of at least four contiguous floats.
GAUNT_LANES void LoadRows(const unsigned char* row, ptrdiff_t item_stride, size_t planes,
                          float* HWY_RESTRICT tile) {
  size_t p = 0;
#if GAUNT_WIDE_TRANSPOSES
  for (; p + 8 <= planes; p += 8) {
    for (size_t i = 0; i < hn::MaxLanes(LaneTag()); i += 8) {
      LoadEight(row + 4 * p + static_cast<ptrdiff_t>(i) * item_stride, item_stride,
                tile + p * kTileItems + i, kTileItems);
    }
  }
#endif
  for (; p < planes; p += 4) {
    p = std::min(p, planes - 4);  // the last block may overlap the one before
    LoadBlock<4>(LaneTag(), row + 4 * p, item_stride, tile + p * kTileItems, kTileItems);
  }
}

GAUNT_LANES void StoreRows(const float* HWY_RESTRICT tile, unsigned char* row,
                           ptrdiff_t item_stride, size_t planes) {
  size_t p = 0;
#if GAUNT_WIDE_TRANSPOSES
  for (; p + 8 <= planes; p += 8) {
    for (size_t i = 0; i < hn::MaxLanes(LaneTag()); i += 8) {
      StoreEight(tile + p * kTileItems + i, kTileItems,
                 row + 4 * p + static_cast<ptrdiff_t>(i) * item_stride, item_stride);
    }
  }
#endif
  for (; p < planes; p += 4) {
    p = std::min(p, planes - 4);
    StoreBlock<4>(LaneTag(), tile + p * kTileItems, kTileItems, row + 4 * p, item_stride);
  }
}

#if GAUNT_WIDE_TRANSPOSES

// A group of items back to back.
template <size_t kRow>
GAUNT_LANES void LoadPackedGroup(const float* HWY_RESTRICT rows, float* HWY_RESTRICT tile) {
  if constexpr (kRow == 3 || kRow == 9) {
    OddRows<kRow>().Load(rows, tile, kTileItems);
  } else {
    LoadRows(reinterpret_cast<const unsigned char*>(rows), kRow * sizeof(float), kRow, tile);
  }
}

template <size_t kRow>
GAUNT_LANES void StorePackedGroup(const float* HWY_RESTRICT tile, float* HWY_RESTRICT rows) {
  if constexpr (kRow == 3 || kRow == 9) {
    OddRows<kRow>().Store(tile, kTileItems, rows);
  } else {
    StoreRows(tile, reinterpret_cast<unsigned char*>(rows), kRow * sizeof(float), kRow);
  }
}

template <size_t kRow>
GAUNT_LANES void LoadPacked(const float* HWY_RESTRICT rows, size_t items,
                            float* HWY_RESTRICT tile) {
  for (size_t i = 0; i < items; i += hn::MaxLanes(LaneTag())) {
    LoadPackedGroup<kRow>(rows + i * kRow, InTiles(tile, kRow, i));
  }
}

template <size_t kRow>
GAUNT_LANES void StorePacked(const float* HWY_RESTRICT tile, size_t items,
                             float* HWY_RESTRICT rows) {
  for (size_t i = 0; i < items; i += hn::MaxLanes(LaneTag())) {
    StorePackedGroup<kRow>(InTiles(tile, kRow, i), rows + i * kRow);
  }
}

#endif

// Whole groups of items first .. first + n, in a shape that has a fast conversion.
GAUNT_LANES void LoadGroups(const simd::InView& view, RowShape shape, size_t first, size_t n,
                            size_t planes, float* HWY_RESTRICT tile) {
#if GAUNT_WIDE_TRANSPOSES
  const float* rows = reinterpret_cast<const float*>(view.Item(first));
  if (shape == RowShape::kPacked3) return LoadPacked<3>(rows, n, tile);
  if (shape == RowShape::kPacked9) return LoadPacked<9>(rows, n, tile);
#endif
  for (size_t i = 0; i < n; i += hn::MaxLanes(LaneTag())) {
    const unsigned char* row = view.Item(first + i);
    float* const group = InTiles(tile, planes, i);
    if (shape == RowShape::kRows) {
      LoadRows(row, view.item_stride, planes, group);
    } else if (view.item_stride == 3 * sizeof(float)) {
      LoadBlock<3, 4>(LaneTag(), row, view.item_stride, group, kTileItems);
    } else {
      LoadBlock<3>(LaneTag(), row, view.item_stride, group, kTileItems);
    }
  }
}

GAUNT_LANES void StoreGroups(const float* HWY_RESTRICT tile, const simd::OutView& view,
                             RowShape shape, size_t first, size_t n, size_t planes) {
#if GAUNT_WIDE_TRANSPOSES
  float* rows = reinterpret_cast<float*>(view.Item(first));
  if (shape == RowShape::kPacked3) return StorePacked<3>(tile, n, rows);
  if (shape == RowShape::kPacked9) return StorePacked<9>(tile, n, rows);
#endif
  for (size_t i = 0; i < n; i += hn::MaxLanes(LaneTag())) {
    unsigned char* row = view.Item(first + i);
    const float* const group = InTiles(tile, planes, i);
    if (shape == RowShape::kRows) {
      StoreRows(group, row, view.item_stride, planes);
    } else {
      StoreBlock<3>(LaneTag(), group, kTileItems, row, view.item_stride);
    }
  }
}

#else

inline void LoadGroups(const simd::InView&, RowShape, size_t, size_t, size_t, float*) {}
inline void StoreGroups(const float*, const simd::OutView&, RowShape, size_t, size_t, size_t) {}

#endif

// kBit floats if n has that bit, then the lower bits: a run of fewer than two vectors.
template <size_t kBit = kTileItems / 2>
GAUNT_LANES void CopyRun(const unsigned char* HWY_RESTRICT from, unsigned char* HWY_RESTRICT to,
                         size_t n) {
  if constexpr (kBit != 0) {
    const size_t bytes = (n & kBit) * sizeof(float);
    if (bytes != 0) std::memcpy(to, from, kBit * sizeof(float));
    CopyRun<kBit / 2>(from + bytes, to + bytes, n);
  }
}

// Whole groups of contiguous items per plane.
GAUNT_LANES void CopyPlanes(PlanesIn from, PlanesOut to, size_t planes) {
  for (size_t p = 0; p < planes; ++p) to(p, from(p));
}

// The last n items of a batch, fewer than lanes, in any layout. Lanes beyond them repeat the first,
// so that they cost no slow arithmetic on leftover bits.
GAUNT_LANES void LoadTail(const simd::InView& view, RowShape shape, size_t first, size_t n,
                          size_t planes, float* HWY_RESTRICT tile) {
  const LaneTag d;
  for (size_t p = 0; p < planes; ++p) {
    const unsigned char* const from =
        view.Item(first) + static_cast<ptrdiff_t>(p) * view.plane_stride;
    float* const to = tile + p * kTileItems;
    float value;
    std::memcpy(&value, from, sizeof(value));
    hn::Store(hn::Set(d, value), d, to);
    if (shape == RowShape::kPlanes) CopyRun(from, reinterpret_cast<unsigned char*>(to), n);
  }
  if (shape == RowShape::kPlanes) return;
  for (size_t lane = 1; lane < n; ++lane) {
    const unsigned char* const item = view.Item(first + lane);
    for (size_t p = 0; p < planes; ++p) {
      std::memcpy(tile + p * kTileItems + lane,
                  item + static_cast<ptrdiff_t>(p) * view.plane_stride, sizeof(float));
    }
  }
}

GAUNT_LANES void StoreTail(const float* HWY_RESTRICT tile, const simd::OutView& view,
                           RowShape shape, size_t first, size_t n, size_t planes) {
  if (shape == RowShape::kPlanes) {
    unsigned char* to = view.Item(first);
    for (size_t p = 0; p < planes; ++p, to += view.plane_stride) {
      CopyRun(reinterpret_cast<const unsigned char*>(tile + p * kTileItems), to, n);
    }
    return;
  }
  for (size_t lane = 0; lane < n; ++lane) {
    unsigned char* const item = view.Item(first + lane);
    for (size_t p = 0; p < planes; ++p) {
      std::memcpy(item + static_cast<ptrdiff_t>(p) * view.plane_stride,
                  tile + p * kTileItems + lane, sizeof(float));
    }
  }
}

// Items first .. first + n into consecutive tiles.
inline HWY_NOINLINE void LoadTiles(const simd::InView& view, RowShape shape, size_t first, size_t n,
                                   size_t planes, float* HWY_RESTRICT tile) {
  const size_t lanes = hn::Lanes(LaneTag());
  const size_t whole = n / lanes * lanes;
  size_t i = 0;
  if (shape == RowShape::kPlanes) {
    for (; i < whole; i += lanes) {
      CopyPlanes({view.Item(first + i), view.plane_stride}, TileOut(InTiles(tile, planes, i)),
                 planes);
    }
  } else if (shape != RowShape::kOther && whole != 0) {
    LoadGroups(view, shape, first, whole, planes, tile);
    i = whole;
  }
  for (; i < n; i += lanes) {
    LoadTail(view, shape, first + i, std::min(lanes, n - i), planes, InTiles(tile, planes, i));
  }
}

inline HWY_NOINLINE void StoreTiles(const float* HWY_RESTRICT tile, const simd::OutView& view,
                                    RowShape shape, size_t first, size_t n, size_t planes) {
  const size_t lanes = hn::Lanes(LaneTag());
  const size_t whole = n / lanes * lanes;
  size_t i = 0;
  if (shape == RowShape::kPlanes) {
    for (; i < whole; i += lanes) {
      CopyPlanes(TileIn(InTiles(tile, planes, i)), {view.Item(first + i), view.plane_stride},
                 planes);
    }
  } else if (shape != RowShape::kOther && whole != 0) {
    StoreGroups(tile, view, shape, first, whole, planes);
    i = whole;
  }
  for (; i < n; i += lanes) {
    StoreTail(InTiles(tile, planes, i), view, shape, first + i, std::min(lanes, n - i), planes);
  }
}

// Packed rows have at most so many planes where they are put together on the stack.
inline constexpr size_t kMaxPackedPlanes = 128;

// Whether whole tiles of a batch can be written by stores that pass the caches by: planes or packed
// rows that begin on cache lines.
inline bool CanStream(const simd::OutView& view, size_t first, size_t planes) {
  constexpr ptrdiff_t kLine = kTileStride;
  if (!HWY_ARCH_X86 || reinterpret_cast<intptr_t>(view.Item(first)) % kLine != 0) return false;
  if (IsContiguous(view, kTileItems)) {
    return view.plane_stride % kLine == 0 && first % kTileItems == 0 &&
           view.tile_stride % kLine == 0;
  }
  return IsPacked(view, planes) && planes <= kMaxPackedPlanes &&
         ShapeOf(view, planes) != RowShape::kOther;
}

GAUNT_LANES void StreamLine(const float* HWY_RESTRICT from, unsigned char* to) {
  const LaneTag d;
  for (size_t i = 0; i < kTileItems; i += hn::Lanes(d)) {
    hn::Stream(hn::Load(d, from + i), d, reinterpret_cast<float*>(to) + i);
  }
}

// StoreTiles for a batch that CanStream, of whole tiles. Lines are written whole and in the order of
// their addresses: anything else is slower than ordinary stores.
inline HWY_NOINLINE void StreamTiles(const float* HWY_RESTRICT tile, const simd::OutView& view,
                                     RowShape shape, size_t first, size_t n, size_t planes) {
  HWY_ALIGN float rows[kTileItems * kMaxPackedPlanes];
  for (size_t i = 0; i < n; i += kTileItems, tile += planes * kTileItems) {
    unsigned char* const to = view.Item(first + i);
    const float* lines = tile;
    ptrdiff_t stride = view.plane_stride;
    if (view.item_stride != sizeof(float)) {
      const simd::OutView packed = {reinterpret_cast<unsigned char*>(rows), view.item_stride,
                                    view.plane_stride, 0, 0};
      StoreTiles(tile, packed, shape, 0, kTileItems, planes);
      lines = rows;
      stride = kTileStride;
    }
    for (size_t p = 0; p < planes; ++p) {
      StreamLine(lines + p * kTileItems, to + static_cast<ptrdiff_t>(p) * stride);
    }
  }
}

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_TILE_INL_H_
