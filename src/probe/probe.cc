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
constexpr size_t kFields = 1 + Sh3::kChannels * Sh3::kRatios;

// Fields, each in a float's room, to bytes; little-endian on every host.
void PackRecord(const float* fields, uint8_t* record) {
  uint32_t word;
  std::memcpy(&word, fields, sizeof(word));
  for (int byte = 0; byte < 4; ++byte) record[byte] = static_cast<uint8_t>(word >> (8 * byte));
  for (size_t i = 1; i < kFields; ++i) {
    int32_t ratio;
    std::memcpy(&ratio, fields + i, sizeof(ratio));
    record[Sh3::kRatiosOffset + i - 1] = static_cast<uint8_t>(ratio);
  }
}

void EncodeBatch(size_t count, const simd::InView& in, uint8_t* packed, size_t stride,
                 const simd::OutView* report) {
  float fields[kEncodeChunk * kFields];
  for (size_t done = 0; done < count; done += kEncodeChunk) {
    const size_t n = std::min(kEncodeChunk, count - done);
    In<27> in_side(in, 27, done);
    Out<kFields> field_side(simd::InterleavedOut(fields, kFields));
    if (report != nullptr) {
      ForEachBatch<EncodeLanes>(n, EncodeSh3<true>(), in_side, field_side,
                                Out<kReportPlanes>(*report, kReportPlanes, done));
    } else {
      ForEachBatch<EncodeLanes>(n, EncodeSh3<false>(), in_side, field_side);
    }
    for (size_t i = 0; i < n; ++i) PackRecord(fields + i * kFields, packed + (done + i) * stride);
  }
}

void DecodeBatch(size_t count, const PackedProbes& packed, const simd::OutView& out) {
  GatherRecords<3>(count, 1, EachRecord{packed}, out);
}

template <int n>
void GatherBatch(size_t count, const Taps& taps, const PackedProbes& packed,
                 const simd::OutView& out) {
  GatherRecords<n>(count, taps.count, TapRecord{taps, packed}, out);
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {&EncodeBatch, &DecodeBatch, {nullptr, &GatherBatch<n>...}};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<Sh3::kOrder>());
  return &kTable;
}

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(probe);
