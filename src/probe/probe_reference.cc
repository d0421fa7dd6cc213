// SPDX-License-Identifier: MIT
#include "probe/probe_reference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "evaluate/evaluate_reference.h"
#include "gaunt/gaunt.h"

namespace gaunt::probe {
namespace {

const double kPi = std::acos(-1.0);

uint32_t Word(const uint8_t* bytes) {
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<uint32_t>(bytes[3]) << 24;
}

// max |y_i| / y_0, found on a fine grid of the polar angle: the largest over phi is at its crest.
double Bound(int i) {
  const int l = static_cast<int>(std::sqrt(i)), m = std::abs(i - l * (l + 1));
  double largest = 0.0;
  for (int step = 0; step <= 200000; ++step) {
    const double theta = kPi * step / 200000.0;
    largest = std::max(largest, std::abs(std::sph_legendre(static_cast<unsigned>(l),
                                                           static_cast<unsigned>(m), theta)));
  }
  return largest * (m == 0 ? 1.0 : std::sqrt(2.0)) * std::sqrt(4.0 * kPi);
}
double BoundOf(int i) {
  static const std::vector<double> bounds = [] {
    std::vector<double> all;
    for (int k = 0; k < 25; ++k) all.push_back(Bound(k));
    return all;
  }();
  return bounds[static_cast<size_t>(i)];
}

// A float of a 5-bit exponent, of which 31 is like the others.
Coefficient SmallFloat(uint32_t bits, int mantissa_bits) {
  const int exponent = static_cast<int>(bits >> mantissa_bits & 31);
  const double mantissa = bits & ((1u << mantissa_bits) - 1);
  const double step = std::ldexp(1.0, std::max(exponent, 1) - 15 - mantissa_bits);
  const double value = step * (mantissa + (exponent > 0 ? std::ldexp(1.0, mantissa_bits) : 0.0));
  const double most = std::ldexp(2.0 - std::ldexp(1.0, -mantissa_bits), 15);
  return {value, step, 0.0, most};
}
Coefficient Half(const uint8_t* bytes) {
  const uint32_t bits = bytes[0] | bytes[1] << 8;
  Coefficient half = SmallFloat(bits & 0x7FFF, 10);
  if ((bits & 0x8000) != 0) half.value = -half.value;
  half.least = -half.most;
  return half;
}

std::vector<Coefficient> Rgb9e5(const uint8_t* bytes) {
  const uint32_t word = Word(bytes);
  const double step = std::ldexp(1.0, static_cast<int>(word >> 27) - 24);
  std::vector<Coefficient> means;
  for (int c = 0; c < 3; ++c) means.push_back({step * (word >> (9 * c) & 511), step, 0.0, 65408.0});
  return means;
}
std::vector<Coefficient> R11g11b10(const uint8_t* bytes) {
  const uint32_t word = Word(bytes);
  return {SmallFloat(word & 2047, 6), SmallFloat(word >> 11 & 2047, 6), SmallFloat(word >> 22, 5)};
}
std::vector<Coefficient> Half3(const uint8_t* bytes) {
  std::vector<Coefficient> means = {Half(bytes), Half(bytes + 2), Half(bytes + 4)};
  for (Coefficient& mean : means) mean.least = 0.0;
  return means;
}

Coefficient Snorm8(uint8_t byte, double range) {
  return {range * static_cast<int8_t>(byte) / 127.0, std::abs(range) / 127.0, -std::abs(range),
          std::abs(range)};
}
Coefficient Unorm8(uint8_t byte, double range) {
  return {range * (2.0 * byte / 255.0 - 1.0), std::abs(range) * 2.0 / 255.0, -std::abs(range),
          std::abs(range)};
}

Coefficient Times(const Coefficient& ratio, double mean) {
  return {ratio.value * mean, ratio.step * mean, ratio.least * mean, ratio.most * mean};
}

// Means, and bytes of snorm8, channel by channel, of the coefficients that are there.
std::vector<Coefficient> Ratios(const std::vector<Coefficient>& means, const uint8_t* bytes,
                                int order) {
  std::vector<Coefficient> all;
  for (const Coefficient& mean : means) {
    all.push_back(mean);
    for (int i = 1; i < order * order; ++i) {
      const bool has = i < 9 || i >= 16;
      all.push_back(has ? Times(Snorm8(*bytes++, BoundOf(i)), mean.value)
                        : Coefficient{0, 0, 0, 0});
    }
  }
  return all;
}

std::vector<Coefficient> Unreal(const uint8_t* record) {
  const std::vector<Coefficient> means = R11g11b10(record);
  std::vector<Coefficient> all;
  for (int c = 0; c < 3; ++c) {
    const double mean = means[static_cast<size_t>(c)].value;
    all.push_back(means[static_cast<size_t>(c)]);
    for (int layer = 0; layer < 2; ++layer) {
      const uint8_t* bgra = record + 4 + 8 * c + 4 * layer;
      const uint8_t rgba[4] = {bgra[2], bgra[1], bgra[0], bgra[3]};
      for (int k = 0; k < 4; ++k) {
        const int i = 1 + 4 * layer + k;
        all.push_back(Times(Unorm8(rgba[k], (i < 4 ? 1.0 : 2.0) * BoundOf(i)), mean));
      }
    }
  }
  return all;
}

// E/pi = L0 + L1 . n + ..., of which each term is what a coefficient of radiance gives.
std::vector<Coefficient> Unity(const uint8_t* record, int order) {
  const std::vector<Coefficient> means = Half3(record);
  std::vector<Coefficient> all;
  const double c0 = std::sqrt(1.0 / (4.0 * kPi)), c1 = std::sqrt(3.0 / (4.0 * kPi));
  const double c2 = std::sqrt(15.0 / (4.0 * kPi));
  for (int c = 0; c < 3; ++c) {
    const double mean = means[static_cast<size_t>(c)].value;
    const uint8_t* xyz = record + (c == 1 ? 8 : 12);
    Coefficient linear[3];  // x, y, z
    if (c == 0) {
      linear[0] = Half(record + 6);
      linear[0] = {4.0 * (linear[0].value - 0.5), 4.0 * linear[0].step, -2.0, 2.0};
      linear[1] = Unorm8(record[11], 2.0);
      linear[2] = Unorm8(record[15], 2.0);
    } else {
      for (int k = 0; k < 3; ++k) linear[k] = Unorm8(xyz[k], 2.0);
    }
    const auto negative = [](Coefficient term) {
      return Coefficient{-term.value, term.step, -term.most, -term.least};
    };
    all.push_back(Times(means[static_cast<size_t>(c)], 1.0 / c0));
    const double to_linear = mean / (2.0 / 3.0 * c1);
    all.push_back(Times(negative(linear[1]), to_linear));
    all.push_back(Times(linear[2], to_linear));
    all.push_back(Times(negative(linear[0]), to_linear));
    if (order == 2) continue;
    const double range = 4.0 / std::sqrt(5.0);
    const auto square = [&](int offset, double per_coefficient) {
      return Times(Unorm8(record[offset], range), mean / (0.25 * per_coefficient));
    };
    all.push_back(square(16 + 4 * c, c2));
    all.push_back(negative(square(16 + 4 * c + 1, c2)));
    all.push_back(square(16 + 4 * c + 2, std::sqrt(5.0 / (16.0 * kPi))));
    all.push_back(negative(square(16 + 4 * c + 3, c2)));
    all.push_back(square(28 + c, c2 / 2.0));
  }
  return all;
}

std::vector<Coefficient> Floats(const uint8_t* record) {
  std::vector<Coefficient> all;
  for (int p = 0; p < 27; ++p) {
    float value;
    std::memcpy(&value, record + 4 * p, sizeof(value));
    constexpr double kMost = std::numeric_limits<float>::max();
    all.push_back({value, 0.0, -kMost, kMost});
  }
  return all;
}
std::vector<Coefficient> Halves(const uint8_t* record) {
  std::vector<Coefficient> all;
  for (int p = 0; p < 27; ++p) all.push_back(Half(record + 2 * p));
  return all;
}

}  // namespace

std::vector<Coefficient> ReadReference(uint32_t format, const uint8_t* record) {
  switch (format) {
    case GAUNT_FORMAT_SH3_28: return Ratios(Rgb9e5(record), record + 4, 3);
    case GAUNT_FORMAT_SH2_13: return Ratios(Rgb9e5(record), record + 4, 2);
    case GAUNT_FORMAT_SH3_32: return Ratios(Half3(record), record + 8, 3);
    case GAUNT_FORMAT_SH5_55: return Ratios(Rgb9e5(record), record + 4, 5);
    case GAUNT_FORMAT_SH3_F16: return Halves(record);
    case GAUNT_FORMAT_SH3_F32: return Floats(record);
    case GAUNT_FORMAT_UNREAL_28: return Unreal(record);
    case GAUNT_FORMAT_UNITY_L1_16: return Unity(record, 2);
    case GAUNT_FORMAT_UNITY_L2_32: return Unity(record, 3);
    case GAUNT_FORMAT_RGB9E5: return Rgb9e5(record);
    case GAUNT_FORMAT_R11G11B10F: return R11g11b10(record);
    default: return {};
  }
}

std::vector<double> GatherReference(uint32_t format, size_t taps, const uint32_t* indices,
                                    const float* weights, const uint8_t* packed,
                                    size_t packed_count, size_t stride) {
  std::vector<double> sum(75);
  for (size_t t = 0; t < taps; ++t) {
    if (indices[t] >= packed_count) continue;
    const std::vector<Coefficient> probe = ReadReference(format, packed + indices[t] * stride);
    for (size_t p = 0; p < probe.size(); ++p) sum[p] += double{weights[t]} * probe[p].value;
  }
  return sum;
}

void ErrorReference(int order, const double* wanted, const double* decoded, double* rms,
                    double* bound) {
  *rms = *bound = 0.0;
  for (int c = 0; c < 3; ++c) {
    double largest = 0.0;
    for (int l = 0; l < order; ++l) {
      const double factor = evaluate::CosineFactor(l);
      double band = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        const int p = order * order * c + i;
        band += std::pow(wanted[p] - decoded[p], 2);
      }
      *rms += factor * factor * band;
      largest += std::abs(factor) * std::sqrt(band * (2.0 * l + 1.0) / (4.0 * kPi));
    }
    *bound = std::max(*bound, largest);
  }
  *rms = std::sqrt(*rms / (3.0 * 4.0 * kPi));
}

}  // namespace gaunt::probe
