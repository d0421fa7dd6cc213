// SPDX-License-Identifier: MIT
// Transpositions in registers between rows (the floats of an item, contiguous) and planes (one float
// of each item of a group of lanes): what moves interleaved batches into lanes and back.
#if defined(GAUNT_SIMD_TRANSPOSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_TRANSPOSE_INL_H_
#undef GAUNT_SIMD_TRANSPOSE_INL_H_
#else
#define GAUNT_SIMD_TRANSPOSE_INL_H_
#endif

#include "simd/lanes-inl.h"

// Whether this target's vectors have a size that is known when compiling, and blocks of 128 bits.
#undef GAUNT_TRANSPOSES
#if !HWY_HAVE_SCALABLE && HWY_TARGET != HWY_SCALAR
#define GAUNT_TRANSPOSES 1
#else
#define GAUNT_TRANSPOSES 0
#endif
// The same, of eight lanes at least.
#undef GAUNT_WIDE_TRANSPOSES
#if GAUNT_TRANSPOSES && HWY_MAX_BYTES >= 32
#define GAUNT_WIDE_TRANSPOSES 1
#else
#define GAUNT_WIDE_TRANSPOSES 0
#endif

#if GAUNT_TRANSPOSES

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

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

// Transposes the 4x4 matrix in each 128-bit block of a, b, c, e.
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

template <int kFloats, class D>
GAUNT_LANES void StoreBlock(D d, const float* HWY_RESTRICT tile, size_t tile_stride,
                            unsigned char* row, ptrdiff_t item_stride) {
  auto a = hn::Load(d, tile);
  auto b = hn::Load(d, tile + tile_stride);
  auto c = hn::Load(d, tile + 2 * tile_stride);
  auto e = kFloats == 4 ? hn::Load(d, tile + 3 * tile_stride) : c;
  Transpose4(d, a, b, c, e);
  StoreBlocks<kFloats>(d, a, row, item_stride);
  StoreBlocks<kFloats>(d, b, row + item_stride, item_stride);
  StoreBlocks<kFloats>(d, c, row + 2 * item_stride, item_stride);
  StoreBlocks<kFloats>(d, e, row + 3 * item_stride, item_stride);
}

#if GAUNT_WIDE_TRANSPOSES

using EightTag = hn::CappedTag<float, 8>;
using EightV = hn::Vec<EightTag>;

// Eight planes of eight items: half the stores of four by four.
GAUNT_LANES void LoadEight(const unsigned char* row, ptrdiff_t item_stride,
                           float* HWY_RESTRICT tile, size_t tile_stride) {
  const EightTag d;
  const auto load = [=](ptrdiff_t item) HWY_ATTR {
    return hn::LoadU(d, reinterpret_cast<const float*>(row + item * item_stride));
  };
  const EightV r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3);
  const EightV r4 = load(4), r5 = load(5), r6 = load(6), r7 = load(7);
  EightV a = hn::ConcatLowerLower(d, r4, r0), b = hn::ConcatLowerLower(d, r5, r1);
  EightV c = hn::ConcatLowerLower(d, r6, r2), e = hn::ConcatLowerLower(d, r7, r3);
  Transpose4(d, a, b, c, e);
  hn::Store(a, d, tile);
  hn::Store(b, d, tile + tile_stride);
  hn::Store(c, d, tile + 2 * tile_stride);
  hn::Store(e, d, tile + 3 * tile_stride);
  a = hn::ConcatUpperUpper(d, r4, r0), b = hn::ConcatUpperUpper(d, r5, r1);
  c = hn::ConcatUpperUpper(d, r6, r2), e = hn::ConcatUpperUpper(d, r7, r3);
  Transpose4(d, a, b, c, e);
  hn::Store(a, d, tile + 4 * tile_stride);
  hn::Store(b, d, tile + 5 * tile_stride);
  hn::Store(c, d, tile + 6 * tile_stride);
  hn::Store(e, d, tile + 7 * tile_stride);
}

GAUNT_LANES void StoreEight(const float* HWY_RESTRICT tile, size_t tile_stride, unsigned char* row,
                            ptrdiff_t item_stride) {
  const EightTag d;
  EightV a0 = hn::Load(d, tile), a1 = hn::Load(d, tile + tile_stride);
  EightV a2 = hn::Load(d, tile + 2 * tile_stride), a3 = hn::Load(d, tile + 3 * tile_stride);
  EightV b0 = hn::Load(d, tile + 4 * tile_stride), b1 = hn::Load(d, tile + 5 * tile_stride);
  EightV b2 = hn::Load(d, tile + 6 * tile_stride), b3 = hn::Load(d, tile + 7 * tile_stride);
  Transpose4(d, a0, a1, a2, a3);
  Transpose4(d, b0, b1, b2, b3);
  const auto store = [=](EightV low, EightV high, ptrdiff_t item) HWY_ATTR {
    hn::StoreU(hn::ConcatLowerLower(d, high, low), d,
               reinterpret_cast<float*>(row + item * item_stride));
    hn::StoreU(hn::ConcatUpperUpper(d, high, low), d,
               reinterpret_cast<float*>(row + (item + 4) * item_stride));
  };
  store(a0, b0, 0);
  store(a1, b1, 1);
  store(a2, b2, 2);
  store(a3, b3, 3);
}

