// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "probe/probe_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kFormats = 17;

struct Format {
  uint32_t id;
  size_t bytes, planes;
  uint32_t order;
};
std::vector<Format> AllFormats() {
  std::vector<Format> formats;
  for (uint32_t id = 1; id <= kFormats; ++id) {
    gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
    EXPECT_EQ(gaunt_format_info(id, &properties), GAUNT_OK);
    formats.push_back({id, properties.bytes, properties.planes, properties.order});
  }
  return formats;
}
std::string Name(const Format& format) { return "format " + std::to_string(format.id); }

// Largest ratios of non-negative light by band; single coefficients have less.
double BandBound(size_t i) { return std::sqrt(2.0 * std::floor(std::sqrt(double(i))) + 1.0); }

// Radiance as probes have it: ratios that the formats' ranges hold and some that they do not, over
// many magnitudes.
void MakeProbe(Random& random, const Format& format, float* f) {
  const double scale = std::pow(10.0, random.Between(-3.0, 4.0));
  const size_t size = format.planes / 3;
  for (size_t c = 0; c < 3; ++c) {
    f[size * c] = static_cast<float>(scale * random.Between(0.1, 1.0));
    for (size_t i = 1; i < size; ++i) {
      f[size * c + i] = static_cast<float>(f[size * c] * BandBound(i) * random.Between(-1.0, 1.0));
    }
  }
}

std::vector<float> MakeProbes(Random& random, const Format& format, size_t count) {
  std::vector<float> probes(count * format.planes);
  for (size_t i = 0; i < count; ++i) MakeProbe(random, format, &probes[i * format.planes]);
  return probes;
}

std::vector<uint8_t> MakeRecords(Random& random, const Format& format, size_t count,
                                 size_t stride) {
  std::vector<uint8_t> packed(count * stride, 0xEE);
  std::vector<float> probes = MakeProbes(random, format, count);
  gaunt_view view;
  gaunt_view_interleaved(probes.data(), format.planes, &view);
  EXPECT_EQ(gaunt_probe_encode(format.id, count, &view, packed.data(), stride, nullptr), GAUNT_OK);
  return packed;
}

class Probe : public TargetTest {};

void ExpectDecoded(const std::vector<probe::Coefficient>& wanted, const Buffer& out, size_t item) {
  for (size_t p = 0; p < wanted.size(); ++p) {
    const double range = std::max(std::abs(wanted[p].most), std::abs(wanted[p].least));
    const bool is_mean = wanted[p].least == 0.0 || range > 1e30;
    ASSERT_NEAR(out.Get(item, p), wanted[p].value,
                2.4e-7 * (is_mean ? std::abs(wanted[p].value) : range))
        << "plane " << p;
  }
}

TEST_P(Probe, DecodesEveryFormatLayoutAndStride) {
  Random random(1);
  for (const Format& format : AllFormats()) {
    for (const size_t more : {size_t{0}, size_t{1}, size_t{9}}) {
      const size_t stride = format.bytes + more;
      for (const size_t count : {0, 1, 3, 7, 8, 9, 15, 16, 17, 33, 70}) {
        const std::vector<uint8_t> packed = MakeRecords(random, format, count, stride);
        for (const Layout layout : Layouts()) {
          SCOPED_TRACE(Name(format) + " " + Name(layout) + " " + std::to_string(count));
          Buffer out(layout, count, format.planes);
          ASSERT_EQ(gaunt_probe_decode(format.id, count, packed.data(), stride, out.view()),
                    GAUNT_OK);
          ASSERT_TRUE(out.CanariesIntact());
          for (size_t i = 0; i < count; ++i) {
            ExpectDecoded(probe::ReadReference(format.id, packed.data() + i * stride), out, i);
          }
        }
      }
    }
  }
}

// Records begin and end where their memory does: a sanitizer sees any byte read around them.
TEST_P(Probe, ReadsNothingAroundTheRecords) {
  Random random(2);
  for (const Format& format : AllFormats()) {
    for (size_t count = 1; count < 20; ++count) {
      const std::vector<uint8_t> records = MakeRecords(random, format, count, format.bytes);
      const std::unique_ptr<uint8_t[]> packed(new uint8_t[records.size()]);
      std::copy(records.begin(), records.end(), packed.get());
      Buffer out(Layout::kPlanar, count, format.planes);
      EXPECT_EQ(gaunt_probe_decode(format.id, count, packed.get(), format.bytes, out.view()),
                GAUNT_OK);
      const std::vector<uint32_t> indices(count * 8, static_cast<uint32_t>(count - 1));
      const std::vector<float> weights(count * 8, 0.125f);
      EXPECT_EQ(gaunt_probe_gather(format.id, format.order, count, 8, indices.data(),
                                   weights.data(), packed.get(), count, format.bytes, out.view()),
                GAUNT_OK);
    }
  }
}

