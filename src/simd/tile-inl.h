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

// The layouts that the fast conversions know: contiguous planes per item.
enum class RowShape {
  kOther,    // any strides
  kRows,     // at least four planes
  kTriples,  // three
  kPacked3,  // three, back to back
  kPacked9   // nine, back to back
};

template <typename View>
RowShape ShapeOf(const View& view, size_t planes) {
  const bool one_run = view.tile_items == 0 || view.tile_items % hn::Lanes(LaneTag()) == 0;
  if (!GAUNT_TRANSPOSES || view.plane_stride != 4 || !one_run) return RowShape::kOther;
#if GAUNT_WIDE_TRANSPOSES
  if (view.item_stride == static_cast<ptrdiff_t>(planes * sizeof(float))) {
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

GAUNT_LANES void LoadGroup(RowShape shape, const unsigned char* row, ptrdiff_t item_stride,
                           size_t planes, float* HWY_RESTRICT tile) {
#if GAUNT_WIDE_TRANSPOSES
  const float* rows = reinterpret_cast<const float*>(row);
  if (shape == RowShape::kPacked3) return OddRows<3>().Load(rows, tile, kTileItems);
  if (shape == RowShape::kPacked9) return OddRows<9>().Load(rows, tile, kTileItems);
#endif
  if (shape == RowShape::kTriples) {
    if (item_stride == 3 * sizeof(float)) {
      return LoadBlock<3, 4>(LaneTag(), row, item_stride, tile, kTileItems);
    }
    return LoadBlock<3>(LaneTag(), row, item_stride, tile, kTileItems);
  }
  LoadRows(row, item_stride, planes, tile);
}

GAUNT_LANES void StoreGroup(RowShape shape, const float* HWY_RESTRICT tile, unsigned char* row,
                            ptrdiff_t item_stride, size_t planes) {
#if GAUNT_WIDE_TRANSPOSES
  float* rows = reinterpret_cast<float*>(row);
  if (shape == RowShape::kPacked3) return OddRows<3>().Store(tile, kTileItems, rows);
  if (shape == RowShape::kPacked9) return OddRows<9>().Store(tile, kTileItems, rows);
#endif
  if (shape == RowShape::kTriples) {
    return StoreBlock<3>(LaneTag(), tile, kTileItems, row, item_stride);
  }
  StoreRows(tile, row, item_stride, planes);
}

#else

inline void LoadGroup(RowShape, const unsigned char*, ptrdiff_t, size_t, float*) {}
inline void StoreGroup(RowShape, const float*, unsigned char*, ptrdiff_t, size_t) {}

#endif

// Items first .. first + n into consecutive tiles. Lanes of the last group beyond n repeat an item,
// so that they cost no slow arithmetic on leftover bits.
inline HWY_NOINLINE void LoadTiles(const simd::InView& view, RowShape shape, size_t first, size_t n,
                                   size_t planes, float* HWY_RESTRICT tile) {
  const size_t lanes = hn::Lanes(LaneTag());
  size_t i = 0;
  for (; shape != RowShape::kOther && i + lanes <= n; i += lanes) {
    LoadGroup(shape, view.Item(first + i), view.item_stride, planes, InTiles(tile, planes, i));
  }
  for (; i < n; i += lanes) {
    float* const group = InTiles(tile, planes, i);
    for (size_t lane = 0; lane < lanes; ++lane) {
      const unsigned char* item = view.Item(first + i + (i + lane < n ? lane : 0));
      for (size_t p = 0; p < planes; ++p) {
        std::memcpy(group + p * kTileItems + lane,
                    item + static_cast<ptrdiff_t>(p) * view.plane_stride, sizeof(float));
      }
    }
  }
}

inline HWY_NOINLINE void StoreTiles(const float* HWY_RESTRICT tile, const simd::OutView& view,
                                    RowShape shape, size_t first, size_t n, size_t planes) {
  const size_t lanes = hn::Lanes(LaneTag());
  size_t i = 0;
  for (; shape != RowShape::kOther && i + lanes <= n; i += lanes) {
    StoreGroup(shape, InTiles(tile, planes, i), view.Item(first + i), view.item_stride, planes);
  }
  for (; i < n; ++i) {
    const float* const from = InTiles(tile, planes, i);
    unsigned char* item = view.Item(first + i);
    for (size_t p = 0; p < planes; ++p) {
      std::memcpy(item + static_cast<ptrdiff_t>(p) * view.plane_stride, from + p * kTileItems,
                  sizeof(float));
    }
  }
}

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_TILE_INL_H_
