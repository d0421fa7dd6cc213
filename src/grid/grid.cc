// SPDX-License-Identifier: MIT
#include "grid/grid.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grid/grid.cc"
#include <hwy/foreach_target.h>

#include "grid/grid-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::grid::HWY_NAMESPACE {

// Items whose corners are kept until their taps are written.
constexpr size_t kChunk = 128;
constexpr size_t kCornerPlanes = 4;

// The taps of one item fill vectors: there is nothing to transpose.
void WriteRows(size_t count, const float* corners, const uint32_t* steps, uint32_t* indices,
               float* weights) {
  const hn::CappedTag<float, kTaps> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  HWY_ALIGN float sides[3][kTaps];
  HWY_ALIGN uint32_t step_to[kTaps];
  for (uint32_t t = 0; t < kTaps; ++t) {
    for (uint32_t a = 0; a < 3; ++a) sides[a][t] = SideOf(t, a);
    step_to[t] = StepTo(steps, t);
  }
  const auto* const first = reinterpret_cast<const uint32_t*>(corners);
  for (size_t i = 0; i < count; ++i, indices += kTaps, weights += kTaps) {
    if (first[i] == UINT32_MAX) {
      std::fill_n(indices, kTaps, UINT32_MAX);
      std::fill_n(weights, kTaps, 0.0f);
      continue;
    }
    const auto x = hn::Set(d, corners[kChunk + i]);
    const auto y = hn::Set(d, corners[2 * kChunk + i]);
    const auto z = hn::Set(d, corners[3 * kChunk + i]);
    for (size_t t = 0; t < kTaps; t += hn::Lanes(d)) {
      const auto index = hn::Add(hn::Set(du, first[i]), hn::Load(du, step_to + t));
      hn::StoreU(index, du, indices + t);
      const auto weight = WeightOf(x, y, z, hn::Load(d, sides[0] + t), hn::Load(d, sides[1] + t),
                                   hn::Load(d, sides[2] + t));
      hn::StoreU(weight, d, weights + t);
    }
  }
}

template <class Where>
void TapBatch(const Where& where, size_t count, const simd::InView& positions, ValidBits valid,
              uint32_t* indices, float* weights) {
  if (valid != nullptr) {
    // Indices are moved as the floats of the same bits.
    ForEachBatch<IndexLanes>(
        count, ValidTaps<Where>{where, valid}, In<3>(positions),
        Out<kTaps>(simd::InterleavedOut(reinterpret_cast<float*>(indices), kTaps)),
        Out<kTaps>(simd::InterleavedOut(weights, kTaps)));
    return;
  }
  HWY_ALIGN float corners[kCornerPlanes * kChunk];
  uint32_t steps[3];
  where.Steps(steps);
  for (size_t done = 0; done < count; done += kChunk) {
    const size_t n = std::min(kChunk, count - done);
    ForEachBatch<IndexLanes>(n, FindCorner<Where>{where}, In<3>(positions, 3, done),
                             Out<kCornerPlanes>({reinterpret_cast<unsigned char*>(corners),
                                                 sizeof(float), kChunk * sizeof(float), 0, 0}));
    WriteRows(n, corners, steps, indices + done * kTaps, weights + done * kTaps);
  }
}

void GridBatch(const Grid& grid, size_t count, const simd::InView& positions, ValidBits valid,
               uint32_t* indices, float* weights) {
  TapBatch(InGrid{grid}, count, positions, valid, indices, weights);
}

void BricksBatch(const Bricks& bricks, size_t count, const simd::InView& positions, ValidBits valid,
                 uint32_t* indices, float* weights) {
  TapBatch(InBricks{bricks}, count, positions, valid, indices, weights);
}

const Table* GetTable() {
  static constexpr Table kTable = {&GridBatch, &BricksBatch};
  return &kTable;
}

}  // namespace gaunt::grid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(grid);