// Rows of an odd number of floats, back to back: kLanes items are kRow whole vectors. As kRow has no
// factor in common with kLanes, the floats of a plane lie in distinct lanes of those vectors, and in
// lane t the planes follow each other round the vectors, by a phase that is a multiple of t. So each
// plane is permuted once, and each lane turned round by its phase, bit by bit of t (after Catanzaro,
// Keller and Garland 2014). Full vectors are loaded and stored, and nothing else.
template <int kRow>
class OddRows {
 public:
  OddRows() = default;

  GAUNT_LANES void Load(const float* HWY_RESTRICT rows, float* HWY_RESTRICT tile,
                        size_t tile_stride) const {
    const LaneTag d;
    V v[kRow];
    for (int j = 0; j < kRow; ++j) v[j] = hn::LoadU(d, rows + j * kLanes);
    Turn<-1>(v);
    for (int c = 0; c < kRow; ++c) {
      const int k = static_cast<int>(c * kInverse % kRow);
      const auto gather = hn::SetTableIndices(d, kTables.gather[c]);
      hn::Store(hn::TableLookupLanes(v[k], gather), d, tile + static_cast<size_t>(c) * tile_stride);
    }
  }

  GAUNT_LANES void Store(const float* HWY_RESTRICT tile, size_t tile_stride,
                         float* HWY_RESTRICT rows) const {
    const LaneTag d;
    V v[kRow];
    for (int k = 0; k < kRow; ++k) {
      const size_t c = static_cast<size_t>(k * kLanes % kRow);
      const auto scatter = hn::SetTableIndices(d, kTables.scatter[c]);
      v[k] = hn::TableLookupLanes(hn::Load(d, tile + c * tile_stride), scatter);
    }
    Turn<1>(v);
    for (int j = 0; j < kRow; ++j) hn::StoreU(v[j], d, rows + j * kLanes);
  }

 private:
  using V = hn::Vec<LaneTag>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(LaneTag()));
  static_assert(kRow % 2 == 1, "no factor in common with the lanes");

  static constexpr int InverseOfLanes() {
    for (int k = 1; k < kRow; ++k) {
      if (k * kLanes % kRow == 1) return k;
    }
    return 0;
  }
  static constexpr int kInverse = InverseOfLanes();

  struct Tables {
    HWY_ALIGN int32_t gather[kRow][kLanes];   // lane that holds item i of plane c
    HWY_ALIGN int32_t scatter[kRow][kLanes];  // the inverse
  };
  static constexpr Tables MakeTables() {
    Tables tables = {};
    for (int c = 0; c < kRow; ++c) {
      for (int i = 0; i < kLanes; ++i) {
        const int lane = (kRow * i + c) % kLanes;
        tables.gather[c][i] = lane;
        tables.scatter[c][lane] = i;
      }
    }
    return tables;
  }
  static constexpr Tables kTables = MakeTables();

  // Lane t of vector j takes that of vector j + kSign * phase(t).
  template <int kSign, int kBit = 0>
  static GAUNT_LANES void Turn(V (&v)[kRow]) {
    if constexpr ((1 << kBit) < kLanes) {
      constexpr int kPhase = (1 << kBit) * kInverse % kRow;
      V turned[kRow];
      for (int j = 0; j < kRow; ++j) {
        turned[j] = LanesOfBit<kBit>(v[(j + kSign * kPhase + kRow) % kRow], v[j]);
      }
      for (int j = 0; j < kRow; ++j) v[j] = turned[j];
      Turn<kSign, kBit + 1>(v);
    }
  }

  // `set` in the lanes whose index has the bit, else `clear`.
  template <int kBit>
  static GAUNT_LANES V LanesOfBit(V set, V clear) {
    const LaneTag d;
    if constexpr (kBit == 0) {
      return hn::OddEven(set, clear);
    } else if constexpr (kBit == 1) {
      const hn::Repartition<uint64_t, LaneTag> pairs;
      return hn::BitCast(d, hn::OddEven(hn::BitCast(pairs, set), hn::BitCast(pairs, clear)));
    } else if constexpr ((2 << kBit) == kLanes) {
      return hn::ConcatUpperLower(d, set, clear);
    } else {
      return hn::OddEvenBlocks(set, clear);
    }
  }
};

#endif  // GAUNT_WIDE_TRANSPOSES

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_TRANSPOSES

#endif  // GAUNT_SIMD_TRANSPOSE_INL_H_