TEST_P(Probe, DecodesAnyBytesToFiniteValues) {
  Random random(3);
  for (const Format& format : AllFormats()) {
    if (format.id == GAUNT_FORMAT_SH3_F32) continue;  // are what they are
    SCOPED_TRACE(Name(format));
    constexpr size_t kCount = 4000;
    std::vector<uint8_t> packed(kCount * format.bytes);
    for (uint8_t& byte : packed) byte = static_cast<uint8_t>(random.Bits());
    for (size_t b = 0; b < 8 * format.bytes; ++b) packed[b] = b % 3 == 0 ? 0xFF : 0x7F;
    Buffer out(Layout::kTiled, kCount, format.planes);
    ASSERT_EQ(gaunt_probe_decode(format.id, kCount, packed.data(), format.bytes, out.view()),
              GAUNT_OK);
    // Where the axis is uncertain, so is band 2: `most` tells how much.
    const double error = format.id == GAUNT_FORMAT_ZH3_16 ? 1e-6 : 2.5e-7;
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t p = 0; p < format.planes; ++p) ASSERT_TRUE(std::isfinite(out.Get(i, p)));
      const auto wanted = probe::ReadReference(format.id, packed.data() + i * format.bytes);
      for (size_t p = 0; p < format.planes; ++p) {
        const size_t mean = p / (format.planes / 3) * (format.planes / 3);
        double scale = std::max(std::abs(wanted[p].value), 8.0 * std::abs(wanted[mean].value));
        if (wanted[p].step == 0.0) scale = std::max(scale, wanted[p].most);  // of all channels
        ASSERT_NEAR(out.Get(i, p), wanted[p].value, error * scale);
      }
    }
  }
}

// Each coefficient is the nearest that the record can have, given its means.
void ExpectNearest(const Format& format, const float* f, const uint8_t* record) {
  const std::vector<probe::Coefficient> have = probe::ReadReference(format.id, record);
  const size_t size = format.planes / 3;
  double largest = 0.0;  // of RGB9E5, whose channels share a step
  for (size_t p = 0; p < have.size(); p += size) largest = std::max(largest, have[p].step);
  const std::vector<probe::Written> written = probe::WrittenReference(format.id, f, record);
  for (size_t k = 0; k < written.size(); ++k) {
    const auto error = [&](int number) {
      const double code = written[k].squared ? number * std::abs(number) : number;
      return std::abs(code - written[k].wanted);
    };
    const int number = written[k].number;
    const double rounding = 2e-4 + 1e-6 * std::abs(written[k].wanted);
    ASSERT_LE(std::abs(number), written[k].largest) << "number " << k;
    ASSERT_LE(error(number), error(number + 1) + rounding) << "number " << k;
    ASSERT_LE(error(number), error(number - 1) + rounding) << "number " << k;
  }
  for (size_t p = 0; p < have.size(); p += written.empty() ? 1 : size) {
    double wanted = std::isnan(f[p]) ? 0.0 : double{f[p]};
    wanted = std::max(have[p].least, std::min(wanted, have[p].most));
    const double rounding = 3e-7 * std::abs(have[p].value);  // of units, means and ratios in float
    ASSERT_LE(std::abs(have[p].value - wanted), 0.5001 * have[p].step + rounding)
        << "plane " << p << " wanted " << wanted << " has " << have[p].value;
  }
}

TEST_P(Probe, EncodesToNearestInEveryFormatAndLayout) {
  Random random(4);
  for (const Format& format : AllFormats()) {
    for (const size_t more : {size_t{0}, size_t{4}}) {
      const size_t stride = format.bytes + more;
      for (const size_t count : {0, 1, 3, 15, 16, 17, 31, 32, 33, 70}) {
        const std::vector<float> probes = MakeProbes(random, format, count);
        for (const Layout layout : Layouts()) {
          SCOPED_TRACE(Name(format) + " " + Name(layout) + " " + std::to_string(count));
          Buffer in(layout, count, format.planes), report(layout, count, GAUNT_REPORT_PLANES);
          for (size_t i = 0; i < count; ++i) {
            for (size_t p = 0; p < format.planes; ++p) in.Set(i, p, probes[format.planes * i + p]);
          }
          std::vector<uint8_t> packed(count * stride + 1, 0xEE), plain = packed;
          ASSERT_EQ(
              gaunt_probe_encode(format.id, count, in.view(), packed.data(), stride, report.view()),
              GAUNT_OK);
          ASSERT_EQ(gaunt_probe_encode(format.id, count, in.view(), plain.data(), stride, nullptr),
                    GAUNT_OK);
          EXPECT_EQ(packed, plain);
          EXPECT_EQ(packed.back(), 0xEE);
          ASSERT_TRUE(report.CanariesIntact());
          for (size_t i = 0; i < count; ++i) {
            const uint8_t* record = packed.data() + i * stride;
            const float* const f = &probes[format.planes * i];
            ExpectNearest(format, f, record);
            for (size_t b = format.bytes; b < stride; ++b) ASSERT_EQ(record[b], 0xEE);
            std::vector<double> wanted(f, f + format.planes), decoded;
            for (const auto& c : probe::ReadReference(format.id, record))
              decoded.push_back(c.value);
            double rms, bound;
            probe::ErrorReference(static_cast<int>(format.order), wanted.data(), decoded.data(),
                                  &rms, &bound);
            const double scale = *std::max_element(wanted.begin(), wanted.end());
            ASSERT_NEAR(report.Get(i, GAUNT_REPORT_RMS), rms, 1e-6 * scale);
            ASSERT_NEAR(report.Get(i, GAUNT_REPORT_MAX), bound, 1e-6 * scale);
          }
        }
      }
    }
  }
}

