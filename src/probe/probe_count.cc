// SPDX-License-Identifier: MIT
// Operations of the probe kernels, by running them on counting lanes.
#include "probe/probe-inl.h"
#include "simd/count.h"

namespace gaunt::probe {

void AppendOperations(OperationRows& rows);

namespace {

// Twin of RecordLanes.
struct CountRecordLanes {
  template <int>
  Counted Mantissa(Counted) const {
    return {};
  }
  Counted Scale(Counted) const { return {}; }
  Counted Ratios(const uint8_t*) const { return ++CountedOperations().load, Counted(); }
};

// Twin of EncodeLanes.
struct CountEncodeLanes : CountLanes {
  Counted PowerOfTwo(Counted) const { return {}; }
  Counted Integer(Counted) const { return {}; }
  Counted Rgb9e5Word(Counted, Counted, Counted, Counted) const { return {}; }
};

// One tap of one object: its means, their sums, and the ratios, eight to a vector.
Operations Tap() {
  CountedOperations() = Operations();
  Counted r, g, b;
  HWY_NAMESPACE::WeightedMeans(CountRecordLanes(), Counted(), Counted(), r, g, b);
  for (size_t c = 0; c < Sh3::kChannels; ++c) Add(r, g);
  const Operations means = CountedOperations();
  CountedOperations() = Operations();
  HWY_NAMESPACE::AddRatios(CountRecordLanes(), nullptr, r, g, b, r, g, b);
  return means + Sh3::kRatios * CountedOperations();
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  const Operations finish = CountKernel(kernels::FinishGather<3>(), planes, planes, planes);
  rows.push_back({"probe_gather", "3", "sh3_28_4_taps", 4 * Tap() + finish});
  rows.push_back({"probe_gather", "3", "sh3_28_8_taps", 8 * Tap() + finish});
  rows.push_back({"probe_decode", "3", "sh3_28", Tap() + finish});
  CountedOperations() = Operations();
  kernels::EncodeSh3<false>()(CountEncodeLanes(), planes, planes);
  rows.push_back({"probe_encode", "3", "sh3_28", CountedOperations()});
  CountedOperations() = Operations();
  kernels::EncodeSh3<true>()(CountEncodeLanes(), planes, planes, planes);
  rows.push_back({"probe_encode", "3", "sh3_28_report", CountedOperations()});
}

}  // namespace gaunt::probe
