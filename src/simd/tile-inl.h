// SPDX-License-Identifier: MIT
// Conversion between any layout and a stack tile of planes, one group of lanes at a time. Rows of
// contiguous planes are transposed in registers; everything else is copied element by element.
// Never touches an element outside the described ones.
#if defined(GAUNT_SIMD_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_TILE_INL_H_
#undef GAUNT_SIMD_TILE_INL_H_
#else
#define GAUNT_SIMD_TILE_INL_H_
#endif

#include <cstring>

#include "simd/lanes-inl.h"
#include "simd/view.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

// Bytes from plane to plane of a tile: room for the widest vector.
inline constexpr ptrdiff_t kTileStride = kMaxLanes * sizeof(float);

// The layouts that the fast conversions know.
enum class RowShape {
  kOther,  // any strides
  kRows,   // at least four contiguous planes per item: 4x4 transposes
  kPacked  // three planes, items back to back: interleaved loads and stores
};

template <typename View>
RowShape ShapeOf(const View& view, size_t planes) {
  const bool one_run = view.tile_items == 0 || view.tile_items % hn::Lanes(LaneTag()) == 0;
  if (HWY_HAVE_SCALABLE || HWY_TARGET == HWY_SCALAR || view.plane_stride != 4 || !one_run) {
    return RowShape::kOther;
  }
  if (planes >= 4) return RowShape::kRows;
  return planes == 3 && view.item_stride == 12 ? RowShape::kPacked : RowShape::kOther;
}

#if !HWY_HAVE_SCALABLE && HWY_TARGET != HWY_SCALAR

// Vector whose 128-bit block b holds four floats of item 4 b.
template <class D>
GAUNT_LANES hn::Vec<D> LoadBlocks(D d, const unsigned char* row, ptrdiff_t item_stride) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    return hn::LoadU(d, reinterpret_cast<const float*>(row));
  } else {
    const hn::Half<D> half;
    constexpr ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
    return hn::Combine(d, LoadBlocks(half, row + kHalf * item_stride, item_stride),
                       LoadBlocks(half, row, item_stride));
  }
}

template <class D>
GAUNT_LANES void StoreBlocks(D d, hn::Vec<D> v, unsigned char* row, ptrdiff_t item_stride) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    hn::StoreU(v, d, reinterpret_cast<float*>(row));
  } else {
    const hn::Half<D> half;
    constexpr ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
    StoreBlocks(half, hn::LowerHalf(half, v), row, item_stride);
    StoreBlocks(half, hn::UpperHalf(half, v), row + kHalf * item_stride, item_stride);
  }
}

// Transposes the 4x4 matrix in each 128-bit block of a, b, c, d.
template <class D, class V = hn::Vec<D>>
GAUNT_LANES void Transpose4(D d, V& a, V& b, V& c, V& e) {
  const hn::Repartition<uint64_t, D> wide;
  const auto ab_lower = hn::BitCast(wide, hn::InterleaveLower(d, a, b));
  const auto ab_upper = hn::BitCast(wide, hn::InterleaveUpper(d, a, b));
  const auto ce_lower = hn::BitCast(wide, hn::InterleaveLower(d, c, e));
  const auto ce_upper = hn::BitCast(wide, hn::InterleaveUpper(d, c, e));
  a = hn::BitCast(d, hn::InterleaveLower(wide, ab_lower, ce_lower));
  b = hn::BitCast(d, hn::InterleaveUpper(wide, ab_lower, ce_lower));
  c = hn::BitCast(d, hn::InterleaveLower(wide, ab_upper, ce_upper));
  e = hn::BitCast(d, hn::InterleaveUpper(wide, ab_upper, ce_upper));
}

HWY_INLINE void LoadRows(const unsigned char* row, ptrdiff_t item_stride, size_t planes,
                           float* HWY_RESTRICT tile) {
  const LaneTag d;
  for (size_t p = 0;;) {
    auto a = LoadBlocks(d, row + 4 * p, item_stride);
    auto b = LoadBlocks(d, row + 4 * p + item_stride, item_stride);
    auto c = LoadBlocks(d, row + 4 * p + 2 * item_stride, item_stride);
    auto e = LoadBlocks(d, row + 4 * p + 3 * item_stride, item_stride);
    Transpose4(d, a, b, c, e);
    hn::Store(a, d, tile + p * kMaxLanes);
    hn::Store(b, d, tile + (p + 1) * kMaxLanes);
    hn::Store(c, d, tile + (p + 2) * kMaxLanes);
    hn::Store(e, d, tile + (p + 3) * kMaxLanes);
    p += 4;
    if (p >= planes) return;
    if (p + 4 > planes) p = planes - 4;  // the last block overlaps the one before
  }
}

