// SPDX-License-Identifier: MIT
#include "basis/basis.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/basis.cc"
#include <hwy/foreach_target.h>

#include "basis/basis-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::basis::HWY_NAMESPACE {

template <int n>
void EvalBatch(size_t count, const simd::InView& directions, const simd::OutView& out) {
  ForEachBatch(count, Eval<n>(), In<3>(directions), Out<NumCoefficients(n)>(out));
}

// Planes of a gradient that are made at a time.
constexpr int kGradientPlanes = 32;

// Takes a band that goes to the output from the state.
struct Nowhere {
  GAUNT_LANES void operator()(size_t, hn::Vec<LaneTag>) const {}
  GAUNT_LANES Nowhere Lane(size_t) const { return {}; }
};

// The planes of a band where they lie, or tiles of them, from a lane on.
struct BandPlanes {
  unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES PlanesOut Lane(size_t i) const { return {data + i * sizeof(float), stride}; }
};

// One band of up to 16 directions.
template <class Out>
HWY_NOINLINE void RunBand(int l, size_t n, const float* direction, float* state, const Out& out) {
  const Lanes k;
  const EvalBand kernel{l};
  for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
    unsigned char* const group = reinterpret_cast<unsigned char*>(state + i);
    kernel(k, PlanesIn{reinterpret_cast<const unsigned char*>(direction + i), kTileStride},
           PlanesIn{group, kTileStride}, PlanesOut{group, kTileStride}, out.Lane(i));
  }
}

// Any order, band by band, 16 directions at a time: so every layout is written in the order of its
// planes. Bands that the kernel cannot write where they lie go there from its state.
void EvalAnyBatch(int order, size_t count, const simd::InView& directions,
                  const simd::OutView& out) {
  HWY_ALIGN float direction[3 * kTileItems];
  HWY_ALIGN float state[kStatePlanes * kTileItems];
  const RowShape in_shape = ShapeOf(directions, 3);
  const bool contiguous = out.item_stride == sizeof(float) && out.tile_items % kTileItems == 0;
  const size_t planes = static_cast<size_t>(order * order);
  const bool streams = contiguous && WorthStreaming(count, planes) && CanStream(out, 0, planes);
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    const bool in_place = contiguous && !streams && n % hn::Lanes(LaneTag()) == 0;
    LoadTiles(directions, in_shape, first, n, 3, direction);
    for (int l = 0; l < order; ++l) {
      const simd::OutView band = out.FromPlane(static_cast<size_t>(l * l));
      if (in_place) {
        RunBand(l, n, direction, state, BandPlanes{band.Item(first), band.plane_stride});
        continue;
      }
      RunBand(l, n, direction, state, Nowhere());
      const float* const tile = state + StateIndex(l, -l) * kTileItems;
      const size_t band_planes = static_cast<size_t>(2 * l + 1);
      if (streams && n == kTileItems) {
        StreamTiles(tile, band, RowShape::kOther, first, n, band_planes);
      } else {
        StoreTiles(tile, band, ShapeOf(band, band_planes), first, n, band_planes);
      }
    }
  }
  if (streams) hwy::FlushStream();
}

// A tile's share of a gradient: planes first .. last of band l, to the three outputs.
HWY_NOINLINE void WriteGradient(const GradientBand& kernel, size_t first_item, size_t n,
                                const float* direction, const float* state,
                                const simd::OutView out[3]) {
  HWY_ALIGN float tiles[3][kGradientPlanes * kTileItems];
  const Lanes k;
  for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
    const auto tile = [&](int axis) {
      return PlanesOut{reinterpret_cast<unsigned char*>(tiles[axis] + i), kTileStride};
    };
    kernel(k, PlanesIn{reinterpret_cast<const unsigned char*>(direction + i), kTileStride},
           PlanesIn{reinterpret_cast<const unsigned char*>(state + i), kTileStride}, tile(0),
           tile(1), tile(2));
  }
  const size_t planes = static_cast<size_t>(kernel.last - kernel.first);
  for (int axis = 0; axis < 3; ++axis) {
    const simd::OutView view =
        out[axis].FromPlane(static_cast<size_t>(CoefficientIndex(kernel.l, kernel.first)));
    StoreTiles(tiles[axis], view, ShapeOf(view, planes), first_item, n, planes);
  }
}

void GradientBatch(int order, size_t count, const simd::InView& directions, const simd::OutView& dx,
                   const simd::OutView& dy, const simd::OutView& dz) {
  HWY_ALIGN float direction[3 * kTileItems];
  HWY_ALIGN float state[kStatePlanes * kTileItems];
  const RowShape in_shape = ShapeOf(directions, 3);
  const simd::OutView out[3] = {dx, dy, dz};
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    LoadTiles(directions, in_shape, first, n, 3, direction);
    for (int l = 0; l < order; ++l) {
      RunBand(l, n, direction, state, Nowhere());
      for (int m = -l; m <= l; m += kGradientPlanes) {
        WriteGradient({l, m, std::min(m + kGradientPlanes, l + 1)}, first, n, direction, state,
                      out);
      }
    }
  }
}

void NormalizeBatch(size_t count, const simd::InView& in, const simd::OutView& out) {
  ForEachBatch(count, Normalize(), In<3>(in), Out<3>(out));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &EvalBatch<n>...}, &EvalAnyBatch, &GradientBatch, &NormalizeBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolled>());
  return &kTable;
}

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(basis);
