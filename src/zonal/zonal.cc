// SPDX-License-Identifier: MIT
#include "zonal/zonal.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "zonal/zonal.cc"
#include <hwy/foreach_target.h>

#include "basis/bands-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"
#include "zonal/zonal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::zonal::HWY_NAMESPACE {

inline simd::InView AsInput(const simd::OutView& view) {
  return {view.data, view.item_stride, view.plane_stride, view.tile_stride, view.tile_items};
}

// Runs a kernel that writes coefficients of order n, or adds to them.
template <int n, bool kAdd, class Kernel, class... Ins>
void ForEachOutput(size_t channels, size_t count, const Kernel& kernel, const simd::OutView& out,
                   Ins&&... ins) {
  constexpr size_t kMaxPlanes = kMaxChannels * NumCoefficients(n);
  const size_t planes = channels * NumCoefficients(n);
  if constexpr (kAdd) {
    ForEachBatch(count, kernel, ins..., Out<kMaxPlanes>(out, planes),
                 In<kMaxPlanes>(AsInput(out), planes));
  } else {
    ForEachBatch(count, kernel, ins..., Out<kMaxPlanes>(out, planes));
  }
}

template <int n, bool kAdd>
void RotateToOneBatch(size_t channels, size_t count, const simd::InView& zonal,
                      const simd::InView& directions, const simd::OutView& out) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  RotateToOne<n> kernel;
  kernel.channels = channels;
  ForEachBatch(1, basis::HWY_NAMESPACE::Eval<n, ZonalBands>(), In<3>(directions),
               Out<kCoefficients>(simd::InterleavedOut(kernel.y, kCoefficients)));
  ForEachOutput<n, kAdd>(channels, count, kernel, out, In<kMaxChannels * n>(zonal, channels * n));
}

template <int n, bool kAdd>
void RotateBatch(size_t channels, size_t count, const simd::InView& zonal,
                 const simd::InView& directions, const simd::OutView& out) {
  if (count > 1 && directions.IsBroadcast()) {
    return RotateToOneBatch<n, kAdd>(channels, count, zonal, directions, out);
  }
  ForEachOutput<n, kAdd>(channels, count, Rotate<n>{channels}, out,
                         In<kMaxChannels * n>(zonal, channels * n), In<3>(directions));
}

template <int n>
void ConvolveBatch(size_t channels, size_t count, const simd::InView& kernel,
                   const simd::InView& in, const simd::OutView& out) {
  constexpr size_t kMaxPlanes = kMaxChannels * NumCoefficients(n);
  In<kMaxPlanes> in_side(in, channels * NumCoefficients(n));
  if (count > 1 && kernel.IsBroadcast()) {  // it is weighed once
    float weighed[n];
    ForEachBatch(1, WeighBands{n}, In<n>(kernel), Out<n>(simd::InterleavedOut(weighed, n)));
    ForEachOutput<n, false>(channels, count, ConvolveWeighed<n>{channels}, out,
                            In<n>(simd::BroadcastIn(weighed)), in_side);
  } else {
    ForEachOutput<n, false>(channels, count, Convolve<n>{channels}, out, In<n>(kernel), in_side);
  }
}

// Any order goes by stack tiles of items, band by band.

constexpr size_t FirstPlane(int order, size_t channel, int l) {
  return channel * static_cast<size_t>(order * order) + static_cast<size_t>(l * l);
}
constexpr size_t BandPlanes(int l) { return static_cast<size_t>(2 * l + 1); }

// Weighed factors of each band and channel, of a tile of items.
class FactorTile {
 public:
  FactorTile(const simd::InView& view, int order, size_t channels)
      : view_(view), order_(static_cast<size_t>(order)), channels_(channels) {}

  HWY_NOINLINE void Load(size_t first, size_t n) {
    if (view_.IsBroadcast() && first != 0) return;  // it is there
    const size_t planes = channels_ * order_;
    LoadTiles(view_, ShapeOf(view_, planes), first, n, planes, tile_);
    for (size_t c = 0; c < channels_; ++c) {
      float* const channel = tile_ + c * order_ * kTileItems;
      for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
        WeighBands{order_}(Lanes(), TileIn(channel + i), TileOut(channel + i));
      }
    }
  }

  const float* Plane(int l, size_t channel) const {
    return tile_ + (channel * order_ + static_cast<size_t>(l)) * kTileItems;
  }

 private:
  const simd::InView& view_;
  size_t order_;
  size_t channels_;
  HWY_ALIGN float tile_[kMaxChannels * kMaxOrder * kTileItems];
};