// Light of an order from a few directions, as formats are made for.
std::vector<float> MakeLight(Random& random, const Format& format) {
  std::vector<double> sum(format.planes, 0.0);
  const size_t size = format.planes / 3;
  for (size_t c = 0; c < 3; ++c) sum[c * size] = random.Between(0.1, 1.0);
  for (int light = 0; light < 3; ++light) {
    float d[3];
    random.Direction(d);
    const double direction[3] = {d[0], d[1], d[2]};
    std::vector<double> y(size);
    basis::EvalReference(static_cast<int>(format.order), direction, y.data());
    for (size_t c = 0; c < 3; ++c) {
      const double colour = random.Between(0.2, 0.6);
      for (size_t i = 0; i < size; ++i) sum[c * size + i] += colour * y[i];
    }
  }
  return {sum.begin(), sum.end()};
}

TEST_P(Probe, RefinementLowersTheErrorOfTheDecodedBytes) {
  Random random(14);
  constexpr size_t kCount = 37;
  for (const Format& format : AllFormats()) {
    SCOPED_TRACE(Name(format));
    const size_t stride = format.bytes + 3;
    for (const Layout layout : Layouts()) {
      Buffer in(layout, kCount, format.planes);
      for (size_t i = 0; i < kCount; ++i) {
        const std::vector<float> light = MakeLight(random, format);
        for (size_t p = 0; p < format.planes; ++p) in.Set(i, p, light[p]);
      }
      Buffer plain(layout, kCount, GAUNT_REPORT_PLANES),
          refined(layout, kCount, GAUNT_REPORT_PLANES);
      std::vector<uint8_t> packed(kCount * stride, 0xEE), silent = packed;
      ASSERT_EQ(
          gaunt_probe_encode(format.id, kCount, in.view(), packed.data(), stride, plain.view()),
          GAUNT_OK);
      ASSERT_EQ(gaunt_probe_encode_refined(format.id, kCount, in.view(), packed.data(), stride,
                                           refined.view()),
                GAUNT_OK);
      ASSERT_EQ(
          gaunt_probe_encode_refined(format.id, kCount, in.view(), silent.data(), stride, nullptr),
          GAUNT_OK);
      EXPECT_EQ(packed, silent);
      double before = 0.0, after = 0.0;
      for (size_t i = 0; i < kCount; ++i) {
        std::vector<double> wanted, decoded;
        for (size_t p = 0; p < format.planes; ++p) wanted.push_back(in.Get(i, p));
        for (const auto& c : probe::ReadReference(format.id, packed.data() + i * stride)) {
          decoded.push_back(c.value);
        }
        double rms, bound;
        probe::ErrorReference(static_cast<int>(format.order), wanted.data(), decoded.data(), &rms,
                              &bound);
        const double scale = *std::max_element(wanted.begin(), wanted.end());
        ASSERT_NEAR(refined.Get(i, GAUNT_REPORT_RMS), rms, 1e-6 * scale);
        ASSERT_NEAR(refined.Get(i, GAUNT_REPORT_MAX), bound, 1e-6 * scale);
        ASSERT_LE(rms, plain.Get(i, GAUNT_REPORT_RMS) + 1e-6 * scale);
        before += plain.Get(i, GAUNT_REPORT_RMS);
        after += rms;
        for (size_t b = format.bytes; b < stride; ++b) ASSERT_EQ(packed[i * stride + b], 0xEE);
      }
      const bool is_zonal =
          format.id == GAUNT_FORMAT_ZH3_16 || format.id == GAUNT_FORMAT_ZH3_LUMA_8;
      if (is_zonal) {
        EXPECT_LT(after, 0.99 * before);
      }
    }
  }
}

