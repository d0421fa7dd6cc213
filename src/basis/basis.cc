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

// Orders up to which packed rows have a loop of their own.
constexpr int kMaxPacked = 6;

template <int n>
void EvalBatch(size_t count, const simd::InView& directions, const simd::OutView& out) {
  constexpr size_t kPlanes = NumCoefficients(n);
  if constexpr (n > 1 && n <= kMaxPacked) {
    if (ForEachPacked<3, kPlanes>(count, Eval<n>(), directions, out)) return;
  }
  ForEachBatch(count, Eval<n>(), In<3>(directions), Out<kPlanes>(out));
}

// Up to 16 directions band by band, so that any layout is written in the order of its planes.
HWY_NOINLINE void EvalTileBands(int order, const simd::InView& directions, size_t first, size_t n,
                                bool streams, const simd::OutView& out) {
  BandTile tile;
  tile.Load(directions, first, n);
  for (int l = 0; l < order; ++l) {
    HWY_ALIGN float band[kMaxBandPlanes * kTileItems];
    tile.Eval(l, band);
    const simd::OutView view = out.FromPlane(static_cast<size_t>(l * l));
    const size_t planes = static_cast<size_t>(2 * l + 1);
    if (streams && n == kTileItems) {
      StreamTiles(band, view, ShapeOf(view, planes), first, n, planes);
    } else {
      StoreTiles(band, view, ShapeOf(view, planes), first, n, planes);
    }
  }
}

void EvalAnyBatch(int order, size_t count, const simd::InView& directions,
                  const simd::OutView& out) {
  const size_t planes = static_cast<size_t>(order * order);
  const bool contiguous = IsContiguous(out, kTileItems);
  const bool streams = contiguous && WorthStreaming(count, planes) && CanStream(out, 0, planes);
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    if (contiguous && !streams && n == kTileItems) {
      EvalTileColumns(order, directions, first, [&](size_t i) {
        return PlanesOut{out.Item(first) + i * sizeof(float), out.plane_stride};
      });
    } else {
      EvalTileBands(order, directions, first, n, streams, out);
    }
  }
  if (streams) hwy::FlushStream();
}

// Planes of a gradient that are made at a time.
constexpr int kGradientPlanes = 32;

// A tile's share of a gradient: planes first .. last of a band, to the three outputs.
HWY_NOINLINE void WriteGradient(const GradientBand& kernel, const BandTile& tile, const float* band,
                                size_t first, size_t n, const simd::OutView out[3]) {
  HWY_ALIGN float tiles[3][kGradientPlanes * kTileItems];
  for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
    kernel(Lanes(), tile.Direction(i), TileIn(band + i), TileOut(tiles[0] + i),
           TileOut(tiles[1] + i), TileOut(tiles[2] + i));
  }
  const size_t first_plane = static_cast<size_t>(CoefficientIndex(kernel.l, kernel.first));
  const size_t planes = static_cast<size_t>(kernel.last - kernel.first);
  for (int axis = 0; axis < 3; ++axis) {
    const simd::OutView view = out[axis].FromPlane(first_plane);
    StoreTiles(tiles[axis], view, ShapeOf(view, planes), first, n, planes);
  }
}

template <int n>
void GradientBatch(size_t count, const simd::InView& directions, const simd::OutView& dx,
                   const simd::OutView& dy, const simd::OutView& dz) {
  using Component = Out<NumCoefficients(n)>;
  ForEachBatch(count, EvalGradient<n>(), In<3>(directions), Component(dx), Component(dy),
               Component(dz));
}

void GradientAnyBatch(int order, size_t count, const simd::InView& directions,
                      const simd::OutView& dx, const simd::OutView& dy, const simd::OutView& dz) {
  const simd::OutView out[3] = {dx, dy, dz};
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    BandTile tile;
    tile.Load(directions, first, n);
    for (int l = 0; l < order; ++l) {
      HWY_ALIGN float band[kMaxBandPlanes * kTileItems];
      tile.Eval(l, band);
      for (int m = -l; m <= l; m += kGradientPlanes) {
        WriteGradient({l, m, std::min(m + kGradientPlanes, l + 1)}, tile, band, first, n, out);
      }
    }
  }
}

void NormalizeBatch(size_t count, const simd::InView& in, const simd::OutView& out) {
  ForEachBatch(count, Normalize(), In<3>(in), Out<3>(out));
}

template <int... n, int... m>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>,
                          std::integer_sequence<int, 0, m...>) {
  return {{nullptr, &EvalBatch<n>...},
          &EvalAnyBatch,
          {nullptr, &GradientBatch<m>...},
          &GradientAnyBatch,
          &NormalizeBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolled>(), Orders<kMaxUnrolledGradient>());
  return &kTable;
}

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(basis);