// The output of an order, a tile's bands at a time.
template <bool kAdd>
class BandOutput {
 public:
  BandOutput(const simd::OutView& out, size_t count, size_t planes)
      : out_(out),
        contiguous_(IsContiguous(out, kTileItems)),
        streams_(contiguous_ && WorthStreaming(count, planes) && CanStream(out, 0, planes)) {}
  ~BandOutput() {
    if (streams_) hwy::FlushStream();
  }

  // Whether tiles are written where they lie.
  bool Direct(size_t n) const { return contiguous_ && !streams_ && n == kTileItems; }
  // Of the items from `item` up; tiles that are direct.
  PlanesOut Here(size_t item) const { return {out_.Item(item), out_.plane_stride}; }

  // Items first .. first + n of band l, whose planes begin at `plane`; source(i) gives the planes
  // to be scaled of the items from i up.
  template <class Source>
  GAUNT_LANES void Write(int l, size_t plane, const float* factor, const Source& source,
                         size_t first, size_t n) const {
    if (!Direct(n)) return WriteTile(l, plane, factor, source, first, n);
    for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
      Scale(l, factor + i, source(i), Here(first + i).From(plane));
    }
  }

 private:
  template <class Source>
  HWY_NOINLINE void WriteTile(int l, size_t plane, const float* factor, const Source& source,
                              size_t first, size_t n) const {
    HWY_ALIGN float tile[basis::HWY_NAMESPACE::kMaxBandPlanes * kTileItems];
    const simd::OutView out = out_.FromPlane(plane);
    const size_t planes = BandPlanes(l);
    const RowShape shape = ShapeOf(out, planes);
    if (kAdd) LoadTiles(AsInput(out), shape, first, n, planes, tile);
    for (size_t i = 0; i < n; i += hn::Lanes(LaneTag())) {
      Scale(l, factor + i, source(i), TileOut(tile + i));
    }
    if (streams_ && n == kTileItems) {
      StreamTiles(tile, out, shape, first, n, planes);
    } else {
      StoreTiles(tile, out, shape, first, n, planes);
    }
  }

  template <class In>
  static GAUNT_LANES void Scale(int l, const float* factor, const In& in, const PlanesOut& to) {
    if constexpr (kAdd) {
      ScaleBand{l}(Lanes(), TileIn(factor), in, to, to.Read());
    } else {
      ScaleBand{l}(Lanes(), TileIn(factor), in, to);
    }
  }

  const simd::OutView& out_;
  bool contiguous_;
  bool streams_;
};

// The basis of a tile of directions, band by band.
class TileBands {
 public:
  explicit TileBands(const simd::InView& directions) : directions_(directions) {}
  void Load(size_t first, size_t n) { tile_.Load(directions_, first, n); }
  void Eval(int l) { tile_.Eval(l, band_); }
  PlanesIn operator()(size_t i) const { return TileIn(band_ + i); }

 private:
  const simd::InView& directions_;
  basis::HWY_NAMESPACE::BandTile tile_;
  HWY_ALIGN float band_[basis::HWY_NAMESPACE::kMaxBandPlanes * kTileItems];
};

// The basis of one direction for all items.
class ItemBands {
 public:
  HWY_NOINLINE ItemBands(int order, const simd::InView& directions) {
    TileBands bands(directions);
    bands.Load(0, 1);
    for (int l = 0; l < order; ++l) {
      bands.Eval(l);
      const float* const band = reinterpret_cast<const float*>(bands(0).data);
      for (size_t p = 0; p < BandPlanes(l); ++p) y_[FirstPlane(0, 0, l) + p] = band[p * kTileItems];
    }
  }
  void Load(size_t, size_t) {}
  void Eval(int l) { band_ = y_ + FirstPlane(0, 0, l); }
  SplatIn operator()(size_t) const {
    return {reinterpret_cast<const unsigned char*>(band_), sizeof(float)};
  }

 private:
  const float* band_ = y_;
  float y_[NumCoefficients(kMaxOrder)];
};

