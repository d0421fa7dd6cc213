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

// E/pi = l0 (1 + 8 (t - 1/2) . n): layers of l0 and of t for y, z and x.
std::vector<Coefficient> Godot(const uint8_t* record) {
  const double c0 = std::sqrt(1.0 / (4.0 * kPi)), c1 = 2.0 / 3.0 * std::sqrt(3.0 / (4.0 * kPi));
  std::vector<Coefficient> all;
  for (int c = 0; c < 3; ++c) {
    Coefficient mean = Half(record + 2 * c);
    mean.least = 0.0;
    all.push_back(Times(mean, 1.0 / c0));
    for (int layer = 1; layer < 4; ++layer) {
      const Coefficient t = Half(record + 8 * layer + 2 * c);
      const double sign = layer == 2 ? 1.0 : -1.0;
      all.push_back(
          Times({sign * 8.0 * (t.value - 0.5), 8.0 * t.step, -4.0, 4.0}, mean.value / c1));
    }
  }
  return all;
}

// An integer in two's complement of some bits of a record.
int Signed(const uint8_t* record, int bit, int width) {
  int value = 0;
  for (int k = 0; k < width; ++k) {
    value |= (record[(bit + k) / 8] >> (bit + k) % 8 & 1) << k;
  }
  return value >= 1 << (width - 1) ? value - (1 << width) : value;
}

// Where the numbers of coefficient i are: of the shared ratio, of orange and of green.
struct SharedPlaces {
  struct Place {
    int bit, width;
  };
  Place ratio, orange, green;
};
SharedPlaces PlacesOf(uint32_t format, int i) {
  if (format == GAUNT_FORMAT_SH3_CHROMA_16) {
    const SharedPlaces places[] = {{{32, 7}, {39, 5}, {44, 5}},   {{64, 7}, {71, 5}, {76, 5}},
                                   {{96, 7}, {103, 5}, {108, 5}}, {{49, 6}, {55, 3}, {0, 0}},
                                   {{58, 6}, {119, 3}, {0, 0}},   {{81, 6}, {87, 3}, {0, 0}},
                                   {{90, 6}, {122, 3}, {0, 0}},   {{113, 6}, {125, 3}, {0, 0}}};
    return places[i - 1];
  }
  if (format == GAUNT_FORMAT_SH3_CHROMA_21) {
    const SharedPlaces places[] = {{{32, 8}, {78, 6}, {84, 6}},   {{40, 8}, {90, 6}, {110, 6}},
                                   {{48, 8}, {116, 6}, {122, 6}}, {{56, 7}, {128, 4}, {132, 4}},
                                   {{64, 7}, {136, 4}, {140, 4}}, {{71, 7}, {144, 4}, {148, 4}},
                                   {{96, 7}, {152, 4}, {156, 4}}, {{103, 7}, {160, 4}, {164, 4}}};
    return places[i - 1];
  }
  return {{24 + 8 * i, 8}, {0, 0}, {0, 0}};
}

double Share(int number, int width, bool squared = false) {
  const double largest = (1 << (width - 1)) - 1;
  return squared ? number * std::abs(number) / (largest * largest) : number / largest;
}
double ColourRange(int i) { return i < 4 ? 0.35 : 0.25; }

// Ratios of coefficients i < end that the channels share, with their colours.
std::vector<std::vector<double>> SharedRatios(uint32_t format, const uint8_t* record, int end) {
  const std::vector<Coefficient> means = Rgb9e5(record);
  const double luma = (means[0].value + 2.0 * means[1].value + means[2].value) / 4.0;
  std::vector<std::vector<double>> all(3, std::vector<double>(9, 0.0));
  for (int i = 1; i < end; ++i) {
    const SharedPlaces places = PlacesOf(format, i);
    const auto number = [&](SharedPlaces::Place p) { return Signed(record, p.bit, p.width); };
    const auto colour = [&](SharedPlaces::Place p) {
      return p.width == 0 ? 0.0 : ColourRange(i) * Share(number(p), p.width, true);
    };
    const double ratio = Share(number(places.ratio), places.ratio.width);
    const double o = colour(places.orange), g = colour(places.green);
    const double extra[3] = {o - g, g, -o - g};
    for (size_t c = 0; c < 3; ++c) {
      all[c][static_cast<size_t>(i)] = BoundOf(i) * (ratio * means[c].value + luma * extra[c]);
    }
  }
  return all;
}

