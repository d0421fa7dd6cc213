// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "gaunt/gaunt.h"
#include "probe/probe_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr size_t kBytes = 28;

double Bound(size_t i) {
  return i == 0 ? 1.0 : i < 4 ? std::sqrt(3.0) : i == 6 ? std::sqrt(5.0) : std::sqrt(15.0) / 2.0;
}

// Radiance as probes have it: within the bounds of non-negative light, over many magnitudes.
void MakeProbe(Random& random, float* f) {
  const double scale = std::pow(10.0, random.Between(-4.0, 4.0));
  for (size_t c = 0; c < 3; ++c) {
    f[9 * c] = static_cast<float>(scale * random.Between(0.1, 1.0));
    for (size_t i = 1; i < 9; ++i) {
      f[9 * c + i] = static_cast<float>(f[9 * c] * Bound(i) * random.Between(-1.0, 1.0));
    }
  }
}

std::vector<uint8_t> MakeRecords(Random& random, size_t count, size_t stride) {
  std::vector<uint8_t> packed(count * stride, 0xEE);
  for (size_t i = 0; i < count; ++i) {
    float f[27];
    MakeProbe(random, f);
    double wanted[27];
    std::copy(f, f + 27, wanted);
    probe::EncodeReference(wanted, packed.data() + i * stride);
  }
  return packed;
}

class Probe : public TargetTest {};

TEST_P(Probe, DecodesEveryLayoutAndStride) {
  Random random(1);
  for (const size_t stride : {size_t{28}, size_t{29}, size_t{32}, size_t{64}}) {
    for (const size_t count : {0, 1, 3, 7, 8, 9, 31, 32, 33, 70}) {
      const std::vector<uint8_t> packed = MakeRecords(random, count, stride);
      for (const Layout layout : Layouts()) {
        SCOPED_TRACE(Name(layout) + " " + std::to_string(count));
        Buffer out(layout, count, 27);
        ASSERT_EQ(gaunt_probe_decode(GAUNT_FORMAT_SH3_28, count, packed.data(), stride, out.view()),
                  GAUNT_OK);
        ASSERT_TRUE(out.CanariesIntact());
        for (size_t i = 0; i < count; ++i) {
          double wanted[27];
          probe::DecodeReference(packed.data() + i * stride, wanted);
          for (size_t p = 0; p < 27; ++p) {
            ASSERT_NEAR(out.Get(i, p), wanted[p], 2.4e-7 * wanted[p / 9 * 9] * Bound(p % 9));
          }
        }
      }
    }
  }
}

// Records end where their memory ends: a sanitizer sees any byte read beyond.
TEST_P(Probe, ReadsNothingBeyondTheLastRecord) {
  Random random(2);
  for (size_t count = 1; count < 20; ++count) {
    const std::vector<uint8_t> records = MakeRecords(random, count, kBytes);
    const std::unique_ptr<uint8_t[]> packed(new uint8_t[records.size()]);
    std::copy(records.begin(), records.end(), packed.get());
    Buffer out(Layout::kPlanar, count, 27);
    EXPECT_EQ(gaunt_probe_decode(GAUNT_FORMAT_SH3_28, count, packed.get(), kBytes, out.view()),
              GAUNT_OK);
  }
}

TEST_P(Probe, DecodesAnyBytesToFiniteValues) {
  Random random(3);
  std::vector<uint8_t> packed(200 * kBytes);
  for (uint8_t& byte : packed) byte = static_cast<uint8_t>(random.Bits());
  Buffer out(Layout::kTiled, 200, 27);
  ASSERT_EQ(gaunt_probe_decode(GAUNT_FORMAT_SH3_28, 200, packed.data(), kBytes, out.view()),
            GAUNT_OK);
  for (size_t i = 0; i < 200; ++i) {
    double wanted[27];
    probe::DecodeReference(packed.data() + i * kBytes, wanted);
    for (size_t p = 0; p < 27; ++p) {
      ASSERT_TRUE(std::isfinite(out.Get(i, p)));
      ASSERT_NEAR(out.Get(i, p), wanted[p], 2.5e-7 * wanted[p / 9 * 9] * Bound(p % 9));
    }
  }
}

