// SPDX-License-Identifier: MIT
// The data of one side of a benchmark, in any layout.
#ifndef GAUNT_BENCH_PLANES_H_
#define GAUNT_BENCH_PLANES_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::bench {

enum class Layout { kPlanar, kInterleaved, kTiled, kBroadcast };

const char* Name(Layout layout);

// Planes of a batch in cache-line-aligned memory. Planar data is laid out as it comes, so that 1024
// items are 4 KiB from plane to plane.
class Planes {
 public:
  Planes(Layout layout, size_t count, size_t planes);

  const gaunt_view* view() const { return &view_; }
  size_t planes() const { return planes_; }
  size_t bytes() const { return count_ * planes_ * sizeof(float); }

  void Fill(const std::function<void(size_t item, float* planes)>& make);
  std::vector<double> Item(size_t item) const;  // of a broadcast side, the one that there is

 private:
  float* Element(size_t item, size_t plane) const;

  size_t count_, planes_;
  std::vector<float> memory_;
  gaunt_view view_;
};

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PLANES_H_