// Probes that no light makes, and those at the ends of the containers.
TEST_P(Probe, SurvivesExtremeProbes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const Format& format : AllFormats()) {
    const size_t size = format.planes / 3;
    for (const float mean :
         {0.0f,     -0.0f,    -1.0f,    nan,      inf,      -inf,     1e30f,  65408.0f, 65407.9f,
          65536.0f, 65504.0f, 65519.9f, 65520.0f, 65024.0f, 64512.0f, 1e-45f, 1e-38f,   5.9e-8f,
          2.9e-8f,  3.1e-8f,  6.1e-5f,  511.49f,  511.5f,   511.51f,  1.0f}) {
      for (const float ratio : {0.0f, 1.0f, -1.0f, 10.0f, nan, inf, -inf, 1e30f}) {
        std::vector<float> f(format.planes), decoded(format.planes);
        for (size_t p = 0; p < f.size(); ++p) f[p] = p % size == 0 ? mean : ratio;
        f[size] = 0.3f;  // and a channel of ordinary light beside
        std::vector<uint8_t> record(format.bytes);
        float report[GAUNT_REPORT_PLANES];
        gaunt_view in, vr, out;
        gaunt_view_interleaved(f.data(), format.planes, &in);
        gaunt_view_interleaved(report, GAUNT_REPORT_PLANES, &vr);
        gaunt_view_interleaved(decoded.data(), format.planes, &out);
        ASSERT_EQ(gaunt_probe_encode(format.id, 1, &in, record.data(), format.bytes, &vr),
                  GAUNT_OK);
        SCOPED_TRACE(testing::Message() << Name(format) << " mean " << mean << " ratio " << ratio);
        ExpectNearest(format, f.data(), record.data());
        for (const float value : report) EXPECT_FALSE(std::isnan(value));
        std::vector<uint8_t> refined(format.bytes);
        ASSERT_EQ(gaunt_probe_encode_refined(format.id, 1, &in, refined.data(), format.bytes, &vr),
                  GAUNT_OK);
        for (const float value : report) EXPECT_FALSE(std::isnan(value));
        ASSERT_EQ(gaunt_probe_decode(format.id, 1, refined.data(), format.bytes, &out), GAUNT_OK);
        for (const float value : decoded) EXPECT_TRUE(std::isfinite(value));
        ASSERT_EQ(gaunt_probe_decode(format.id, 1, record.data(), format.bytes, &out), GAUNT_OK);
        for (const float value : decoded) EXPECT_TRUE(std::isfinite(value));
      }
    }
  }
}

// Light from one direction is at the bounds: nothing is cut off, and what comes back is as near as the
// format's numbers are. Uniform light comes back as its mean.
TEST_P(Probe, HoldsDirectionalAndUniformLight) {
  Random random(17);
  for (const Format& format : AllFormats()) {
    const size_t size = format.planes / 3;
    for (int item = 0; item < 60; ++item) {
      SCOPED_TRACE(testing::Message() << Name(format) << " light " << item);
      float d[3] = {0.0f, 0.0f, 0.0f};
      if (item < 6) {
        d[item / 2] = item % 2 == 0 ? 1.0f : -1.0f;
      } else {
        random.Direction(d);
      }
      const double direction[3] = {d[0], d[1], d[2]};
      std::vector<double> y(size);
      basis::EvalReference(static_cast<int>(format.order), direction, y.data());
      std::vector<float> light(format.planes), decoded(format.planes);
      for (size_t c = 0; c < 3; ++c) {
        for (size_t i = 0; i < size; ++i) {
          const bool is_there = item >= 3 || i == 0;
          light[c * size + i] = is_there ? static_cast<float>(y[i]) : 0.0f;
        }
      }
      std::vector<uint8_t> record(format.bytes);
      float report[GAUNT_REPORT_PLANES];
      gaunt_view in, out, vr;
      gaunt_view_interleaved(light.data(), format.planes, &in);
      gaunt_view_interleaved(decoded.data(), format.planes, &out);
      gaunt_view_interleaved(report, GAUNT_REPORT_PLANES, &vr);
      ASSERT_EQ(gaunt_probe_encode(format.id, 1, &in, record.data(), format.bytes, &vr), GAUNT_OK);
      ASSERT_EQ(gaunt_probe_decode(format.id, 1, record.data(), format.bytes, &out), GAUNT_OK);
      // Unity's range of x y, y z and x z is 4.6 % below the bound.
      const bool clips = format.id == GAUNT_FORMAT_UNITY_L2_32;
      if (!clips) {
        EXPECT_EQ(report[GAUNT_REPORT_CLAMPED], 0.0f);
      }
      // White light has no colour, and ZH3 of one light is exact: all that is left is rounding. E does
      // not have band 3.
      for (size_t p = 0; p < format.planes; ++p) {
        const size_t i = p % size;
        if (i >= 9 && i < 16) continue;
        EXPECT_NEAR(decoded[p], light[p], (clips ? 0.06 : 0.02) * double{light[0]} * BandBound(i));
      }
    }
  }
}

// Squares of such errors are no floats.
TEST_P(Probe, ReportsErrorsOfAnySize) {
  Random random(16);
  for (const Format& format : AllFormats()) {
    for (const double scale : {1e35, 1e30, 2e19, 1.0, 1e-10, 1e-22, 3e-23, 1e-29}) {
      SCOPED_TRACE(testing::Message() << Name(format) << " of size " << scale);
      std::vector<float> f = MakeLight(random, format);
      for (float& value : f) value = static_cast<float>(scale * double{value});
      for (const auto encode : {gaunt_probe_encode, gaunt_probe_encode_refined}) {
        std::vector<uint8_t> record(format.bytes);
        float report[GAUNT_REPORT_PLANES];
        gaunt_view in, vr;
        gaunt_view_interleaved(f.data(), format.planes, &in);
        gaunt_view_interleaved(report, GAUNT_REPORT_PLANES, &vr);
        ASSERT_EQ(encode(format.id, 1, &in, record.data(), format.bytes, &vr), GAUNT_OK);
        std::vector<double> wanted(f.begin(), f.end()), decoded;
        for (const auto& c : probe::ReadReference(format.id, record.data())) {
          decoded.push_back(c.value);
        }
        double rms, bound;
        probe::ErrorReference(static_cast<int>(format.order), wanted.data(), decoded.data(), &rms,
                              &bound);
        const double tolerance = 1e-6 * *std::max_element(wanted.begin(), wanted.end());
        ASSERT_NEAR(report[GAUNT_REPORT_RMS], rms, tolerance);
        ASSERT_NEAR(report[GAUNT_REPORT_MAX], bound, tolerance);
      }
    }
  }
}