void ExpectEncodesLikeReference(const float* f, const uint8_t* record) {
  double wanted[27];
  std::copy(f, f + 27, wanted);
  uint8_t reference[kBytes];
  probe::EncodeReference(wanted, reference);
  ASSERT_EQ(std::memcmp(record, reference, 4), 0) << "means";
  double decoded[27];
  probe::DecodeReference(reference, decoded);
  for (size_t c = 0; c < 3; ++c) {
    for (size_t i = 1; i < 9; ++i) {
      const int q = static_cast<int8_t>(record[4 + 8 * c + i - 1]);
      const double mean = decoded[9 * c];
      double exact = mean > 0.0 ? 127.0 * wanted[9 * c + i] / (mean * Bound(i)) : 0.0;
      if (std::isnan(exact)) exact = 0.0;
      exact = std::max(-127.0, std::min(exact, 127.0));
      ASSERT_LE(std::abs(q - exact), 0.5001) << "channel " << c << " coefficient " << i;
    }
  }
}

TEST_P(Probe, EncodesToNearestInEveryLayout) {
  Random random(4);
  for (const size_t stride : {size_t{28}, size_t{32}}) {
    for (const size_t count : {0, 1, 3, 15, 16, 17, 31, 32, 33, 70}) {
      std::vector<float> probes(count * 27);
      for (size_t i = 0; i < count; ++i) MakeProbe(random, probes.data() + 27 * i);
      for (const Layout layout : Layouts()) {
        Buffer in(layout, count, 27), report(layout, count, GAUNT_REPORT_PLANES);
        for (size_t i = 0; i < count; ++i) {
          for (size_t p = 0; p < 27; ++p) in.Set(i, p, probes[27 * i + p]);
        }
        std::vector<uint8_t> packed(count * stride + 1, 0xEE), plain = packed;
        ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, count, in.view(), packed.data(), stride,
                                     report.view()),
                  GAUNT_OK);
        ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, count, in.view(), plain.data(), stride,
                                     nullptr),
                  GAUNT_OK);
        EXPECT_EQ(packed, plain);
        EXPECT_EQ(packed.back(), 0xEE);
        ASSERT_TRUE(report.CanariesIntact());
        for (size_t i = 0; i < count; ++i) {
          const uint8_t* record = packed.data() + i * stride;
          ExpectEncodesLikeReference(probes.data() + 27 * i, record);
          for (size_t b = kBytes; b < stride; ++b) ASSERT_EQ(record[b], 0xEE);
          double wanted[27], decoded[27], rms, bound;
          std::copy(probes.begin() + static_cast<ptrdiff_t>(27 * i),
                    probes.begin() + static_cast<ptrdiff_t>(27 * i + 27), wanted);
          probe::DecodeReference(record, decoded);
          probe::ErrorReference(wanted, decoded, &rms, &bound);
          const double scale = std::max({wanted[0], wanted[9], wanted[18]});
          ASSERT_NEAR(report.Get(i, GAUNT_REPORT_RMS), rms, 1e-6 * scale);
          ASSERT_NEAR(report.Get(i, GAUNT_REPORT_MAX), bound, 1e-6 * scale);
        }
      }
    }
  }
}