// The zonal function of band 2 of norm 1 about the axis of a band 1 (f1, f2, f3) = (-y, z, -x); 0 for
// no axis.
std::vector<double> ZonalBand(double f1, double f2, double f3) {
  const double length = std::sqrt(f1 * f1 + f2 * f2 + f3 * f3);
  if (length == 0.0) return std::vector<double>(5, 0.0);
  const double x = -f3 / length, y = -f1 / length, z = f2 / length, root = std::sqrt(3.0);
  return {root * x * y, -root * y * z, 1.5 * z * z - 0.5, -root * x * z,
          root / 2.0 * (x * x - y * y)};
}
// Of a record of ZH3, whose axis is that of the luminance.
std::vector<double> ZonalBandOf(const std::vector<std::vector<double>>& band_one) {
  const auto sum = [&](size_t i) {
    return 0.2126 * band_one[0][i] + 0.7152 * band_one[1][i] + 0.0722 * band_one[2][i];
  };
  return ZonalBand(sum(1), sum(2), sum(3));
}

// |sum of the channels' luminances of band 1| / sum of their norms.
double AxisCertainty(const std::vector<std::vector<double>>& band_one) {
  const double weights[3] = {0.2126, 0.7152, 0.0722};
  double sum[3] = {0.0, 0.0, 0.0}, norms = 0.0;
  for (size_t c = 0; c < 3; ++c) {
    double squares = 0.0;
    for (size_t i = 1; i < 4; ++i) {
      const double f = weights[c] * band_one[c][i];
      sum[i - 1] += f;
      squares += f * f;
    }
    norms += std::sqrt(squares);
  }
  const double norm = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  return norms == 0.0 ? 1.0 : norm / norms;
}

std::vector<std::vector<double>> BandOne(uint32_t format, const uint8_t* record) {
  if (format == GAUNT_FORMAT_ZH3_LUMA_8) return SharedRatios(format, record, 4);
  const std::vector<Coefficient> means = Rgb9e5(record);
  std::vector<std::vector<double>> all(3, std::vector<double>(9, 0.0));
  for (int c = 0; c < 3; ++c) {
    for (int i = 1; i < 4; ++i) {
      const double ratio = Share(Signed(record, 32 + 8 * (3 * c + i - 1), 8), 8);
      all[static_cast<size_t>(c)][static_cast<size_t>(i)] =
          ratio * BoundOf(i) * means[static_cast<size_t>(c)].value;
    }
  }
  return all;
}
int AxialBit(uint32_t format, int c) {
  return format == GAUNT_FORMAT_ZH3_LUMA_8 ? 56 : 104 + 8 * c;
}

// Ranges are those that the numbers give.
std::vector<Coefficient> WithMeans(const uint8_t* record,
                                   const std::vector<std::vector<double>>& ratios, double most) {
  std::vector<Coefficient> all;
  for (size_t c = 0; c < 3; ++c) {
    const Coefficient mean = Rgb9e5(record)[c];
    all.push_back(mean);
    const double brightest =
        std::max({Rgb9e5(record)[0].value, Rgb9e5(record)[1].value, Rgb9e5(record)[2].value});
    for (size_t i = 1; i < 9; ++i) {
      all.push_back({ratios[c][i], 0.0, -most * brightest, most * brightest});
    }
  }
  return all;
}
std::vector<Coefficient> Shared(uint32_t format, const uint8_t* record) {
  return WithMeans(record, SharedRatios(format, record, 9), std::sqrt(5.0));
}
std::vector<Coefficient> Zh3(uint32_t format, const uint8_t* record) {
  std::vector<std::vector<double>> ratios = BandOne(format, record);
  const std::vector<double> band = ZonalBandOf(ratios);
  for (int c = 0; c < 3; ++c) {
    const double k2 = std::sqrt(5.0) * Rgb9e5(record)[static_cast<size_t>(c)].value *
                      Share(Signed(record, AxialBit(format, c), 8), 8);
    for (size_t m = 0; m < 5; ++m) ratios[static_cast<size_t>(c)][4 + m] = k2 * band[m];
  }
  std::vector<Coefficient> all = WithMeans(record, ratios, std::sqrt(5.0));
  const double s = AxisCertainty(ratios);
  for (int c = 0; c < 3; ++c) {
    for (int i = 4; i < 9; ++i) {
      Coefficient& coefficient = all[static_cast<size_t>(9 * c + i)];
      coefficient.most /= s;
      coefficient.least /= s;
    }
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
    case GAUNT_FORMAT_SH3_LUMA_12:
    case GAUNT_FORMAT_SH3_CHROMA_16:
    case GAUNT_FORMAT_SH3_CHROMA_21: return Shared(format, record);
    case GAUNT_FORMAT_ZH3_16:
    case GAUNT_FORMAT_ZH3_LUMA_8: return Zh3(format, record);
    case GAUNT_FORMAT_GODOT_L1_32: return Godot(record);
    default: return {};
  }
}

