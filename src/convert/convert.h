// SPDX-License-Identifier: MIT
// Coefficients of one convention turned into those of another.
#ifndef GAUNT_CONVERT_CONVERT_H_
#define GAUNT_CONVERT_CONVERT_H_

#include "convert/plan.h"
#include "simd/view.h"

namespace gaunt::convert {

// Bands of a conversion that go through the kernel together: as many as fit a small stack tile, or
// one.
inline constexpr int kChunkPlanes = 36;

// The end of the chunk that begins with a band.
constexpr int ChunkEnd(int first_band, int order) {
  int end = first_band + 1;
  while (end < order && (end + 1) * (end + 1) - first_band * first_band <= kChunkPlanes) ++end;
  return end;
}

struct Table {
  void (*convert)(const Conversion& conversion, int order, size_t channels, size_t count,
                  const simd::InView& in, const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::convert

#endif  // GAUNT_CONVERT_CONVERT_H_
