// SPDX-License-Identifier: MIT
#include "basis/basis.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/basis.cc"
#include <hwy/foreach_target.h>

#include "basis/bands-inl.h"
#include "basis/basis-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::basis::HWY_NAMESPACE {

template <int n>
void EvalBatch(size_t count, const simd::InView& directions, const simd::OutView& out) {
  ForEachBatch(count, Eval<n>(), In<3>(directions), Out<NumCoefficients(n)>(out));
}

// Band by band, so that every layout is written in the order of its planes.
void EvalAnyBatch(int order, size_t count, const simd::InView& directions,
                  const simd::OutView& out) {
  BandTile tile;
  const size_t planes = static_cast<size_t>(order * order);
  const bool contiguous = out.item_stride == sizeof(float) && out.tile_items % kTileItems == 0;
  const bool streams = contiguous && WorthStreaming(count, planes) && CanStream(out, 0, planes);
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    const bool in_place = contiguous && !streams && n % hn::Lanes(LaneTag()) == 0;
    tile.Load(directions, first, n);
    for (int l = 0; l < order; ++l) {
      const simd::OutView band = out.FromPlane(static_cast<size_t>(l * l));
      if (in_place) {
        tile.Eval(l, BandPlanes{band.Item(first), band.plane_stride});
        continue;
      }
      tile.Eval(l);
      const size_t band_planes = static_cast<size_t>(2 * l + 1);
      if (streams && n == kTileItems) {
        StreamTiles(tile.Band(l), band, RowShape::kOther, first, n, band_planes);
      } else {
        StoreTiles(tile.Band(l), band, ShapeOf(band, band_planes), first, n, band_planes);
      }
    }
  }
  if (streams) hwy::FlushStream();
}

// Planes of a gradient that are made at a time.
constexpr int kGradientPlanes = 32;

// A tile's share of a gradient: planes first .. last of a band, to the three outputs.
HWY_NOINLINE void WriteGradient(const GradientBand& kernel, const BandTile& band, size_t first,
                                size_t n, const simd::OutView out[3]) {
  HWY_ALIGN float tiles[3][kGradientPlanes * kTileItems];
  for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
    const auto component = [&](int axis) {
      return PlanesOut{reinterpret_cast<unsigned char*>(tiles[axis] + i), kTileStride};
    };
    kernel(Lanes(), band.Direction(i), band.State(i), component(0), component(1), component(2));
  }
  const size_t first_plane = static_cast<size_t>(CoefficientIndex(kernel.l, kernel.first));
  const size_t planes = static_cast<size_t>(kernel.last - kernel.first);
  for (int axis = 0; axis < 3; ++axis) {
    const simd::OutView view = out[axis].FromPlane(first_plane);
    StoreTiles(tiles[axis], view, ShapeOf(view, planes), first, n, planes);
  }
}

void GradientBatch(int order, size_t count, const simd::InView& directions, const simd::OutView& dx,
                   const simd::OutView& dy, const simd::OutView& dz) {
  BandTile tile;
  const simd::OutView out[3] = {dx, dy, dz};
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    tile.Load(directions, first, n);
    for (int l = 0; l < order; ++l) {
      tile.Eval(l);
      for (int m = -l; m <= l; m += kGradientPlanes) {
        WriteGradient({l, m, std::min(m + kGradientPlanes, l + 1)}, tile, first, n, out);
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
