// SPDX-License-Identifier: MIT
#include "probe/probe_reference.h"

#include <algorithm>
#include <cmath>

#include "evaluate/evaluate_reference.h"

namespace gaunt::probe {
namespace {

// max |y_i| / y_0.
double Bound(int i) {
  if (i < 4) return std::sqrt(3.0);
  return i == 6 ? std::sqrt(5.0) : std::sqrt(15.0) / 2.0;
}

void DecodeMeans(const uint8_t* record, double means[3]) {
  const uint32_t word = static_cast<uint32_t>(record[0]) | static_cast<uint32_t>(record[1]) << 8 |
                        static_cast<uint32_t>(record[2]) << 16 |
                        static_cast<uint32_t>(record[3]) << 24;
  const int exponent = static_cast<int>(word >> 27) - 24;
  for (int c = 0; c < 3; ++c) {
    means[c] = std::ldexp(static_cast<double>(word >> (9 * c) & 511), exponent);
  }
}

}  // namespace

void DecodeReference(const uint8_t* record, double out[27]) {
  double means[3];
  DecodeMeans(record, means);
  for (int c = 0; c < 3; ++c) {
    out[9 * c] = means[c];
    for (int i = 1; i < 9; ++i) {
      const int q = static_cast<int8_t>(record[4 + 8 * c + i - 1]);
      out[9 * c + i] = means[c] * Bound(i) * q / 127.0;
    }
  }
}

void EncodeReference(const double in[27], uint8_t* record) {
  double largest = 0.0, wanted[3];
  for (int c = 0; c < 3; ++c) {
    wanted[c] = in[9 * c] > 0.0 ? std::min(in[9 * c], 65408.0) : 0.0;
    largest = std::max(largest, wanted[c]);
  }
  int exponent = 0;  // the least that holds the largest mantissa
  while (std::nearbyint(std::ldexp(largest, 24 - exponent)) > 511.0) ++exponent;
  uint32_t word = static_cast<uint32_t>(exponent) << 27;
  for (int c = 0; c < 3; ++c) {
    const double mantissa = std::nearbyint(std::ldexp(wanted[c], 24 - exponent));
    word |= static_cast<uint32_t>(mantissa) << (9 * c);
  }
  for (int byte = 0; byte < 4; ++byte) record[byte] = static_cast<uint8_t>(word >> (8 * byte));
  double means[3];
  DecodeMeans(record, means);
  for (int c = 0; c < 3; ++c) {
    for (int i = 1; i < 9; ++i) {
      double q = means[c] > 0.0 ? 127.0 * in[9 * c + i] / (means[c] * Bound(i)) : 0.0;
      if (std::isnan(q)) q = 0.0;
      q = std::nearbyint(std::max(-127.0, std::min(q, 127.0)));
      record[4 + 8 * c + i - 1] = static_cast<uint8_t>(static_cast<int>(q));
    }
  }
}

void GatherReference(size_t taps, const uint32_t* indices, const float* weights,
                     const uint8_t* packed, size_t packed_count, size_t stride, double out[27]) {
  std::fill(out, out + 27, 0.0);
  for (size_t t = 0; t < taps; ++t) {
    if (indices[t] >= packed_count) continue;
    double decoded[27];
    DecodeReference(packed + indices[t] * stride, decoded);
    for (int p = 0; p < 27; ++p) out[p] += static_cast<double>(weights[t]) * decoded[p];
  }
}

void ErrorReference(const double wanted[27], const double decoded[27], double* rms, double* bound) {
  const double pi = std::acos(-1.0);
  *rms = *bound = 0.0;
  for (int c = 0; c < 3; ++c) {
    double largest = 0.0;
    for (int l = 0; l < 3; ++l) {
      const double factor = evaluate::CosineFactor(l);
      double band = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        band += std::pow(wanted[9 * c + i] - decoded[9 * c + i], 2);
      }
      *rms += factor * factor * band;
      largest += factor * std::sqrt(band * (2.0 * l + 1.0) / (4.0 * pi));
    }
    *bound = std::max(*bound, largest);
  }
  *rms = std::sqrt(*rms / (3.0 * 4.0 * pi));
}

}  // namespace gaunt::probe