TEST_P(Probe, NeverWritesTheLeastByte) {
  Random random(5);
  const Format format = AllFormats()[GAUNT_FORMAT_SH3_28 - 1];
  const std::vector<uint8_t> packed = MakeRecords(random, format, 300, 28);
  for (size_t b = 0; b < packed.size(); ++b) {
    if (b % 28 >= 4) {
      EXPECT_NE(packed[b], 0x80);
    }
  }
}

TEST_P(Probe, ReportsWhatTheRangeCutsOff) {
  float f[27] = {}, report[3];
  gaunt_view in, vr;
  gaunt_view_interleaved(f, 27, &in);
  gaunt_view_interleaved(report, 3, &vr);
  uint8_t record[28];
  f[0] = f[9] = f[18] = 1.0f;
  f[1] = 1.7f;  // within sqrt(3)
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &in, record, 28, &vr), GAUNT_OK);
  EXPECT_EQ(report[GAUNT_REPORT_CLAMPED], 0.0f);
  f[1] = 1.9f;
  f[9] = -2.0f;
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &in, record, 28, &vr), GAUNT_OK);
  EXPECT_EQ(report[GAUNT_REPORT_CLAMPED], 2.0f);
}

// Against the definition, with every number of taps, some of which have no probe.
TEST_P(Probe, GathersEveryFormatNumberOfTapsAndLayout) {
  Random random(6);
  constexpr size_t kProbes = 50;
  for (const Format& format : AllFormats()) {
    const size_t stride = format.bytes + (format.id % 2 == 0 ? 5 : 0);
    const std::vector<uint8_t> packed = MakeRecords(random, format, kProbes, stride);
    for (const uint32_t taps : {1u, 2u, 4u, 7u, 8u, 9u, 16u, 19u}) {
      for (const size_t count : {0, 1, 3, 8, 15, 16, 17, 33, 75}) {
        std::vector<uint32_t> indices(count * taps);
        std::vector<float> weights(count * taps);
        for (uint32_t& index : indices) index = static_cast<uint32_t>(random.Bits() % kProbes);
        for (float& weight : weights) weight = random.Between(-0.2, 1.0);
        for (size_t k = 3; count != 33 && k < indices.size(); k += 5) {
          indices[k] = k % 2 == 0 ? GAUNT_NO_PROBE : static_cast<uint32_t>(kProbes);
          weights[k] = std::numeric_limits<float>::infinity();  // contributes nothing all the same
        }
        for (uint32_t n_out = 1; n_out <= format.order; ++n_out) {
          for (const Layout layout : {Layout::kPlanar, Layout::kTiled, Layout::kInterleaved,
                                      Layout::kOddTiles, Layout::kRecord}) {
            SCOPED_TRACE(Name(format) + " " + Name(layout) + " taps " + std::to_string(taps) +
                         " count " + std::to_string(count) + " order " + std::to_string(n_out));
            Buffer out(layout, count, 3 * n_out * n_out);
            ASSERT_EQ(
                gaunt_probe_gather(format.id, n_out, count, taps, indices.data(), weights.data(),
                                   packed.data(), kProbes, stride, out.view()),
                GAUNT_OK);
            ASSERT_TRUE(out.CanariesIntact());
            if (layout != Layout::kTiled && count != 17) continue;
            for (size_t i = 0; i < count; ++i) {
              const std::vector<double> wanted =
                  probe::GatherReference(format.id, taps, &indices[i * taps], &weights[i * taps],
                                         packed.data(), kProbes, stride);
              double tolerance = 0.0;
              for (size_t t = 0; t < taps; ++t) {
                if (indices[i * taps + t] >= kProbes) continue;
                double largest = 0.0;
                for (const auto& c : probe::ReadReference(
                         format.id, packed.data() + indices[i * taps + t] * stride)) {
                  largest = std::max(largest, std::abs(c.value));
                }
                tolerance += 1e-6 * std::abs(double{weights[i * taps + t]}) * largest;
              }
              for (size_t c = 0; c < 3; ++c) {
                for (size_t k = 0; k < n_out * n_out; ++k) {
                  ASSERT_NEAR(out.Get(i, c * n_out * n_out + k),
                              wanted[format.order * format.order * c + k], tolerance);
                }
              }
            }
          }
        }
      }
    }
  }
}

