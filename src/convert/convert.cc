// SPDX-License-Identifier: MIT
#include "convert/convert.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "convert/convert.cc"
#include <hwy/foreach_target.h>

#include "convert/convert-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::convert::HWY_NAMESPACE {

// Sides of large bands are in frames of their own: each has a stack tile of 8 KB.
template <class Row>
HWY_NOINLINE void RunLargeOut(const Bands<Row>& bands, size_t planes, size_t count, InSide& in,
                              const simd::OutView& out) {
  ForEachBatch(count, bands, in, Out<Plan::kMaxRows>(out, planes));
}
template <class Row>
HWY_NOINLINE void RunLarge(const Bands<Row>& bands, size_t planes, size_t count,
                           const simd::InView& in, const simd::OutView& out) {
  In<Plan::kMaxRows> side(in, planes);
  RunLargeOut(bands, planes, count, side, out);
}
template <class Row>
HWY_NOINLINE void RunSmall(const Bands<Row>& bands, size_t planes, size_t count,
                           const simd::InView& in, const simd::OutView& out) {
  ForEachBatch(count, bands, In<kChunkPlanes>(in, planes), Out<kChunkPlanes>(out, planes));
}

template <class Row>
void RunChunk(const Plan& plan, size_t channels, size_t stride, size_t count,
              const simd::InView& in, const simd::OutView& out) {
  const size_t rows = static_cast<size_t>(plan.rows());
  // Channels whose planes lie side by side go together, as far as they fit.
  const size_t most = rows == stride ? std::max<size_t>(kChunkPlanes / rows, 1) : 1;
  for (size_t c = 0; c < channels; c += most) {
    const size_t together = std::min(most, channels - c);
    const size_t planes = together * rows;
    const Bands<Row> bands = {&plan, together, rows};
    (planes <= kChunkPlanes ? RunSmall<Row> : RunLarge<Row>)(bands, planes, count,
                                                             in.FromPlane(c * stride),
                                                             out.FromPlane(c * stride));
  }
}

void ConvertBatch(const Conversion& conversion, int order, size_t channels, size_t count,
                  const simd::InView& in, const simd::OutView& out) {
  const bool in_place = in.data == out.data;
  const size_t stride = static_cast<size_t>(NumCoefficients(order));
  Plan plan;
  for (int l = 0; l < order; l = plan.end_band) {
    conversion.Fill(l, ChunkEnd(l, order), plan);
    plan.staged = in_place && plan.moves;
    const size_t first = static_cast<size_t>(l * l);
    (plan.exact ? RunChunk<MoveRow> : RunChunk<SumRow>)(plan, channels, stride, count,
                                                        in.FromPlane(first), out.FromPlane(first));
  }
}

const Table* GetTable() {
  static constexpr Table kTable = {&ConvertBatch};
  return &kTable;
}

}  // namespace gaunt::convert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(convert);