// A tile that is written where it lies, by columns, which are faster than bands.
template <bool kAdd>
void RotateColumns(int order, size_t channels, const FactorTile& factors,
                   const simd::InView& directions, const BandOutput<kAdd>& output, size_t first) {
  const size_t n = static_cast<size_t>(order);
  basis::HWY_NAMESPACE::EvalTileColumns(order, directions, first, [&](size_t i) {
    const PlanesOut to = output.Here(first + i);
    const PlanesIn zonal = TileIn(factors.Plane(0, 0) + i);
    if constexpr (kAdd) {
      const AddToPlanes<PlanesOut, PlanesIn> add = {to, to.Read()};
      return EmitProducts<PlanesIn, decltype(add)>{zonal, add, n, channels};
    } else {
      const SetPlanes<PlanesOut> set = {to};
      return EmitProducts<PlanesIn, decltype(set)>{zonal, set, n, channels};
    }
  });
}

template <bool kAdd, class Bands>
void RotateBands(int order, size_t channels, const FactorTile& factors, Bands& bands,
                 const BandOutput<kAdd>& output, size_t first, size_t n) {
  bands.Load(first, n);
  for (int l = 0; l < order; ++l) {
    bands.Eval(l);
    for (size_t c = 0; c < channels; ++c) {
      output.Write(l, FirstPlane(order, c, l), factors.Plane(l, c), bands, first, n);
    }
  }
}

// Out of line, as is the next: the stack holds the bands of one of them at most.
template <bool kAdd>
HWY_NOINLINE void RotateAnyToOne(int order, size_t channels, size_t count, FactorTile& factors,
                                 const simd::InView& directions, const BandOutput<kAdd>& output) {
  ItemBands bands(order, directions);
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    factors.Load(first, n);
    RotateBands<kAdd>(order, channels, factors, bands, output, first, n);
  }
}

template <bool kAdd>
HWY_NOINLINE void RotateAnyToEach(int order, size_t channels, size_t count, FactorTile& factors,
                                  const simd::InView& directions, const BandOutput<kAdd>& output) {
  TileBands bands(directions);
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    factors.Load(first, n);
    if (output.Direct(n)) {
      RotateColumns<kAdd>(order, channels, factors, directions, output, first);
    } else {
      RotateBands<kAdd>(order, channels, factors, bands, output, first, n);
    }
  }
}

template <bool kAdd>
void RotateAnyBatch(int order, size_t channels, size_t count, const simd::InView& zonal,
                    const simd::InView& directions, const simd::OutView& out) {
  FactorTile factors(zonal, order, channels);
  const BandOutput<kAdd> output(out, count, FirstPlane(order, channels, 0));
  const bool to_one = count > 1 && directions.IsBroadcast();
  (to_one ? &RotateAnyToOne<kAdd> : &RotateAnyToEach<kAdd>)(order, channels, count, factors,
                                                            directions, output);
}

// A band's planes of a tile of items, where they lie if they are contiguous.
class InputBand {
 public:
  explicit InputBand(const simd::InView& view)
      : view_(view), contiguous_(IsContiguous(view, kTileItems)) {}

  void Load(int l, size_t plane, size_t first, size_t n) {
    const simd::InView band = view_.FromPlane(plane);
    if (contiguous_ && n == kTileItems) {
      planes_ = {band.Item(first), band.plane_stride};
    } else {
      LoadTiles(band, ShapeOf(band, BandPlanes(l)), first, n, BandPlanes(l), tile_);
      planes_ = TileIn(tile_);
    }
  }
  PlanesIn operator()(size_t i) const { return {planes_.data + i * sizeof(float), planes_.stride}; }

 private:
  const simd::InView& view_;
  bool contiguous_;
  PlanesIn planes_ = {};
  HWY_ALIGN float tile_[basis::HWY_NAMESPACE::kMaxBandPlanes * kTileItems];
};

void ConvolveAnyBatch(int order, size_t channels, size_t count, const simd::InView& kernel,
                      const simd::InView& in, const simd::OutView& out) {
  FactorTile factors(kernel, order, 1);
  InputBand band(in);
  const BandOutput<false> output(out, count, FirstPlane(order, channels, 0));
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    factors.Load(first, n);
    for (int l = 0; l < order; ++l) {
      for (size_t c = 0; c < channels; ++c) {
        band.Load(l, FirstPlane(order, c, l), first, n);
        output.Write(l, FirstPlane(order, c, l), factors.Plane(l, 0), band, first, n);
      }
    }
  }
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &RotateBatch<n, false>...},
          {nullptr, &RotateBatch<n, true>...},
          {nullptr, &ConvolveBatch<n>...},
          &RotateAnyBatch<false>,
          &RotateAnyBatch<true>,
          &ConvolveAnyBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::zonal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(zonal);
