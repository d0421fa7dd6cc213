// SPDX-License-Identifier: MIT
#include "bench/zonal_baseline.h"

#include "bench/basis_baseline.h"

namespace gaunt::bench {
namespace {

// sqrt(4 pi / (2l+1))
const float kBandFactor[6] = {3.544907702f, 2.046653416f, 1.585330919f,
                              1.339849171f, 1.181635901f, 1.068829823f};

// Out of line: engines call it across files, once per light.
[[gnu::noinline]] void RotateZonal(float* out, int order, int channels, const float* zonal,
                                   const float direction[3]) {
  float y[36];
  BasisEngineEval(y, order, direction);
  for (int c = 0; c < channels; ++c) {
    for (int l = 0; l < order; ++l) {
      const float factor = kBandFactor[l] * zonal[c * order + l];
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[c * order * order + i] = factor * y[i];
    }
  }
}

}  // namespace

void ZonalEngine(int order, int channels, size_t count, const float* zonal, const float* directions,
                 float* out) {
  for (size_t i = 0; i < count; ++i) {
    RotateZonal(out, order, channels, zonal, directions);
    zonal += channels * order;
    directions += 3;
    out += channels * order * order;
  }
}

}  // namespace gaunt::bench