// Every format to every other, alone and blended, is decoding, blending and encoding.
TEST_P(Probe, TranscodesBetweenAllFormats) {
  Random random(15);
  constexpr size_t kCount = 37;
  for (const Format& from : AllFormats()) {
    const size_t stride_a = from.bytes + 1, stride_b = from.bytes + 2;
    const std::vector<uint8_t> a = MakeRecords(random, from, kCount, stride_a);
    const std::vector<uint8_t> b = MakeRecords(random, from, kCount, stride_b);
    for (const Format& to : AllFormats()) {
      for (const float t : {0.0f, 0.3f, 1.0f}) {
        const bool blends = t != 0.0f;
        Buffer fa(Layout::kPlanar, kCount, from.planes), fb(Layout::kPlanar, kCount, from.planes);
        Buffer wanted(Layout::kPlanar, kCount, to.planes);
        ASSERT_EQ(gaunt_probe_decode(from.id, kCount, a.data(), stride_a, fa.view()), GAUNT_OK);
        ASSERT_EQ(gaunt_probe_decode(from.id, kCount, b.data(), stride_b, fb.view()), GAUNT_OK);
        if (blends) {
          float share = t;
          gaunt_view vt;
          gaunt_view_broadcast(&share, &vt);
          ASSERT_EQ(gaunt_sh_blend(from.order, 3, kCount, fa.view(), fb.view(), &vt, fa.view()),
                    GAUNT_OK);
        }
        const size_t from_size = from.planes / 3, to_size = to.planes / 3;
        for (size_t i = 0; i < kCount; ++i) {
          for (size_t p = 0; p < to.planes; ++p) {
            const size_t c = p / to_size, k = p % to_size;
            wanted.Set(i, p, k < from_size ? fa.Get(i, c * from_size + k) : 0.0f);
          }
        }
        const size_t stride = to.bytes + 3;
        std::vector<uint8_t> packed(kCount * stride, 0xEE), expected = packed;
        ASSERT_EQ(
            gaunt_probe_encode(to.id, kCount, wanted.view(), expected.data(), stride, nullptr),
            GAUNT_OK);
        ASSERT_EQ(gaunt_probe_transcode(from.id, to.id, kCount, a.data(), stride_a,
                                        blends ? b.data() : nullptr, blends ? stride_b : 0, t,
                                        packed.data(), stride),
                  GAUNT_OK);
        ASSERT_EQ(packed, expected) << Name(from) << " to " << Name(to) << " t " << t;
      }
    }
  }
}