HWY_INLINE void StoreRows(const float* HWY_RESTRICT tile, size_t planes, unsigned char* row,
                            ptrdiff_t item_stride) {
  const LaneTag d;
  for (size_t p = 0;;) {
    auto a = hn::Load(d, tile + p * kMaxLanes);
    auto b = hn::Load(d, tile + (p + 1) * kMaxLanes);
    auto c = hn::Load(d, tile + (p + 2) * kMaxLanes);
    auto e = hn::Load(d, tile + (p + 3) * kMaxLanes);
    Transpose4(d, a, b, c, e);
    StoreBlocks(d, a, row + 4 * p, item_stride);
    StoreBlocks(d, b, row + 4 * p + item_stride, item_stride);
    StoreBlocks(d, c, row + 4 * p + 2 * item_stride, item_stride);
    StoreBlocks(d, e, row + 4 * p + 3 * item_stride, item_stride);
    p += 4;
    if (p >= planes) return;
    if (p + 4 > planes) p = planes - 4;
  }
}

HWY_INLINE void LoadPacked(const unsigned char* data, float* HWY_RESTRICT tile) {
  const LaneTag d;
  hn::Vec<LaneTag> x, y, z;
  hn::LoadInterleaved3(d, reinterpret_cast<const float*>(data), x, y, z);
  hn::Store(x, d, tile);
  hn::Store(y, d, tile + kMaxLanes);
  hn::Store(z, d, tile + 2 * kMaxLanes);
}

HWY_INLINE void StorePacked(const float* HWY_RESTRICT tile, unsigned char* data) {
  const LaneTag d;
  hn::StoreInterleaved3(hn::Load(d, tile), hn::Load(d, tile + kMaxLanes),
                        hn::Load(d, tile + 2 * kMaxLanes), d, reinterpret_cast<float*>(data));
}

#else

HWY_INLINE void LoadRows(const unsigned char*, ptrdiff_t, size_t, float*) {}
HWY_INLINE void StoreRows(const float*, size_t, unsigned char*, ptrdiff_t) {}
HWY_INLINE void LoadPacked(const unsigned char*, float*) {}
HWY_INLINE void StorePacked(const float*, unsigned char*) {}

#endif

// Items first .. first + n into consecutive tiles of one group of lanes each. Lanes beyond n repeat
// an item, so that they cost no slow arithmetic on leftover bits.
inline HWY_NOINLINE void LoadTiles(const simd::InView& view, RowShape shape, size_t first, size_t n,
                            size_t planes, float* HWY_RESTRICT tile) {
  const size_t lanes = hn::Lanes(LaneTag());
  size_t i = 0;
  for (; shape != RowShape::kOther && i + lanes <= n; i += lanes, tile += planes * kMaxLanes) {
    if (shape == RowShape::kRows) {
      LoadRows(view.Item(first + i), view.item_stride, planes, tile);
    } else {
      LoadPacked(view.Item(first + i), tile);
    }
  }
  for (; i < n; i += lanes, tile += planes * kMaxLanes) {
    for (size_t lane = 0; lane < lanes; ++lane) {
      const unsigned char* item = view.Item(first + i + (i + lane < n ? lane : 0));
      for (size_t p = 0; p < planes; ++p) {
        std::memcpy(tile + p * kMaxLanes + lane,
                    item + static_cast<ptrdiff_t>(p) * view.plane_stride, sizeof(float));
      }
    }
  }
}

inline HWY_NOINLINE void StoreTiles(const float* HWY_RESTRICT tile, const simd::OutView& view,
                             RowShape shape, size_t first, size_t n, size_t planes) {
  const size_t lanes = hn::Lanes(LaneTag());
  size_t i = 0;
  for (; shape != RowShape::kOther && i + lanes <= n; i += lanes, tile += planes * kMaxLanes) {
    if (shape == RowShape::kRows) {
      StoreRows(tile, planes, view.Item(first + i), view.item_stride);
    } else {
      StorePacked(tile, view.Item(first + i));
    }
  }
  for (; i < n; i += lanes, tile += planes * kMaxLanes) {
    for (size_t lane = 0; lane < lanes && i + lane < n; ++lane) {
      unsigned char* item = view.Item(first + i + lane);
      for (size_t p = 0; p < planes; ++p) {
        std::memcpy(item + static_cast<ptrdiff_t>(p) * view.plane_stride,
                    tile + p * kMaxLanes + lane, sizeof(float));
      }
    }
  }
}

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_TILE_INL_H_
