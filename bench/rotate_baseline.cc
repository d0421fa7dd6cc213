// SPDX-License-Identifier: MIT
#include "bench/rotate_baseline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bench/scalar_lanes.h"
#include "rotate/rotate-inl.h"

namespace gaunt::bench {
namespace {

namespace kernels = rotate::HWY_NAMESPACE;

void MatrixOf(const float* q, float* r) {
  const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const float x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  r[0] = 1 - 2 * (y * y + z * z), r[1] = 2 * (x * y - w * z), r[2] = 2 * (x * z + w * y);
  r[3] = 2 * (x * y + w * z), r[4] = 1 - 2 * (x * x + z * z), r[5] = 2 * (y * z - w * x);
  r[6] = 2 * (x * z - w * y), r[7] = 2 * (y * z + w * x), r[8] = 1 - 2 * (x * x + y * y);
}

// Of Rz(alpha) Rx(beta) Rz(gamma), without trigonometry.
void EulerAngles(const float* r, ScalarOut angles) {
  const float cosine = r[8], sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  const auto put = [&](size_t plane, float c, float s) {
    angles(plane, {c});
    angles(plane + 1, {s});
  };
  if (sine > 1e-6f) {
    put(kernels::kFirstCosine, r[7] / sine, r[6] / sine);
    put(kernels::kMiddleCosine, cosine, sine);
    put(kernels::kLastCosine, -r[5] / sine, r[2] / sine);
  } else {
    put(kernels::kFirstCosine, 1, 0);
    put(kernels::kMiddleCosine, cosine, 0);
    put(kernels::kLastCosine, r[0], r[3]);
  }
}

template <int n>
void LoopZxzxz(size_t count, const float* quaternions, const float* in, float* out) {
  for (size_t i = 0; i < count; ++i) {
    float matrix[9], angles[kernels::kAnglePlanes];
    MatrixOf(quaternions + 4 * i, matrix);
    EulerAngles(matrix, {angles});
    kernels::RotateBands<n, false>(n, 1)(ScalarLanes(), ScalarIn{angles}, ScalarIn{in + n * n * i},
                                         ScalarOut{out + n * n * i});
  }
}

template <int n>
void LoopFactored(size_t count, const float* quaternions, const float* in, float* out) {
  for (size_t i = 0; i < count; ++i) {
    const ScalarIn quaternion = {quaternions + 4 * i}, from = {in + n * n * i};
    const ScalarOut to = {out + n * n * i};
    if constexpr (n <= kernels::kMaxTensorOrder) {
      kernels::RotateTensorsByQuaternion<n>{1}(ScalarLanes(), quaternion, from, to);
    } else {
      float angles[kernels::kAnglePlanes];
      kernels::AnglesFromQuaternion()(ScalarLanes(), quaternion, ScalarOut{angles});
      kernels::RotateBands<n, false>(n, 1)(ScalarLanes(), ScalarIn{angles}, from, to);
    }
  }
}

// Block matrices R^l_mn in the convention without the Condon-Shortley phase, each from that of the
// band below and from R^1, which is the matrix in the order y, z, x.
template <int n>
class BlockMatrices {
 public:
  explicit BlockMatrices(const float* quaternion) {
    float r[9];
    MatrixOf(quaternion, r);
    constexpr int kAxis[3] = {1, 2, 0};
    At(0, 0, 0) = 1;
    for (int a = -1; n > 1 && a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) At(1, a, b) = r[3 * kAxis[a + 1] + kAxis[b + 1]];
    }
    for (int l = 2; l < n; ++l) {
      for (int a = -l; a <= l; ++a) {
        for (int b = -l; b <= l; ++b) At(l, a, b) = Entry(l, a, b);
      }
    }
    // To the convention with the phase.
    for (int l = 1; l < n; ++l) {
      for (int a = -l; a <= l; ++a) {
        for (int b = -l; b <= l; ++b) {
          if ((a + b) % 2 != 0) At(l, a, b) = -At(l, a, b);
        }
      }
    }
  }

