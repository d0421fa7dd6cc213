// SPDX-License-Identifier: MIT
#include "probe/probe.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "probe/probe.cc"
#include <hwy/foreach_target.h>

#include "probe/gather-inl.h"
#include "probe/probe-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

constexpr size_t kEncodeChunk = 32;

template <class F>
void EncodeBatch(bool refines, size_t count, const simd::InView& in, uint8_t* packed, size_t stride,
                 const simd::OutView* report) {
  constexpr size_t kWords = DenseWords<F::kBytes>::kCount;
  uint32_t words[kEncodeChunk * kWords];  // little-endian on every host
  float clamped[kEncodeChunk];
  float* const word_floats = reinterpret_cast<float*>(words);
  for (size_t done = 0; done < count; done += kEncodeChunk) {
    const size_t n = std::min(kEncodeChunk, count - done);
    In<kPlanes<F>> in_side(in, kPlanes<F>, done);
    In<kWords> words_in(simd::InterleavedIn(word_floats, kWords));
    Out<kWords> words_out(simd::InterleavedOut(word_floats, kWords));
    ForEachBatch<RecordLanes>(n, Encode<F>(), in_side, words_out,
                              Out<1>(simd::InterleavedOut(clamped, 1)));
    if constexpr (kCanRefine<F>) {
      if (refines) ForEachBatch<RecordLanes>(n, Refine<F>(), in_side, words_in, words_out);
    }
    if (report != nullptr) {
      ForEachBatch<RecordLanes>(n, Report<F>(), in_side, words_in,
                                In<1>(simd::InterleavedIn(clamped, 1)),
                                Out<kReportPlanes>(*report, kReportPlanes, done));
    }
    for (size_t i = 0; i < n; ++i) {
      std::memcpy(packed + (done + i) * stride, words + i * kWords, F::kBytes);
    }
  }
}

template <class F, class Source>
void BlendBatch(size_t count, size_t taps, size_t order, const Source& source,
                const simd::OutView& out) {
  const Blend<FormatKernels<F>, F> kernel = {taps, order * order};
  ForEachBatch<RecordLanes>(count, kernel, ItemSide<Source>(source),
                            Out<kPlanes<F>>(out, kChannels * order * order));
}

template <class F>
void DecodeBatch(size_t count, const PackedProbes& packed, const simd::OutView& out) {
  BlendBatch<F>(count, 1, F::kOrder, EachRecord{packed}, out);
}

template <class F>
void GatherBatch(size_t order, size_t count, const Taps& taps, const PackedProbes& packed,
                 const simd::OutView& out) {
  BlendBatch<F>(count, taps.count, order, TapRecord{taps, packed, ItemsAhead(taps, packed)}, out);
}

template <class... F>
constexpr Table MakeTable(FormatList<F...>) {
  return {{{&EncodeBatch<F>, &DecodeBatch<F>, &GatherBatch<F>}...}};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Formats());
  return &kTable;
}

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(probe);
