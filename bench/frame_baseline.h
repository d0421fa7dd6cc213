// SPDX-License-Identifier: MIT
// The frame job in scalar C++, as baselines: lights the dynamic objects of one frame from packed
// probes (SH3, 28 bytes). FrameA is what an engine has, FrameA2 the best scalar form.
//
// frame_baseline.cc is compiled once per compiler and flags, each time with its own
// GAUNT_BASELINE_NAMESPACE; GAUNT_DECLARE_FRAME_BASELINE(name) declares that copy. No type of the
// standard library crosses the border, so objects of different compilers link.
#ifndef GAUNT_BENCH_FRAME_BASELINE_H_
#define GAUNT_BENCH_FRAME_BASELINE_H_

#include <stddef.h>
#include <stdint.h>

struct FrameBaselineJob {
  size_t count;              // objects
  const uint8_t* packed;     // records of 28 bytes
  const uint32_t* indices;   // [object * 8 + tap], all of them valid
  const float* weights;      // [object * 8 + tap]
  float* history;            // [object * 27 + plane], unrotated radiance, updated in place
  float alpha;               // share of the new value
  const float* quaternions;  // [object * 4], x y z w, unit length
  const uint8_t* rotates;    // [object], not 0: constants and light are in the rotated frame
  float* constants;          // [object * 28], 7 float4
  float* light;              // [object * 9]: direction, colour, ambient
  float* gathered;           // [object * 27], written by the gather stages only
};

#define GAUNT_DECLARE_FRAME_BASELINE(name)         \
  namespace name {                                 \
  void FrameA(const FrameBaselineJob& job);        \
  void FrameA2(const FrameBaselineJob& job);       \
  void FrameAGather(const FrameBaselineJob& job);  \
  void FrameA2Gather(const FrameBaselineJob& job); \
  }

#endif  // GAUNT_BENCH_FRAME_BASELINE_H_