// Probes that no light makes, and those at the ends of the format.
TEST_P(Probe, SurvivesExtremeProbes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const float mean : {0.0f, -0.0f, -1.0f, nan, inf, -inf, 1e30f, 65408.0f, 65407.9f, 65536.0f,
                           1e-45f, 1e-38f, 5.9e-8f, 2.9e-8f, 511.49f, 511.5f, 511.51f, 1.0f}) {
    for (const float ratio : {0.0f, 1.0f, -1.0f, 10.0f, nan, inf, -inf, 1e30f}) {
      float f[27];
      for (size_t p = 0; p < 27; ++p) f[p] = p % 9 == 0 ? mean : ratio;
      f[9] = 0.3f;  // and a channel of ordinary light beside
      uint8_t record[kBytes];
      float report[GAUNT_REPORT_PLANES], decoded[27];
      gaunt_view in, vr, out;
      gaunt_view_interleaved(f, 27, &in);
      gaunt_view_interleaved(report, GAUNT_REPORT_PLANES, &vr);
      gaunt_view_interleaved(decoded, 27, &out);
      ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &in, record, kBytes, &vr), GAUNT_OK);
      SCOPED_TRACE(testing::Message() << "mean " << mean << " ratio " << ratio);
      ExpectEncodesLikeReference(f, record);
      for (size_t b = 4; b < kBytes; ++b) EXPECT_NE(record[b], 0x80);
      for (const float value : report) EXPECT_FALSE(std::isnan(value));
      ASSERT_EQ(gaunt_probe_decode(GAUNT_FORMAT_SH3_28, 1, record, kBytes, &out), GAUNT_OK);
      for (const float value : decoded) EXPECT_TRUE(std::isfinite(value));
    }
  }
}

TEST_P(Probe, ReportsWhatTheRangeCutsOff) {
  float f[27] = {}, report[3];
  gaunt_view in, vr;
  gaunt_view_interleaved(f, 27, &in);
  gaunt_view_interleaved(report, 3, &vr);
  uint8_t record[kBytes];
  f[0] = f[9] = f[18] = 1.0f;
  f[1] = 1.7f;  // within sqrt(3)
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &in, record, kBytes, &vr), GAUNT_OK);
  EXPECT_EQ(report[GAUNT_REPORT_CLAMPED], 0.0f);
  f[1] = 1.9f;
  f[9] = -2.0f;
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, 1, &in, record, kBytes, &vr), GAUNT_OK);
  EXPECT_EQ(report[GAUNT_REPORT_CLAMPED], 2.0f);
}

// gather(0.25 a + 0.75 b) and so on, against the definition.
TEST_P(Probe, GathersEveryNumberOfTapsAndLayout) {
  Random random(6);
  constexpr size_t kProbes = 50;
  for (const size_t stride : {size_t{28}, size_t{33}}) {
    const std::vector<uint8_t> packed = MakeRecords(random, kProbes, stride);
    for (const uint32_t taps : {1u, 2u, 4u, 7u, 8u, 9u, 16u, 19u}) {
      for (const size_t count : {0, 1, 3, 7, 8, 9, 31, 32, 33, 75}) {
        std::vector<uint32_t> indices(count * taps);
        std::vector<float> weights(count * taps);
        for (uint32_t& index : indices) index = static_cast<uint32_t>(random.Bits() % kProbes);
        for (float& weight : weights) weight = random.Between(-0.2, 1.0);
        for (size_t k = 3; k < indices.size(); k += 5) {
          indices[k] = k % 2 == 0 ? GAUNT_NO_PROBE : static_cast<uint32_t>(kProbes);
          weights[k] = std::numeric_limits<float>::infinity();  // contributes nothing all the same
        }
        for (uint32_t n_out = 1; n_out <= 3; ++n_out) {
          for (const Layout layout : {Layout::kPlanar, Layout::kTiled, Layout::kInterleaved,
                                      Layout::kOddTiles, Layout::kRecord}) {
            SCOPED_TRACE(Name(layout) + " taps " + std::to_string(taps) + " count " +
                         std::to_string(count));
            Buffer out(layout, count, 3 * n_out * n_out);
            ASSERT_EQ(
                gaunt_probe_gather(GAUNT_FORMAT_SH3_28, n_out, count, taps, indices.data(),
                                   weights.data(), packed.data(), kProbes, stride, out.view()),
                GAUNT_OK);
            ASSERT_TRUE(out.CanariesIntact());
            for (size_t i = 0; i < count; ++i) {
              double wanted[27], tolerance = 0.0;
              probe::GatherReference(taps, &indices[i * taps], &weights[i * taps], packed.data(),
                                     kProbes, stride, wanted);
              for (size_t t = 0; t < taps; ++t) {
                if (indices[i * taps + t] >= kProbes) continue;
                double probe[27];
                probe::DecodeReference(packed.data() + indices[i * taps + t] * stride, probe);
                double largest = 0.0;
                for (const double f : probe) largest = std::max(largest, std::abs(f));
                tolerance += 1e-6 * std::abs(double{weights[i * taps + t]}) * largest;
              }
              for (size_t c = 0; c < 3; ++c) {
                for (size_t k = 0; k < n_out * n_out; ++k) {
                  ASSERT_NEAR(out.Get(i, c * n_out * n_out + k), wanted[9 * c + k], tolerance);
                }
              }
            }
          }
        }
      }
    }
  }
}