std::vector<Written> WrittenReference(uint32_t format, const float* light, const uint8_t* record) {
  if (format < GAUNT_FORMAT_SH3_LUMA_12 || format > GAUNT_FORMAT_ZH3_LUMA_8) return {};
  const bool is_zonal = format == GAUNT_FORMAT_ZH3_16 || format == GAUNT_FORMAT_ZH3_LUMA_8;
  const std::vector<Coefficient> means = Rgb9e5(record);
  const double m[3] = {means[0].value, means[1].value, means[2].value};
  const double luma = (m[0] + 2.0 * m[1] + m[2]) / 4.0;
  // As far as a channel of light can have it, in relation to the range.
  const auto share = [&](int c, int i, double range) {
    const double f = double{light[9 * c + i]} / range;
    return std::isnan(f) ? 0.0 : std::max(-m[c], std::min(f, m[c]));
  };
  const auto over = [](double a, double b) { return b == 0.0 ? 0.0 : a / b; };
  const auto closest = [&](const double(&f)[3]) {
    return over(m[0] * f[0] + m[1] * f[1] + m[2] * f[2], m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  };
  std::vector<Written> all;
  const auto add = [&](int bit, int width, bool squared, double wanted) {
    const int largest = (1 << (width - 1)) - 1;
    const double code = squared ? largest * largest : largest;
    all.push_back({Signed(record, bit, width), largest, squared,
                   std::max(-code, std::min(code * wanted, code))});
  };
  if (format == GAUNT_FORMAT_ZH3_16) {
    for (int c = 0; c < 3; ++c) {
      for (int i = 1; i < 4; ++i) {
        add(32 + 8 * (3 * c + i - 1), 8, false, over(share(c, i, BoundOf(i)), m[c]));
      }
    }
  } else {
    for (int i = 1; i < (is_zonal ? 4 : 9); ++i) {
      const SharedPlaces places = PlacesOf(format, i);
      double f[3];
      for (int c = 0; c < 3; ++c) f[c] = share(c, i, BoundOf(i));
      // Without what orange takes, (1, 0, -1), and without what both colours take.
      double ratio = closest(f);
      if (places.orange.width > 0) {
        const double pair = m[0] + m[2];
        ratio = over(pair * (f[0] + f[2]) + 2.0 * m[1] * f[1], pair * pair + 2.0 * m[1] * m[1]);
      }
      if (places.green.width > 0) ratio = over((f[0] + 2.0 * f[1] + f[2]) / 4.0, luma);
      add(places.ratio.bit, places.ratio.width, false, ratio);
      const double decoded = Share(all.back().number, places.ratio.width);
      for (int c = 0; c < 3; ++c) f[c] = over(f[c] - m[c] * decoded, luma);
      if (places.orange.width > 0) {
        add(places.orange.bit, places.orange.width, true, (f[0] - f[2]) / 2.0 / ColourRange(i));
      }
      if (places.green.width > 0) {
        add(places.green.bit, places.green.width, true,
            (2.0 * f[1] - f[0] - f[2]) / 4.0 / ColourRange(i));
      }
    }
  }
  if (is_zonal) {
    const std::vector<double> band = ZonalBandOf(BandOne(format, record));
    double along[3] = {0.0, 0.0, 0.0};
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < 5; ++k) {
        along[c] += band[static_cast<size_t>(k)] * share(c, 4 + k, std::sqrt(5.0));
      }
    }
    if (format == GAUNT_FORMAT_ZH3_LUMA_8) {
      add(56, 8, false, closest(along));
    } else {
      for (int c = 0; c < 3; ++c) add(104 + 8 * c, 8, false, over(along[c], m[c]));
    }
  }
  return all;
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
