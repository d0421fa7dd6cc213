// SPDX-License-Identifier: MIT
// The frame job: objects lit from packed probes, all steps in one pass.
#ifndef GAUNT_FRAME_FRAME_H_
#define GAUNT_FRAME_FRAME_H_

#include <cstddef>

#include "evaluate/evaluate.h"
#include "probe/probe.h"
#include "simd/view.h"

namespace gaunt::frame {

inline constexpr int kOrder = 3;
inline constexpr size_t kPlanes = probe::kChannels * kOrder * kOrder;

inline constexpr size_t kConstantPlanes = evaluate::kConstantPlanes;

// Views that are null are left out, and with them what only they would need.
struct Job {
  probe::GatherFn gather;
  size_t order;  // of what is gathered, at most kOrder; higher bands are 0
  probe::Taps taps;
  probe::PackedProbes packed;
  const simd::OutView* history;
  const simd::InView* alpha;  // not null if history is not
  const simd::InView* quaternions;
  const simd::OutView* radiance;
  const simd::OutView* directions;
  const simd::OutView* colours;
  const simd::OutView* ambient;
  const simd::OutView* constants;
};

struct Table {
  void (*light)(size_t count, const Job& job);
};

const Table& Kernels();

}  // namespace gaunt::frame

#endif  // GAUNT_FRAME_FRAME_H_
