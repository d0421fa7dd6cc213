// SPDX-License-Identifier: MIT
#include "bench/evaluate_baseline.h"

namespace gaunt::bench {
namespace {

struct Probe {
  float sh[3][9];
};

// Out of line: engines call it across files, once per normal.
[[gnu::noinline]] void EvalNormal(const Probe& probe, const float n[3], float out[3]) {
  const float x = n[0], y = n[1], z = n[2];
  const float basis[9] = {0.282094792f,
                          -0.488602512f * y,
                          0.488602512f * z,
                          -0.488602512f * x,
                          1.092548431f * x * y,
                          -1.092548431f * y * z,
                          0.315391565f * (3.0f * z * z - 1.0f),
                          -1.092548431f * x * z,
                          0.546274215f * (x * x - y * y)};
  for (int c = 0; c < 3; ++c) {
    float sum = 0.0f;
    for (int i = 0; i < 9; ++i) sum += basis[i] * probe.sh[c][i];
    out[c] = sum;
  }
}

}  // namespace

void IrradianceEngineOneProbe(size_t count, const float* normals, float* out) {
  Probe probe;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 9; ++i) {
      probe.sh[c][i] = static_cast<float>((9 * c + i) * 13 % 29) / 29.0f;
    }
  }
  for (size_t i = 0; i < count; ++i) EvalNormal(probe, normals + 3 * i, out + 3 * i);
}

}  // namespace gaunt::bench