  void Apply(const float* in, float* out) const {
    const float* entry = entries_;
    for (int l = 0; l < n; ++l) {
      const int size = 2 * l + 1;
      for (int a = 0; a < size; ++a) {
        float sum = 0;
        for (int b = 0; b < size; ++b) sum += *entry++ * in[l * l + b];
        out[l * l + a] = sum;
      }
    }
  }

 private:
  float& At(int l, int a, int b) {
    return entries_[l * (4 * l * l - 1) / 3 + (a + l) * (2 * l + 1) + b + l];
  }

  float P(int i, int l, int a, int b) {
    if (b == l) return At(1, i, 1) * At(l - 1, a, l - 1) - At(1, i, -1) * At(l - 1, a, 1 - l);
    if (b == -l) return At(1, i, 1) * At(l - 1, a, 1 - l) + At(1, i, -1) * At(l - 1, a, l - 1);
    return At(1, i, 0) * At(l - 1, a, b);
  }

  float Entry(int l, int m, int b) {
    const int size = std::abs(m);
    const float d = m == 0 ? 1 : 0;
    const float below = std::abs(b) < l ? (l + b) * (l - b) : 2 * l * (2 * l - 1);
    const float u = std::sqrt((l + m) * (l - m) / below);
    const float v = 0.5f * std::sqrt((1 + d) * (l + size - 1) * (l + size) / below) * (1 - 2 * d);
    const float w = -0.5f * std::sqrt((l - size - 1) * (l - size) / below) * (1 - d);
    float sum = 0;
    if (u != 0) sum += u * P(0, l, m, b);
    if (v != 0) sum += v * V(l, m, b);
    if (w != 0) sum += w * W(l, m, b);
    return sum;
  }
  float V(int l, int m, int b) {
    if (m == 0) return P(1, l, 1, b) + P(-1, l, -1, b);
    if (m > 0) {
      const float first = P(1, l, m - 1, b) * (m == 1 ? std::sqrt(2.0f) : 1);
      return m == 1 ? first : first - P(-1, l, 1 - m, b);
    }
    const float last = P(-1, l, -m - 1, b) * (m == -1 ? std::sqrt(2.0f) : 1);
    return m == -1 ? last : P(1, l, m + 1, b) + last;
  }
  float W(int l, int m, int b) {
    return m > 0 ? P(1, l, m + 1, b) + P(-1, l, -m - 1, b) : P(1, l, m - 1, b) - P(-1, l, 1 - m, b);
  }

  float entries_[n * (4 * n * n - 1) / 3];
};

template <int n>
void LoopBlocks(size_t count, const float* quaternions, const float* in, float* out) {
  for (size_t i = 0; i < count; ++i) {
    BlockMatrices<n>(quaternions + 4 * i).Apply(in + n * n * i, out + n * n * i);
  }
}

template <int n>
void LoopBlocksOnce(size_t count, const float* quaternions, const float* in, float* out) {
  const BlockMatrices<n> blocks(quaternions);
  for (size_t i = 0; i < count; ++i) blocks.Apply(in + n * n * i, out + n * n * i);
}

template <int... n>
constexpr auto MakeLoops(std::integer_sequence<int, n...>) {
  struct Loops {
    RotateBaseline zxzxz, blocks, blocks_once, factored;
  };
  return std::array<Loops, sizeof...(n)>{
      Loops{&LoopZxzxz<kMinBaselineOrder + n>, &LoopBlocks<kMinBaselineOrder + n>,
            &LoopBlocksOnce<kMinBaselineOrder + n>, &LoopFactored<kMinBaselineOrder + n>}...};
}
constexpr auto kLoops =
    MakeLoops(std::make_integer_sequence<int, kMaxBaselineOrder - kMinBaselineOrder + 1>());
const auto& LoopsOf(int order) { return kLoops.at(static_cast<size_t>(order - kMinBaselineOrder)); }

}  // namespace

RotateBaseline Zxzxz(int order) { return LoopsOf(order).zxzxz; }
RotateBaseline Blocks(int order) { return LoopsOf(order).blocks; }
RotateBaseline BlocksOnce(int order) { return LoopsOf(order).blocks_once; }
RotateBaseline Factored(int order) { return LoopsOf(order).factored; }

}  // namespace gaunt::bench
