// SPDX-License-Identifier: MIT
// The basis of any order, band by band, of a stack tile of directions: what lies beyond the unrolled
// orders, where n^2 planes of an item are more than the stack should hold.
#if defined(GAUNT_BASIS_BANDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_BASIS_BANDS_INL_H_
#undef GAUNT_BASIS_BANDS_INL_H_
#else
#define GAUNT_BASIS_BANDS_INL_H_
#endif

#include "basis/basis-inl.h"
#include "simd/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::basis::HWY_NAMESPACE {

class BandTile {
 public:
  // Items first .. first + n, at most kTileItems.
  void Load(const simd::InView& directions, size_t first, size_t n) {
    items_ = n;
    LoadTiles(directions, ShapeOf(directions, 3), first, n, 3, direction_);
  }

  // Evaluates band l, which follows the one that was evaluated last, from 0 up: 2l + 1 planes.
  HWY_NOINLINE void Eval(int l, float* HWY_RESTRICT band) {
    const Lanes k;
    const EvalBand kernel{l};
    for (size_t i = 0; i < items_; i += hn::Lanes(LaneTag())) {
      kernel(k, Direction(i), TileIn(state_ + i), TileOut(state_ + i), TileOut(band + i));
    }
  }

  // Of the items from i up.
  GAUNT_LANES PlanesIn Direction(size_t i) const { return TileIn(direction_ + i); }

 private:
  size_t items_ = 0;
  HWY_ALIGN float direction_[3 * kTileItems];
  HWY_ALIGN float state_[kStatePlanes * kTileItems];
};

// Planes of a band of the highest order.
inline constexpr size_t kMaxBandPlanes = 2 * kMaxOrder - 1;

// A whole tile column by column, for planes that can be written where they lie: to(i) takes those
// of the items from i up. Both groups of a tile go before the next columns, so that its cache lines
// fill up.
template <class To>
HWY_NOINLINE void EvalTileColumns(int order, const simd::InView& directions, size_t first,
                                  const To& to) {
  HWY_ALIGN float direction[3 * kTileItems];
  HWY_ALIGN float cosine[kTileItems], sine[kTileItems];
  const Lanes k;
  const LaneTag d;
  LoadTiles(directions, ShapeOf(directions, 3), first, kTileItems, 3, direction);
  for (size_t i = 0; i < kTileItems; i += hn::Lanes(d)) {
    EvalZonal{order}(k, TileIn(direction + i), to(i));
    hn::Store(hn::Load(d, direction + i), d, cosine + i);
    hn::Store(hn::Load(d, direction + kTileItems + i), d, sine + i);
  }
  int m = 1;
  for (; m + 1 < order; m += 2) {
    for (size_t i = 0; i < kTileItems; i += hn::Lanes(d)) {
      const PlanesIn xyz = TileIn(direction + i);
      auto c = hn::Load(d, cosine + i), s = hn::Load(d, sine + i);
      EvalColumnPair{order, m}(k, xyz(0), xyz(1), xyz(2), c, s, to(i));
      hn::Store(c, d, cosine + i);
      hn::Store(s, d, sine + i);
    }
  }
  for (size_t i = 0; m < order && i < kTileItems; i += hn::Lanes(d)) {
    EvalColumn{order, m}(k, TileIn(direction + i)(2), hn::Load(d, cosine + i),
                         hn::Load(d, sine + i), to(i));
  }
}

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_BASIS_BANDS_INL_H_
