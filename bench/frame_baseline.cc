// SPDX-License-Identifier: MIT
// Nothing here may have a weak symbol (templates, inline functions): the linker would keep one copy
// of it, of any compiler and flags, for all. Hence <math.h> and static functions only.
#include "bench/frame_baseline.h"

#include <math.h>
#include <string.h>

#ifndef GAUNT_BASELINE_NAMESPACE
#define GAUNT_BASELINE_NAMESPACE baseline
#endif

GAUNT_DECLARE_FRAME_BASELINE(GAUNT_BASELINE_NAMESPACE)

namespace GAUNT_BASELINE_NAMESPACE {
namespace {

constexpr int kTaps = 8;
constexpr int kProbeBytes = 28;
constexpr int kPlanes = 27;

// Step of each ratio: max |y_i| / y_0 over 127.
constexpr float kStep[8] = {1.7320508076f / 127.0f, 1.7320508076f / 127.0f, 1.7320508076f / 127.0f,
                            1.9364916731f / 127.0f, 1.9364916731f / 127.0f, 2.2360679775f / 127.0f,
                            1.9364916731f / 127.0f, 1.9364916731f / 127.0f};

// RGB9E5: mantissa * 2^(e - 24), the power written straight into a float's exponent.
void DecodeMeans(const uint8_t* record, float mean[3]) {
  uint32_t word;
  memcpy(&word, record, sizeof(word));
  const uint32_t bits = ((word >> 27) + 103) << 23;
  float scale;
  memcpy(&scale, &bits, sizeof(scale));
  mean[0] = static_cast<float>(static_cast<int32_t>(word & 511)) * scale;
  mean[1] = static_cast<float>(static_cast<int32_t>((word >> 9) & 511)) * scale;
  mean[2] = static_cast<float>(static_cast<int32_t>((word >> 18) & 511)) * scale;
}

void DecodeProbe(const uint8_t* record, float probe[kPlanes]) {
  float mean[3];
  DecodeMeans(record, mean);
  for (int c = 0; c < 3; ++c) {
    const uint8_t* ratios = record + 4 + 8 * c;
    probe[9 * c] = mean[c];
    for (int i = 0; i < 8; ++i) {
      const float ratio = static_cast<float>(static_cast<int8_t>(ratios[i])) * kStep[i];
      probe[9 * c + 1 + i] = mean[c] * ratio;
    }
  }
}

// A: decode every probe, blend the decoded ones.
void GatherA(const FrameBaselineJob& job, size_t object, float sum[kPlanes]) {
  for (int p = 0; p < kPlanes; ++p) sum[p] = 0.0f;
  for (int t = 0; t < kTaps; ++t) {
    const size_t tap = object * kTaps + static_cast<size_t>(t);
    float probe[kPlanes];
    DecodeProbe(job.packed + static_cast<size_t>(job.indices[tap]) * kProbeBytes, probe);
    const float weight = job.weights[tap];
    for (int p = 0; p < kPlanes; ++p) sum[p] += weight * probe[p];
  }
}

// A2: no decoded probe; the ratios' steps leave the loop over taps.
void GatherA2(const FrameBaselineJob& job, size_t object, float sum[kPlanes]) {
  float mean_sum[3] = {};
  float ratio_sum[3][8] = {};
  for (int t = 0; t < kTaps; ++t) {
    const size_t tap = object * kTaps + static_cast<size_t>(t);
    const uint8_t* record = job.packed + static_cast<size_t>(job.indices[tap]) * kProbeBytes;
    float mean[3];
    DecodeMeans(record, mean);
    for (int c = 0; c < 3; ++c) {
      const float weighted = job.weights[tap] * mean[c];
      const uint8_t* ratios = record + 4 + 8 * c;
      mean_sum[c] += weighted;
      for (int i = 0; i < 8; ++i) {
        ratio_sum[c][i] += weighted * static_cast<float>(static_cast<int8_t>(ratios[i]));
      }
    }
  }
  for (int c = 0; c < 3; ++c) {
    sum[9 * c] = mean_sum[c];
    for (int i = 0; i < 8; ++i) sum[9 * c + 1 + i] = ratio_sum[c][i] * kStep[i];
  }
}

// Basis of band 2 at v, |v|^2 = 1 or 2; for 2, twice the basis at v / |v|.
void Band2(const float v[3], float squared_length, float y[5]) {
  constexpr float kA = 1.0925484306f, kB = 0.3153915653f;
  y[0] = kA * (v[0] * v[1]);
  y[1] = -kA * (v[1] * v[2]);
  y[2] = kB * (3.0f * v[2] * v[2] - squared_length);
  y[3] = -kA * (v[0] * v[2]);
  y[4] = 0.5f * kA * (v[0] * v[0] - v[1] * v[1]);
}

// f'(s) = f(R^-1 s). Band 1 turns like a vector. Band 2 is a sum of five zonal lobes around fixed
// normals, x, z, x+y, x+z and y+z: these turn, the weights of the lobes stay (J. Hable, "Simple and
// Fast Spherical Harmonic Rotation").
void Rotate(const float q[4], float planes[kPlanes]) {
  const float x = q[0], y = q[1], z = q[2], w = q[3];
  const float r[3][3] = {
      {1.0f - 2.0f * (y * y + z * z), 2.0f * (x * y - z * w), 2.0f * (x * z + y * w)},
      {2.0f * (x * y + z * w), 1.0f - 2.0f * (x * x + z * z), 2.0f * (y * z - x * w)},
      {2.0f * (x * z - y * w), 2.0f * (y * z + x * w), 1.0f - 2.0f * (x * x + y * y)}};
  float normals[5][3];
  for (int i = 0; i < 3; ++i) {
    normals[0][i] = r[i][0];
    normals[1][i] = r[i][2];
    normals[2][i] = r[i][0] + r[i][1];
    normals[3][i] = r[i][0] + r[i][2];
    normals[4][i] = r[i][1] + r[i][2];
  }
  float lobes[5][5];
  for (int k = 0; k < 5; ++k) Band2(normals[k], k < 2 ? 1.0f : 2.0f, lobes[k]);

  constexpr float kInverseA = 1.0f / 1.0925484306f, kInverseB = 1.0f / 0.3153915653f;
  for (int c = 0; c < 3; ++c) {
    float* f = planes + 9 * c;
    // Band 1 holds the vector (-f3, -f1, f2).
    const float v[3] = {-f[3], -f[1], f[2]};
    f[1] = -(r[1][0] * v[0] + r[1][1] * v[1] + r[1][2] * v[2]);
    f[2] = r[2][0] * v[0] + r[2][1] * v[1] + r[2][2] * v[2];
    f[3] = -(r[0][0] * v[0] + r[0][1] * v[1] + r[0][2] * v[2]);
    // Weights of the lobes; those of length sqrt 2 hold twice the basis, so half the weight.
    const float w2 = f[4] * kInverseA, w3 = -f[7] * kInverseA, w4 = -f[5] * kInverseA;
    const float w0 = 2.0f * f[8] * kInverseA - w3 + w4;
    const float w1 = 0.5f * (f[6] * kInverseB + w0 - w3 - w4) + w2;
    for (int i = 0; i < 5; ++i) {
      f[4 + i] = w0 * lobes[0][i] + w1 * lobes[1][i] + w2 * lobes[2][i] + w3 * lobes[3][i] +
                 w4 * lobes[4][i];
    }
  }
}

// Optimal linear direction of the luminance, then one light and ambient per channel fitted to E/pi:
// light c_3 y(d), c_3 = 16 pi / 17, bands weighted by (1, 2/3, 1/4) squared.
void ExtractLight(const float f[kPlanes], float light[9]) {
  float sum[4];
  for (int i = 0; i < 4; ++i) sum[i] = 0.2126f * f[i] + 0.7152f * f[9 + i] + 0.0722f * f[18 + i];
  const float length = sqrtf(sum[1] * sum[1] + sum[2] * sum[2] + sum[3] * sum[3]);
  float d[3] = {0.0f, 0.0f, 1.0f};
  if (length > 1e-5f * fabsf(sum[0])) {
    const float inverse = 1.0f / length;
    d[0] = -sum[3] * inverse;
    d[1] = -sum[1] * inverse;
    d[2] = sum[2] * inverse;
  }
  light[0] = d[0];
  light[1] = d[1];
  light[2] = d[2];

  constexpr float kPi = 3.1415926536f, kNorm = 16.0f * kPi / 17.0f;
  constexpr float kY0 = 0.2820947918f, kY1 = 0.4886025119f;
  constexpr float kAmbient = 3.5449077018f;  // 2 sqrt(pi)
  constexpr float kBand1 = 4.0f / 9.0f, kBand2 = 1.0f / 16.0f;
  // |light|^2 over E/pi without and with its mean.
  constexpr float kMean = kNorm * kY0;
  constexpr float kEnergy = kNorm * kNorm * (3.0f * kBand1 + 5.0f * kBand2) / (4.0f * kPi);
  constexpr float kFullEnergy = kEnergy + kMean * kMean;
  constexpr float kPerEnergy = 1.0f / kEnergy, kPerFullEnergy = 1.0f / kFullEnergy;
  constexpr float kPerAmbient = 1.0f / kAmbient;
  float y2[5];
  Band2(d, 1.0f, y2);
  for (int c = 0; c < 3; ++c) {
    const float* g = f + 9 * c;
    const float band1 = kY1 * (d[2] * g[2] - d[1] * g[1] - d[0] * g[3]);
    const float band2 = y2[0] * g[4] + y2[1] * g[5] + y2[2] * g[6] + y2[3] * g[7] + y2[4] * g[8];
    const float dot = kNorm * (kBand1 * band1 + kBand2 * band2);
    float colour = dot * kPerEnergy;
    float ambient = (g[0] - colour * kMean) * kPerAmbient;
    if (colour < 0.0f) {
      colour = 0.0f;
      ambient = g[0] > 0.0f ? g[0] * kPerAmbient : 0.0f;
    } else if (ambient < 0.0f) {
      ambient = 0.0f;
      colour = (dot + kMean * g[0]) * kPerFullEnergy;
      if (colour < 0.0f) colour = 0.0f;
    }
    light[3 + c] = colour;
    light[6 + c] = ambient;
  }
}

// E/pi as 7 float4 (Sloan 2008, appendix A10).
void PackConstants(const float f[kPlanes], float out[28]) {
  constexpr float kC0 = 0.2820947918f, kC1 = 0.3257350079f, kC2 = 0.2731371076f,
                  kC3 = 0.0788478913f, kC4 = 0.1365685538f;
  for (int c = 0; c < 3; ++c) {
    const float* g = f + 9 * c;
    out[4 * c] = -kC1 * g[3];
    out[4 * c + 1] = -kC1 * g[1];
    out[4 * c + 2] = kC1 * g[2];
    out[4 * c + 3] = kC0 * g[0] - kC3 * g[6];
    out[12 + 4 * c] = kC2 * g[4];
    out[12 + 4 * c + 1] = -kC2 * g[5];
    out[12 + 4 * c + 2] = 3.0f * kC3 * g[6];
    out[12 + 4 * c + 3] = -kC2 * g[7];
    out[24 + c] = kC4 * g[8];
  }
  out[27] = 1.0f;
}

// Everything after the gather, for one object.
void Finish(const FrameBaselineJob& job, size_t object, const float gathered[kPlanes]) {
  float* history = job.history + object * kPlanes;
  float lit[kPlanes];
  for (int p = 0; p < kPlanes; ++p) {
    lit[p] = history[p] + job.alpha * (gathered[p] - history[p]);
    history[p] = lit[p];
  }
  if (job.rotates[object]) Rotate(job.quaternions + object * 4, lit);
  ExtractLight(lit, job.light + object * 9);
  PackConstants(lit, job.constants + object * 28);
}

}  // namespace

void FrameA(const FrameBaselineJob& job) {
  for (size_t i = 0; i < job.count; ++i) {
    float gathered[kPlanes];
    GatherA(job, i, gathered);
    Finish(job, i, gathered);
  }
}

void FrameA2(const FrameBaselineJob& job) {
  for (size_t i = 0; i < job.count; ++i) {
    float gathered[kPlanes];
    GatherA2(job, i, gathered);
    Finish(job, i, gathered);
  }
}

void FrameAGather(const FrameBaselineJob& job) {
  for (size_t i = 0; i < job.count; ++i) GatherA(job, i, job.gathered + i * kPlanes);
}

void FrameA2Gather(const FrameBaselineJob& job) {
  for (size_t i = 0; i < job.count; ++i) GatherA2(job, i, job.gathered + i * kPlanes);
}

}  // namespace GAUNT_BASELINE_NAMESPACE