TEST_P(Probe, TranscodingRejectsWrongArguments) {
  std::vector<uint8_t> a(8 * 28), b(8 * 28), packed(8 * 28, 0xEE);
  const std::vector<uint8_t> before = packed;
  const uint32_t f = GAUNT_FORMAT_SH3_28;
  const auto transcode = gaunt_probe_transcode;
  uint8_t *pa = a.data(), *pb = b.data(), *to = packed.data();
  EXPECT_EQ(transcode(0, f, 8, pa, 28, pb, 28, 0.5f, to, 28), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(transcode(f, kFormats + 1, 8, pa, 28, pb, 28, 0.5f, to, 28), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(transcode(f, f, 8, pa, 27, pb, 28, 0.5f, to, 28), GAUNT_ERROR_RANGE);
  EXPECT_EQ(transcode(f, f, 8, pa, 28, pb, 27, 0.5f, to, 28), GAUNT_ERROR_RANGE);
  EXPECT_EQ(transcode(f, f, 8, pa, 28, pb, 28, 0.5f, to, 27), GAUNT_ERROR_RANGE);
  EXPECT_EQ(transcode(f, f, 8, nullptr, 28, pb, 28, 0.5f, to, 28), GAUNT_ERROR_NULL);
  EXPECT_EQ(transcode(f, f, 8, pa, 28, pb, 28, 0.5f, nullptr, 28), GAUNT_ERROR_NULL);
  EXPECT_EQ(transcode(f, f, 8, pa, 28, pb, 28, 0.5f, pa, 28), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(transcode(f, f, 8, pa, 28, pb, 28, 0.5f, pb + 1, 28), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(packed, before);
  EXPECT_EQ(transcode(f, f, 0, nullptr, 28, nullptr, 0, 0.5f, nullptr, 28), GAUNT_OK);
}

TEST_P(Probe, GatherOfNothingIsBlack) {
  const uint32_t indices[8] = {GAUNT_NO_PROBE, 1, 2, 3, 4, 5, 6, 7};
  const float weights[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  Buffer out(Layout::kPlanar, 1, 27);
  ASSERT_EQ(gaunt_probe_gather(GAUNT_FORMAT_SH3_28, 3, 1, 8, indices, weights, nullptr, 0, 28,
                               out.view()),
            GAUNT_OK);
  for (size_t p = 0; p < 27; ++p) EXPECT_EQ(out.Get(0, p), 0.0f);
}

TEST_P(Probe, RejectsWrongArguments) {
  uint8_t packed[10 * 32] = {};
  const std::vector<uint8_t> before(packed, packed + sizeof(packed));
  const uint32_t indices[8 * 8] = {};
  const float weights[8 * 8] = {};
  constexpr uint32_t kFormat = GAUNT_FORMAT_SH3_28;
  Buffer coefficients(Layout::kInterleaved, 8, 27), report(Layout::kInterleaved, 8, 3);
  const std::vector<float> memory = coefficients.memory();
  const gaunt_view* v = coefficients.view();

  EXPECT_EQ(gaunt_probe_encode(0, 8, v, packed, 28, nullptr), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_probe_encode(99, 0, nullptr, nullptr, 28, nullptr), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 0, nullptr, nullptr, 28, nullptr), GAUNT_OK);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, v, packed, 27, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, nullptr, packed, 28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, v, nullptr, 28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, v, v->data, 28, nullptr), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, v, packed, 28, v), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_probe_encode(kFormat, 8, v, packed, SIZE_MAX / 2, nullptr), GAUNT_ERROR_RANGE);

  EXPECT_EQ(gaunt_probe_encode_refined(0, 8, v, packed, 28, nullptr), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_probe_encode_refined(kFormat, 8, v, packed, 27, nullptr), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_probe_encode_refined(kFormat, 8, nullptr, packed, 28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_probe_encode_refined(kFormat, 8, v, v->data, 28, nullptr), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_probe_encode_refined(kFormat, 0, nullptr, nullptr, 28, nullptr), GAUNT_OK);

  EXPECT_EQ(gaunt_probe_decode(kFormats + 1, 8, packed, 28, v), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_probe_decode(kFormat, 0, nullptr, 28, nullptr), GAUNT_OK);
  EXPECT_EQ(gaunt_probe_decode(kFormat, 8, packed, 0, v), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_probe_decode(kFormat, 8, nullptr, 28, v), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_probe_decode(kFormat, 8, packed, 28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_probe_decode(kFormat, 8, v->data, 28, v), GAUNT_ERROR_OVERLAP);

  const auto gather = [&](uint32_t format, uint32_t n_out, size_t count, uint32_t taps,
                          const uint32_t* index, const float* weight, const void* records,
                          size_t stride, const gaunt_view* out) {
    return gaunt_probe_gather(format, n_out, count, taps, index, weight, records, 10, stride, out);
  };
  EXPECT_EQ(gather(55, 3, 8, 8, indices, weights, packed, 28, v), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gather(kFormat, 0, 8, 8, indices, weights, packed, 28, v), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gather(kFormat, 4, 8, 8, indices, weights, packed, 28, v), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gather(kFormat, 3, 8, 0, indices, weights, packed, 28, v), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gather(kFormat, 3, 8, 65537, indices, weights, packed, 28, v), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gather(kFormat, 3, SIZE_MAX / 4, 8, indices, weights, packed, 28, v),
            GAUNT_ERROR_RANGE);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, indices, weights, packed, 27, v), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, nullptr, weights, packed, 28, v), GAUNT_ERROR_NULL);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, indices, nullptr, packed, 28, v), GAUNT_ERROR_NULL);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, indices, weights, nullptr, 28, v), GAUNT_ERROR_NULL);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, indices, weights, packed, 28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gather(kFormat, 3, 8, 8, indices, v->data, packed, 28, v), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gather(kFormat, 3, 0, 8, nullptr, nullptr, nullptr, 28, nullptr), GAUNT_OK);

  EXPECT_EQ(std::memcmp(memory.data(), coefficients.memory().data(), memory.size() * 4), 0);
  EXPECT_EQ(std::memcmp(before.data(), packed, sizeof(packed)), 0);
}

TEST(ProbeFormat, DescribesItself) {
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  const auto expect = [&](uint32_t format, uint32_t bytes, uint32_t order) {
    ASSERT_EQ(gaunt_format_info(format, &properties), GAUNT_OK);
    EXPECT_EQ(properties.bytes, bytes);
    EXPECT_EQ(properties.order, order);
    EXPECT_EQ(properties.planes, 3 * order * order);
  };
  expect(GAUNT_FORMAT_SH3_28, 28, 3);
  expect(GAUNT_FORMAT_SH2_13, 13, 2);
  expect(GAUNT_FORMAT_SH3_32, 32, 3);
  expect(GAUNT_FORMAT_SH5_55, 55, 5);
  expect(GAUNT_FORMAT_SH3_F16, 54, 3);
  expect(GAUNT_FORMAT_SH3_F32, 108, 3);
  expect(GAUNT_FORMAT_UNREAL_28, 28, 3);
  expect(GAUNT_FORMAT_UNITY_L1_16, 16, 2);
  expect(GAUNT_FORMAT_UNITY_L2_32, 32, 3);
  expect(GAUNT_FORMAT_RGB9E5, 4, 1);
  expect(GAUNT_FORMAT_R11G11B10F, 4, 1);
  EXPECT_EQ(gaunt_format_info(GAUNT_FORMAT_SH3_28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_format_info(0, &properties), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_format_info(kFormats + 1, &properties), GAUNT_ERROR_FORMAT);
  properties.struct_size = 3;
  EXPECT_EQ(gaunt_format_info(GAUNT_FORMAT_SH3_28, &properties), GAUNT_ERROR_STRUCT);
}

// Bytes of values that can be worked out by hand.
TEST(ProbeFormat, IsWhatTheManualSays) {
  float f[27] = {};
  gaunt_view view;
  gaunt_view_interleaved(f, 27, &view);
  for (size_t c = 0; c < 3; ++c) f[9 * c] = 1.0f;
  f[1] = std::sqrt(3.0f);            // R
  f[9 + 6] = -std::sqrt(5.0f) / 2;   // G
  f[18 + 8] = std::sqrt(15.0f) / 2;  // B
  uint8_t record[28];
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &view, record, 28, nullptr), GAUNT_OK);
  uint32_t word;
  std::memcpy(&word, record, 4);
  EXPECT_EQ(word, 256u | 256u << 9 | 256u << 18 | 16u << 27);
  EXPECT_EQ(record[4], 127);
  EXPECT_EQ(record[4 + 8 + 5], 256 - 64);  // -63.5, ties to even
  EXPECT_EQ(record[4 + 16 + 7], 127);
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_UNREAL_28, 1, &view, record, 28, nullptr), GAUNT_OK);
  std::memcpy(&word, record, 4);
  EXPECT_EQ(word, 15u << 6 | 15u << 17 | 15u << 27);
  EXPECT_EQ(record[4 + 2], 255);           // red of the first layer of R: i = 1
  EXPECT_EQ(record[4 + 8 + 4 + 1], 96);    // green of the second of G: i = 6, -1/4 of the range
  EXPECT_EQ(record[4 + 16 + 4 + 3], 191);  // alpha of the second of B: i = 8
}

