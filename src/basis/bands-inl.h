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

// For a band that is read from the tile.
struct Nowhere {
  GAUNT_LANES void operator()(size_t, hn::Vec<LaneTag>) const {}
  GAUNT_LANES Nowhere Lane(size_t) const { return {}; }
};

// For a band whose planes are written where they belong, too.
struct BandPlanes {
  unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES PlanesOut Lane(size_t i) const { return {data + i * sizeof(float), stride}; }
};

class BandTile {
 public:
  // Items first .. first + n, at most kTileItems.
  void Load(const simd::InView& directions, size_t first, size_t n) {
    items_ = n;
    LoadTiles(directions, ShapeOf(directions, 3), first, n, 3, direction_);
  }

  // Goes on to band l, which follows the one that was evaluated last, from 0 up.
  template <class Out = Nowhere>
  HWY_NOINLINE void Eval(int l, const Out& out = Out()) {
    const Lanes k;
    const EvalBand kernel{l};
    for (size_t i = 0; i < items_; i += hn::Lanes(LaneTag())) {
      unsigned char* const group = reinterpret_cast<unsigned char*>(state_ + i);
      kernel(k, Direction(i), PlanesIn{group, kTileStride}, PlanesOut{group, kTileStride},
             out.Lane(i));
    }
  }

  // Of the items from i up: their directions, the state that EvalBand leaves.
  GAUNT_LANES PlanesIn Direction(size_t i) const {
    return {reinterpret_cast<const unsigned char*>(direction_ + i), kTileStride};
  }
  GAUNT_LANES PlanesIn State(size_t i) const {
    return {reinterpret_cast<const unsigned char*>(state_ + i), kTileStride};
  }
  // The 2l + 1 planes of band l.
  const float* Band(int l) const { return state_ + StateIndex(l, -l) * kTileItems; }

 private:
  size_t items_ = 0;
  HWY_ALIGN float direction_[3 * kTileItems];
  HWY_ALIGN float state_[kStatePlanes * kTileItems];
};

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_BASIS_BANDS_INL_H_
