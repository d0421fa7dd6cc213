// SPDX-License-Identifier: MIT
#include "evaluate/evaluate.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "evaluate/evaluate.cc"
#include <hwy/foreach_target.h>

#include "basis/bands-inl.h"
#include "evaluate/evaluate-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::evaluate::HWY_NAMESPACE {

// One function in many directions, of order 3: its polynomial is found once.
template <class Quantity, int kChannels>
void QuadraticBatch(size_t count, const simd::InView& coefficients, const simd::InView& directions,
                    const simd::OutView& out) {
  constexpr size_t kPlanes = kChannels * kQuadraticPlanes;
  EvaluateQuadratics<kChannels> kernel;
  HWY_ALIGN float tile[kPlanes * kTileItems];
  Quadratics<Quantity>{kChannels}(Lanes(), SplatIn{coefficients.data, coefficients.plane_stride},
                                  TileOut(tile));
  for (size_t p = 0; p < kPlanes; ++p) kernel.item[p] = tile[p * kTileItems];
  ForEachBatch(count, kernel, In<3>(directions), Out<kChannels>(out));
}

template <class Quantity, int... c>
void QuadraticBatch(size_t channels, size_t count, const simd::InView& coefficients,
                    const simd::InView& directions, const simd::OutView& out,
                    std::integer_sequence<int, c...>) {
  using Fn = void (*)(size_t, const simd::InView&, const simd::InView&, const simd::OutView&);
  static constexpr Fn kBatches[] = {&QuadraticBatch<Quantity, c + 1>...};
  kBatches[channels - 1](count, coefficients, directions, out);
}

// Many functions in one direction: its basis is found once.
template <int n, class Quantity>
void OneDirectionBatch(size_t channels, size_t count, const simd::InView& coefficients,
                       const simd::InView& directions, const simd::OutView& out) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  float y[kCoefficients];
  ForEachBatch(1, basis::HWY_NAMESPACE::Eval<n, Quantity>(), In<3>(directions),
               Out<kCoefficients>(simd::InterleavedOut(y, kCoefficients)));
  ForEachBatch(count, SumChannels<n, Quantity>{channels},
               In<kMaxChannels * kCoefficients>(coefficients, channels * kCoefficients),
               In<kCoefficients>(simd::BroadcastIn(y)), Out<kMaxChannels>(out, channels));
}

template <int n, class Quantity>
void EvaluateBatch(size_t channels, size_t count, const simd::InView& coefficients,
                   const simd::InView& directions, const simd::OutView& out) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  if (count > 1) {  // one item is a broadcast too, and should have the bits of one among many
    if (n == 3 && coefficients.IsBroadcast()) {
      return QuadraticBatch<Quantity>(channels, count, coefficients, directions, out,
                                      std::make_integer_sequence<int, kMaxChannels>());
    }
    if (directions.IsBroadcast()) {
      return OneDirectionBatch<n, Quantity>(channels, count, coefficients, directions, out);
    }
  }
  ForEachBatch(count, Evaluate<n, Quantity>{channels},
               In<kMaxChannels * kCoefficients>(coefficients, channels * kCoefficients),
               In<3>(directions), Out<kMaxChannels>(out, channels));
}

// Sums over planes of a stack tile of items, a run of planes at a time: for more planes than the
// stack should hold.
class TileSums {
 public:
  static constexpr size_t kMostPlanes = basis::HWY_NAMESPACE::kMaxBandPlanes;

  TileSums(size_t first, size_t n) : first_(first), n_(n) {
    std::fill(sums_, sums_ + kMaxChannels * kTileItems, 0.0f);
  }

  // Adds weight times the sum of a b over planes of a batch, with `b` of a stack tile.
  HWY_NOINLINE void Add(size_t channel, const simd::InView& a, const float* b, size_t planes,
                        double weight) {
    HWY_ALIGN float tile[kMostPlanes * kTileItems];
    const AddDot kernel{planes, weight};
    float* const sums = sums_ + channel * kTileItems;
    const bool direct = IsContiguous(a, kTileItems) && n_ % hn::Lanes(LaneTag()) == 0;
    if (!direct && !a.IsBroadcast()) LoadTiles(a, ShapeOf(a, planes), first_, n_, planes, tile);
    for (size_t i = 0; i < n_; i += hn::Lanes(LaneTag())) {
      const PlanesIn b_in = TileIn(b + i), before = TileIn(sums + i);
      const PlanesOut sum = TileOut(sums + i);
      if (a.IsBroadcast()) {
        kernel(Lanes(), SplatIn{a.data, a.plane_stride}, b_in, before, sum);
      } else if (direct) {
        const unsigned char* item = a.Item(first_) + i * sizeof(float);
        kernel(Lanes(), PlanesIn{item, a.plane_stride}, b_in, before, sum);
      } else {
        kernel(Lanes(), TileIn(tile + i), b_in, before, sum);
      }
    }
  }