// E/pi of a Unity record, evaluated as its shaders do, is that of the coefficients.
TEST(ProbeFormat, UnityPolynomialsAreIrradiance) {
  Random random(9);
  const Format format = AllFormats()[GAUNT_FORMAT_UNITY_L2_32 - 1];
  const std::vector<uint8_t> packed = MakeRecords(random, format, 20, 32);
  for (size_t k = 0; k < 20; ++k) {
    const uint8_t* const record = &packed[32 * k];
    float f[27], out[3], n[3] = {0.48f, -0.6f, 0.64f};
    gaunt_view vf, vn, vo;
    gaunt_view_interleaved(f, 27, &vf);
    gaunt_view_interleaved(n, 3, &vn);
    gaunt_view_interleaved(out, 3, &vo);
    ASSERT_EQ(gaunt_probe_decode(GAUNT_FORMAT_UNITY_L2_32, 1, record, 32, &vf), GAUNT_OK);
    ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, 1, &vf, &vn, &vo), GAUNT_OK);
    const double l0 = f[9] / std::sqrt(4.0 * std::acos(-1.0));  // of green
    const auto linear = [&](size_t b) { return (record[b] / 255.0 - 0.5) * 4.0 * l0; };
    const auto square = [&](size_t b) { return (record[b] / 255.0 - 0.5) * 3.5777088 * l0; };
    const double x = n[0], y = n[1], z = n[2];
    const double e = l0 + linear(8) * x + linear(9) * y + linear(10) * z + square(20) * x * y +
                     square(21) * y * z + square(22) * (3 * z * z - 1) + square(23) * x * z +
                     square(29) * (x * x - y * y);
    EXPECT_NEAR(out[1], e, 1e-5 * l0);
  }
}

TEST(ProbeBits, AreTheSameOnTargetsOfAClass) {
  constexpr size_t kCount = 70;
  for (const Format& format : AllFormats()) {
    SCOPED_TRACE(Name(format));
    Random random(8);
    const std::vector<uint8_t> packed = MakeRecords(random, format, kCount, format.bytes);
    std::vector<uint32_t> indices(kCount * 8);
    std::vector<float> weights(kCount * 8), probes = MakeProbes(random, format, kCount);
    for (uint32_t& index : indices) index = static_cast<uint32_t>(random.Bits() % kCount);
    random.Fill(weights.data(), weights.size(), 0.0, 1.0);
    std::vector<float> first[2];
    std::vector<uint8_t> first_bytes;
    for (const std::string& target : SupportedTargets()) {
      SCOPED_TRACE(target);
      ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
      std::vector<float> out(kCount * format.planes);
      std::vector<uint8_t> bytes(kCount * format.bytes);
      gaunt_view vo, vp;
      gaunt_view_interleaved(out.data(), format.planes, &vo);
      gaunt_view_interleaved(probes.data(), format.planes, &vp);
      ASSERT_EQ(gaunt_probe_gather(format.id, format.order, kCount, 8, indices.data(),
                                   weights.data(), packed.data(), kCount, format.bytes, &vo),
                GAUNT_OK);
      ASSERT_EQ(gaunt_probe_encode(format.id, kCount, &vp, bytes.data(), format.bytes, nullptr),
                GAUNT_OK);
      std::vector<float>& wanted = first[HasFma(target) ? 1 : 0];
      if (wanted.empty()) wanted = out;
      EXPECT_EQ(std::memcmp(wanted.data(), out.data(), out.size() * sizeof(float)), 0);
      // Encoding fuses nothing, so its bytes are the same everywhere.
      if (first_bytes.empty()) first_bytes = bytes;
      EXPECT_EQ(first_bytes, bytes);
    }
  }
  gaunt_target_select(nullptr);
}

GAUNT_INSTANTIATE_TARGETS(Probe);

}  // namespace
}  // namespace gaunt::test
