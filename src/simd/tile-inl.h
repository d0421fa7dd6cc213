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

// The layouts that the fast conversions know: contiguous planes per item, which 4x4 transposes
// turn.
enum class RowShape {
  kOther,   // any strides
  kRows,    // at least four planes
  kTriples  // three
};

template <typename View>
RowShape ShapeOf(const View& view, size_t planes) {
  const bool one_run = view.tile_items == 0 || view.tile_items % hn::Lanes(LaneTag()) == 0;
  if (HWY_HAVE_SCALABLE || HWY_TARGET == HWY_SCALAR || view.plane_stride != 4 || !one_run) {
    return RowShape::kOther;
  }
  return planes >= 4 ? RowShape::kRows : planes == 3 ? RowShape::kTriples : RowShape::kOther;
}

#if !HWY_HAVE_SCALABLE && HWY_TARGET != HWY_SCALAR

// kFloats floats of an item, of which the fourth is anything if there are three: it is not touched.
template <int kFloats, class D>
GAUNT_LANES hn::Vec<D> LoadRow(D d, const float* row) {
  if constexpr (kFloats == 4) {
    return hn::LoadU(d, row);
  } else {
    const hn::CappedTag<float, 2> pair;
    const hn::CappedTag<float, 1> single;
    return hn::Combine(d, hn::ZeroExtendVector(pair, hn::LoadU(single, row + 2)),
                       hn::LoadU(pair, row));
  }
}

template <int kFloats, class D>
GAUNT_LANES void StoreRow(D d, hn::Vec<D> v, float* row) {
  if constexpr (kFloats == 4) {
    hn::StoreU(v, d, row);
  } else {
    const hn::CappedTag<float, 2> pair;
    const hn::CappedTag<float, 1> single;
    hn::StoreU(hn::LowerHalf(pair, v), pair, row);
    hn::StoreU(hn::LowerHalf(single, hn::UpperHalf(pair, v)), single, row + 2);
  }
}

// Vector whose 128-bit block b holds floats of item 4 b.
template <int kFloats, class D>
GAUNT_LANES hn::Vec<D> LoadBlocks(D d, const unsigned char* row, ptrdiff_t item_stride) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    return LoadRow<kFloats>(d, reinterpret_cast<const float*>(row));
  } else {
    const hn::Half<D> half;
    constexpr ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
    return hn::Combine(d, LoadBlocks<kFloats>(half, row + kHalf * item_stride, item_stride),
                       LoadBlocks<kFloats>(half, row, item_stride));
  }
}

template <int kFloats, class D>
GAUNT_LANES void StoreBlocks(D d, hn::Vec<D> v, unsigned char* row, ptrdiff_t item_stride) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    StoreRow<kFloats>(d, v, reinterpret_cast<float*>(row));
  } else {
    const hn::Half<D> half;
    constexpr ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
    StoreBlocks<kFloats>(half, hn::LowerHalf(half, v), row, item_stride);
    StoreBlocks<kFloats>(half, hn::UpperHalf(half, v), row + kHalf * item_stride, item_stride);
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

// Planes from the one that `row` points at, of a group of items; `tile_stride` floats from plane to
// plane. Where items are back to back, all but the last of a block may read a float of the next
// one.
template <int kFloats, int kFloatsInside = kFloats, class D>
GAUNT_LANES void LoadBlock(D d, const unsigned char* row, ptrdiff_t item_stride,
                           float* HWY_RESTRICT tile, size_t tile_stride) {
  auto a = LoadBlocks<kFloatsInside>(d, row, item_stride);
  auto b = LoadBlocks<kFloatsInside>(d, row + item_stride, item_stride);
  auto c = LoadBlocks<kFloatsInside>(d, row + 2 * item_stride, item_stride);
  auto e = LoadBlocks<kFloats>(d, row + 3 * item_stride, item_stride);
  Transpose4(d, a, b, c, e);
  hn::Store(a, d, tile);
  hn::Store(b, d, tile + tile_stride);
  hn::Store(c, d, tile + 2 * tile_stride);
  if constexpr (kFloats == 4) hn::Store(e, d, tile + 3 * tile_stride);
}

template <int kFloats>
GAUNT_LANES void StoreBlock(const float* HWY_RESTRICT tile, unsigned char* row,
                            ptrdiff_t item_stride) {
  const LaneTag d;
  auto a = hn::Load(d, tile);
  auto b = hn::Load(d, tile + kMaxLanes);
  auto c = hn::Load(d, tile + 2 * kMaxLanes);
  auto e = kFloats == 4 ? hn::Load(d, tile + 3 * kMaxLanes) : c;
  Transpose4(d, a, b, c, e);
  StoreBlocks<kFloats>(d, a, row, item_stride);
  StoreBlocks<kFloats>(d, b, row + item_stride, item_stride);
  StoreBlocks<kFloats>(d, c, row + 2 * item_stride, item_stride);
  StoreBlocks<kFloats>(d, e, row + 3 * item_stride, item_stride);
}

#else

template <int kFloats, int kFloatsInside = kFloats, class D>
void LoadBlock(D, const unsigned char*, ptrdiff_t, float*, size_t) {}
template <int kFloats>
void StoreBlock(const float*, unsigned char*, ptrdiff_t) {}

#endif

// Calls block(p) so that blocks of four planes cover all; the last one may overlap the one before.
template <class Block>
GAUNT_LANES void ForEachBlock(size_t planes, const Block& block) {
  size_t p = 0;
  for (; p + 4 <= planes; p += 4) block(p);
  if (p < planes) block(planes - 4);
}

GAUNT_LANES void LoadRows(RowShape shape, const unsigned char* row, ptrdiff_t item_stride,
                          size_t planes, float* HWY_RESTRICT tile) {
  if (shape == RowShape::kTriples) {
    if (item_stride == 3 * sizeof(float)) {
      return LoadBlock<3, 4>(LaneTag(), row, item_stride, tile, kMaxLanes);
    }
    return LoadBlock<3>(LaneTag(), row, item_stride, tile, kMaxLanes);
  }
  ForEachBlock(planes, [=](size_t p) HWY_ATTR {
    LoadBlock<4>(LaneTag(), row + 4 * p, item_stride, tile + p * kMaxLanes, kMaxLanes);
  });
}

GAUNT_LANES void StoreRows(RowShape shape, const float* HWY_RESTRICT tile, unsigned char* row,
                           ptrdiff_t item_stride, size_t planes) {
  if (shape == RowShape::kTriples) return StoreBlock<3>(tile, row, item_stride);
  ForEachBlock(planes, [=](size_t p) HWY_ATTR {
    StoreBlock<4>(tile + p * kMaxLanes, row + 4 * p, item_stride);
  });
}

// Items first .. first + n into consecutive tiles of one group of lanes each. Lanes beyond n repeat
// an item, so that they cost no slow arithmetic on leftover bits.
inline HWY_NOINLINE void LoadTiles(const simd::InView& view, RowShape shape, size_t first, size_t n,
                                   size_t planes, float* HWY_RESTRICT tile) {
  const size_t lanes = hn::Lanes(LaneTag());
  size_t i = 0;
  for (; shape != RowShape::kOther && i + lanes <= n; i += lanes, tile += planes * kMaxLanes) {
    LoadRows(shape, view.Item(first + i), view.item_stride, planes, tile);
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
    StoreRows(shape, tile, view.Item(first + i), view.item_stride, planes);
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