  void Store(const simd::OutView& out, size_t channels) const {
    StoreTiles(sums_, out, ShapeOf(out, channels), first_, n_, channels);
  }

 private:
  size_t first_;
  size_t n_;
  HWY_ALIGN float sums_[kMaxChannels * kTileItems];
};

template <class Quantity>
void EvaluateAnyBatch(int order, size_t channels, size_t count, const simd::InView& coefficients,
                      const simd::InView& directions, const simd::OutView& out) {
  basis::HWY_NAMESPACE::BandTile tile;
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    TileSums sums(first, n);
    tile.Load(directions, first, n);
    for (int l = 0; l < order; ++l) {
      HWY_ALIGN float band[basis::HWY_NAMESPACE::kMaxBandPlanes * kTileItems];
      tile.Eval(l, band);
      const double weight = Quantity::Band(l);
      for (size_t c = 0; weight != 0.0 && c < channels; ++c) {
        const size_t plane = c * static_cast<size_t>(order * order) + static_cast<size_t>(l * l);
        sums.Add(c, coefficients.FromPlane(plane), band, static_cast<size_t>(2 * l + 1), weight);
      }
    }
    sums.Store(out, channels);
  }
}

void DotBatch(size_t coefficients, size_t channels, size_t count, const simd::InView& a,
              const simd::InView& b, const simd::OutView& out) {
  constexpr size_t kRun = 64;
  HWY_ALIGN float tile[kRun * kTileItems];
  for (size_t first = 0; first < count; first += kTileItems) {
    const size_t n = std::min(kTileItems, count - first);
    TileSums sums(first, n);
    for (size_t c = 0; c < channels; ++c) {
      for (size_t p = 0; p < coefficients; p += kRun) {
        const size_t run = std::min(kRun, coefficients - p);
        const simd::InView b_run = b.FromPlane(c * coefficients + p);
        LoadTiles(b_run, ShapeOf(b_run, run), first, n, run, tile);
        sums.Add(c, a.FromPlane(c * coefficients + p), tile, run, 1.0);
      }
    }
    sums.Store(out, channels);
  }
}

void ConstantsBatch(size_t count, const simd::InView& radiance, const simd::OutView& out) {
  ForEachBatch(count, Constants(), In<27>(radiance), Out<kConstantPlanes>(out));
}

void MatrixBatch(size_t channels, size_t count, const simd::InView& radiance,
                 const simd::OutView& out) {
  ForEachBatch(count, Matrix{channels}, In<kMaxChannels * 9>(radiance, 9 * channels),
               Out<kMaxChannels * kMatrixPlanes>(out, kMatrixPlanes * channels));
}

// Planes are independent, so any number of them goes a stack tile's worth at a time.
void BlendBatch(size_t planes, size_t count, const simd::InView& a, const simd::InView& b,
                const simd::InView& t, const simd::OutView& out) {
  constexpr size_t kChunk = 32;
  for (size_t p = 0; p < planes; p += kChunk) {
    const size_t chunk = std::min(kChunk, planes - p);
    ForEachBatch(count, Blend{chunk}, In<kChunk>(a.FromPlane(p), chunk),
                 In<kChunk>(b.FromPlane(p), chunk), In<1>(t), Out<kChunk>(out.FromPlane(p), chunk));
  }
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &EvaluateBatch<n, RadianceBands>...},
          {nullptr, &EvaluateBatch<n, IrradianceBands>...},
          &EvaluateAnyBatch<RadianceBands>,
          &EvaluateAnyBatch<IrradianceBands>,
          &ConstantsBatch,
          &MatrixBatch,
          &DotBatch,
          &BlendBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::evaluate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(evaluate);