TEST_P(Probe, GatherOfNothingIsBlack) {
  const uint32_t indices[8] = {GAUNT_NO_PROBE, 1, 2, 3, 4, 5, 6, 7};
  const float weights[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  Buffer out(Layout::kPlanar, 1, 27);
  ASSERT_EQ(gaunt_probe_gather(GAUNT_FORMAT_SH3_28, 3, 1, 8, indices, weights, nullptr, 0, kBytes,
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

  EXPECT_EQ(gaunt_probe_decode(2, 8, packed, 28, v), GAUNT_ERROR_FORMAT);
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
  EXPECT_EQ(gather(5, 3, 8, 8, indices, weights, packed, 28, v), GAUNT_ERROR_FORMAT);
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
  ASSERT_EQ(gaunt_format_info(GAUNT_FORMAT_SH3_28, &properties), GAUNT_OK);
  EXPECT_EQ(properties.bytes, 28u);
  EXPECT_EQ(properties.order, 3u);
  EXPECT_EQ(properties.planes, 27u);
  EXPECT_EQ(gaunt_format_info(GAUNT_FORMAT_SH3_28, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_format_info(77, &properties), GAUNT_ERROR_FORMAT);
  properties.struct_size = 3;
  EXPECT_EQ(gaunt_format_info(GAUNT_FORMAT_SH3_28, &properties), GAUNT_ERROR_STRUCT);
}

TEST(ProbeBits, AreTheSameOnTargetsOfAClass) {
  Random random(8);
  constexpr size_t kCount = 70;
  const std::vector<uint8_t> packed = MakeRecords(random, kCount, kBytes);
  std::vector<uint32_t> indices(kCount * 8);
  std::vector<float> weights(kCount * 8), probes(kCount * 27);
  for (uint32_t& index : indices) index = static_cast<uint32_t>(random.Bits() % kCount);
  random.Fill(weights.data(), weights.size(), 0.0, 1.0);
  for (size_t i = 0; i < kCount; ++i) MakeProbe(random, probes.data() + 27 * i);
  std::vector<float> first[2];
  std::vector<uint8_t> first_bytes;
  for (const std::string& target : SupportedTargets()) {
    SCOPED_TRACE(target);
    ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    std::vector<float> out(kCount * 27);
    std::vector<uint8_t> bytes(kCount * kBytes);
    gaunt_view vo, vp;
    gaunt_view_interleaved(out.data(), 27, &vo);
    gaunt_view_interleaved(probes.data(), 27, &vp);
    ASSERT_EQ(gaunt_probe_gather(GAUNT_FORMAT_SH3_28, 3, kCount, 8, indices.data(), weights.data(),
                                 packed.data(), kCount, kBytes, &vo),
              GAUNT_OK);
    ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_SH3_28, kCount, &vp, bytes.data(), kBytes, nullptr),
              GAUNT_OK);
    std::vector<float>& wanted = first[HasFma(target) ? 1 : 0];
    if (wanted.empty()) wanted = out;
    EXPECT_EQ(std::memcmp(wanted.data(), out.data(), out.size() * sizeof(float)), 0);
    // Encoding fuses nothing, so its bytes are the same everywhere.
    if (first_bytes.empty()) first_bytes = bytes;
    EXPECT_EQ(first_bytes, bytes);
  }
  gaunt_target_select(nullptr);
}

GAUNT_INSTANTIATE_TARGETS(Probe);

}  // namespace
}  // namespace gaunt::test
