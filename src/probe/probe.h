// SPDX-License-Identifier: MIT
// Packed probes: encoding, decoding, and blending of several of them.
#ifndef GAUNT_PROBE_PROBE_H_
#define GAUNT_PROBE_PROBE_H_

#include <cstddef>
#include <cstdint>

#include "probe/format.h"
#include "simd/view.h"

namespace gaunt::probe {

// Packed records, `stride` bytes apart.
struct PackedProbes {
  const uint8_t* data;
  size_t count;
  size_t stride;
};

inline constexpr uint32_t kMaxTaps = 65536;

// Probes to blend for each item: taps of item i begin at [i * count].
struct Taps {
  size_t count;
  const uint32_t* indices;
  const float* weights;
  size_t items;  // that have taps, those of later calls too
};

inline constexpr size_t kReportPlanes = 3;

using GatherFn = void (*)(size_t order, size_t count, const Taps& taps, const PackedProbes& packed,
                          const simd::OutView& out);

struct FormatTable {
  // `report` is null or has kReportPlanes planes.
  void (*encode)(bool refines, size_t count, const simd::InView& in, uint8_t* packed, size_t stride,
                 const simd::OutView* report);
  void (*decode)(size_t count, const PackedProbes& packed, const simd::OutView& out);
  GatherFn gather;
};

struct Table {
  FormatTable formats[kNumFormats];
};

const Table& Kernels();

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_PROBE_H_
