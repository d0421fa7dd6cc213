// SPDX-License-Identifier: MIT
// Files of packed probes, against their description in docs/probe_file.md and against the library.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bad_input.h"
#include "format_name.h"
#include "gaunt/gaunt.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"
#include "volume/convert.h"
#include "volume/pipeline.h"

namespace gaunt::test {
namespace {

namespace fs = std::filesystem;
using tool::BadInput;
using tool::ConvertJob;
using tool::ConvertSummary;
using tool::EncodingOfFloats;
using tool::EncodingOfFormat;
using tool::ProbeEncoding;
using tool::ProbeFileGrid;

const double kPi = std::acos(-1.0);
constexpr size_t kBlock = 4096;  // probes, by the description of the file
constexpr size_t kHeader = 68;

std::vector<uint32_t> AllFormats() {
  std::vector<uint32_t> formats;
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  for (uint32_t f = 1; gaunt_format_info(f, &properties) == GAUNT_OK; ++f) formats.push_back(f);
  return formats;
}

// ---- files by their description

// By the definition: the polynomial 0xedb88320, bits reflected, all inverted before and after.
class Crc32 {
 public:
  Crc32& Add(const std::string& bytes) {
    for (const char byte : bytes) {
      value_ ^= static_cast<uint8_t>(byte);
      for (int k = 0; k < 8; ++k) value_ = value_ >> 1 ^ (value_ & 1 ? 0xedb88320u : 0u);
    }
    return *this;
  }
  uint32_t Value() const { return ~value_; }

 private:
  uint32_t value_ = ~uint32_t{0};
};

template <class T>
std::string Le(T value) {  // the host is little-endian
  std::string bytes(sizeof(value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(value));
  return bytes;
}

std::string Bytes(const std::vector<float>& floats) {
  std::string bytes(floats.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), floats.data(), bytes.size());
  return bytes;
}

std::vector<float> Floats(const std::string& bytes) {
  std::vector<float> floats(bytes.size() / sizeof(float));
  std::memcpy(floats.data(), bytes.data(), floats.size() * sizeof(float));
  return floats;
}

struct HeaderFields {
  std::string magic = "\x89GPRB\r\n\x1a";
  uint32_t version = 1;
  uint32_t format = GAUNT_FORMAT_SH3_28;
  uint32_t record_bytes = 28;
  ProbeFileGrid grid;
  uint64_t count = 0;
};

std::string Header(const HeaderFields& h) {
  std::string bytes = h.magic + Le(h.version) + Le(h.format) + Le(h.record_bytes);
  for (const uint32_t n : h.grid.size) bytes += Le(n);
  bytes += Le(h.count);
  for (const float x : h.grid.origin) bytes += Le(x);
  for (const float x : h.grid.spacing) bytes += Le(x);
  return bytes + Le(Crc32().Add(bytes).Value());
}

std::string Blocks(const std::string& records, size_t record_bytes) {
  std::string bytes;
  for (size_t first = 0; first * record_bytes < records.size(); first += kBlock) {
    const std::string block = records.substr(first * record_bytes, kBlock * record_bytes);
    bytes += block + Le(Crc32().Add(Le(uint64_t{first})).Add(block).Value());
  }
  return bytes;
}

std::string ProbeFile(uint32_t format, const std::string& records, const ProbeFileGrid& grid = {}) {
  HeaderFields header;
  header.format = format;
  header.record_bytes = static_cast<uint32_t>(EncodingOfFormat(format).bytes);
  header.grid = grid;
  header.count = records.size() / header.record_bytes;
  return Header(header) + Blocks(records, header.record_bytes);
}

// ---- probes

std::string RandomRecords(size_t bytes, uint64_t seed = 1) {
  Random random(seed);
  std::string records(bytes, '\0');
  for (char& byte : records) byte = static_cast<char>(random.Bits());
  return records;
}

// Light of means 0.1 to 2, some of whose ratios no format can hold.
std::vector<float> RandomProbes(size_t count, uint32_t order, uint64_t seed = 1) {
  Random random(seed);
  const size_t size = size_t{order} * order;
  std::vector<float> probes;
  for (size_t channel = 0; channel < 3 * count; ++channel) {
    const float mean = random.Between(0.1, 2.0);
    for (size_t k = 0; k < size; ++k) {
      probes.push_back(k == 0 ? mean : mean * random.Between(-2.0, 2.0));
    }
  }
  return probes;
}

std::string Encode(uint32_t format, std::vector<float> probes) {
  const ProbeEncoding e = EncodingOfFormat(format);
  const size_t count = probes.size() / e.planes();
  std::string records(count * e.bytes, '\0');
  gaunt_view view;
  gaunt_view_interleaved(probes.data(), e.planes(), &view);
  EXPECT_EQ(gaunt_probe_encode(format, count, &view, records.data(), e.bytes, nullptr), GAUNT_OK);
  return records;
}

std::vector<float> Decode(uint32_t format, const std::string& records) {
  const ProbeEncoding e = EncodingOfFormat(format);
  const size_t count = records.size() / e.bytes;
  std::vector<float> probes(count * e.planes());
  gaunt_view view;
  gaunt_view_interleaved(probes.data(), e.planes(), &view);
  EXPECT_EQ(gaunt_probe_decode(format, count, records.data(), e.bytes, &view), GAUNT_OK);
  return probes;
}

std::vector<float> WithOrder(const std::vector<float>& probes, uint32_t from, uint32_t to) {
  std::vector<float> out;
  for (size_t channel = 0; channel < probes.size() / (from * from); ++channel) {
    for (size_t k = 0; k < to * to; ++k) {
      out.push_back(k < from * from ? probes[channel * from * from + k] : 0.0f);
    }
  }
  return out;
}

// With gaps between records.
std::string Spread(const std::string& records, size_t bytes, size_t stride, char gap) {
  std::string out;
  for (size_t at = 0; at < records.size(); at += bytes) {
    out += records.substr(at, bytes) + std::string(stride - bytes, gap);
  }
  return out;
}

class Volume : public FolderTest {
 protected:
  static ConvertSummary Convert(const ConvertJob& job) {
    return tool::ConvertProbes(job, [](double) {});
  }

  ConvertJob PackJob(uint32_t format, uint32_t order = 0) const {
    const ProbeEncoding to = EncodingOfFormat(format);
    ConvertJob job;
    job.in = {Path("in"), EncodingOfFloats(order != 0 ? order : to.order), 0};
    job.out = {Path("out"), to, false, 0, {}, false};
    return job;
  }
  ConvertJob UnpackJob() const {
    ConvertJob job;
    job.in.path = Path("in");
    job.out.path = Path("out");
    job.out.raw = true;
    return job;
  }
  ConvertJob TranscodeJob(uint32_t to) const {
    ConvertJob job;
    job.in.path = Path("in");
    job.out = {Path("out"), EncodingOfFormat(to), false, 0, {}, false};
    return job;
  }

  std::string Converted(const ConvertJob& job, const std::string& in) {
    Write(Path("in"), in);
    summary_ = Convert(job);
    const std::string out = Read(Path("out"));
    EXPECT_EQ(summary_.bytes_read, in.size() + OtherBytes(job));
    EXPECT_EQ(summary_.bytes_written, out.size());
    return out;
  }

  // What the error says, without the file's name. An older output stays, and nothing else does.
  std::string Rejection(const ConvertJob& job, const std::string& in) {
    Write(Path("in"), in);
    Write(Path("out"), "old");
    const size_t files = FilesInFolder();
    try {
      Convert(job);
    } catch (const BadInput& error) {
      EXPECT_EQ(FilesInFolder(), files);
      EXPECT_EQ(Read(Path("out")), "old");
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      for (const char* file : {"in", "out", "other"}) {
        const std::string start = Path(file) + ": ";
        if (message.rfind(start, 0) == 0) return message.substr(start.size());
      }
      return "names no file: " + message;
    }
    return "accepted";
  }

  ConvertSummary summary_;

 private:
  static uint64_t OtherBytes(const ConvertJob& job) {
    return job.blend ? fs::file_size(job.blend->with.path) : 0;
  }
};

TEST(FormatName, EveryFormatHasOne) {
  const std::vector<uint32_t> formats = AllFormats();
  ASSERT_EQ(tool::FormatNames().size(), formats.size());
  std::set<std::string> names;
  for (const uint32_t format : formats) {
    const std::string name = tool::NameOfFormat(format);
    EXPECT_NE(name, "");
    EXPECT_EQ(name, tool::FormatNames()[format - 1]);
    EXPECT_EQ(tool::FormatOfName(name), format);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), formats.size());
  for (const uint32_t none : {uint32_t{0}, formats.back() + 1, UINT32_MAX}) {
    EXPECT_EQ(tool::NameOfFormat(none), "");
    EXPECT_EQ(tool::PropertiesOfFormat(none).bytes, 0u);
  }
  EXPECT_EQ(tool::NameOfFormat(GAUNT_FORMAT_UNREAL_28), "unreal_28");
  EXPECT_THROW(tool::FormatOfName("sh3"), BadInput);
  EXPECT_THROW(tool::FormatOfName(""), BadInput);
}

// ---- what is written

TEST_F(Volume, FilesAreAsDescribedAndComeBackInEveryFormat) {
  for (const uint32_t format : AllFormats()) {
    const ProbeEncoding encoding = EncodingOfFormat(format);
    for (const size_t count : {size_t{1}, size_t{15}, size_t{16}, size_t{17}, kBlock - 1, kBlock,
                               kBlock + 1, 2 * kBlock + 17}) {
      const std::vector<float> probes = RandomProbes(count, encoding.order, count);
      const std::string records = Encode(format, probes), file = ProbeFile(format, records);
      ASSERT_TRUE(Converted(PackJob(format), Bytes(probes)) == file)
          << tool::NameOfFormat(format) << ", " << count;
      EXPECT_EQ(summary_.probes, count);
      EXPECT_EQ(summary_.errors->finite, count);
      EXPECT_EQ(file.size(), kHeader + records.size() + 4 * ((count + kBlock - 1) / kBlock));
      ASSERT_TRUE(Converted(UnpackJob(), file) == Bytes(Decode(format, records)))
          << tool::NameOfFormat(format) << ", " << count;
      EXPECT_FALSE(summary_.errors);
      EXPECT_EQ(FilesInFolder(), 2u);
    }
  }
}

// Every byte of a small file, as docs/probe_file.md has it.
TEST_F(Volume, ASmallFileByteByByte) {
  ConvertJob job = PackJob(GAUNT_FORMAT_RGB9E5);
  job.out.grid = ProbeFileGrid{{2, 1, 1}, {-1.0f, 0.0f, 0.5f}, {1.0f, 2.0f, 0.25f}};
  const std::string out = Converted(job, Bytes({1.0f, 0.5f, 0.0f, 2.0f, 2.0f, 2.0f}));
  const uint8_t expected[] = {
      0x89, 'G', 'P',  'R',  'B', '\r', '\n', 0x1a,  // magic
      1,    0,   0,    0,    10,  0,    0,    0,
      4,    0,   0,    0,  // version, format, bytes of a record
      2,    0,   0,    0,    1,   0,    0,    0,
      1,    0,   0,    0,                         // grid
      2,    0,   0,    0,    0,   0,    0,    0,  // probes
      0,    0,   0x80, 0xbf, 0,   0,    0,    0,
      0,    0,   0,    0x3f,  // origin
      0,    0,   0x80, 0x3f, 0,   0,    0,    0x40,
      0,    0,   0x80, 0x3e  // spacing
  };
  ASSERT_EQ(out.size(), kHeader + 2 * 4 + 4);
  EXPECT_EQ(std::memcmp(out.data(), expected, sizeof(expected)), 0);
  EXPECT_EQ(out.substr(64, 4), Le(Crc32().Add(out.substr(0, 64)).Value()));
  // 256 and 128 times 2^-8, and 256 times 2^-7.
  EXPECT_EQ(out.substr(68, 4), Le(uint32_t{16} << 27 | 128u << 9 | 256u));
  EXPECT_EQ(out.substr(72, 4), Le(uint32_t{17} << 27 | 256u << 18 | 256u << 9 | 256u));
  EXPECT_EQ(out.substr(76, 4), Le(Crc32().Add(Le(uint64_t{0})).Add(out.substr(68, 8)).Value()));
  // The standard's own example.
  EXPECT_EQ(Crc32().Add("123456789").Value(), 0xcbf43926u);
}

TEST_F(Volume, BytesAndErrorsDoNotDependOnThreads) {
  constexpr size_t kCount = 11 * kBlock + 77;
  const std::string floats = Bytes(RandomProbes(kCount, 3));
  std::string packed, unpacked, transcoded;
  tool::EncodingErrors errors;
  for (const uint64_t threads : {1, 2, 3, 7, 64}) {
    ConvertJob pack = PackJob(GAUNT_FORMAT_SH3_28), unpack = UnpackJob(),
               transcode = TranscodeJob(GAUNT_FORMAT_UNITY_L1_16);
    pack.threads = unpack.threads = transcode.threads = threads;
    const std::string file = Converted(pack, floats);
    EXPECT_EQ(summary_.threads, std::min<uint64_t>(threads, 12));
    if (threads == 1) {
      packed = file;
      errors = *summary_.errors;
      unpacked = Converted(unpack, file);
      transcoded = Converted(transcode, file);
      continue;
    }
    EXPECT_TRUE(file == packed);
    EXPECT_EQ(summary_.errors->rms, errors.rms);
    EXPECT_EQ(summary_.errors->largest, errors.largest);
    EXPECT_EQ(summary_.errors->light, errors.light);
    EXPECT_EQ(summary_.errors->clamped, errors.clamped);
    EXPECT_EQ(summary_.errors->worst_rms.probe, errors.worst_rms.probe);
    EXPECT_EQ(summary_.errors->worst_largest.probe, errors.worst_largest.probe);
    EXPECT_TRUE(Converted(unpack, packed) == unpacked);
    EXPECT_TRUE(Converted(transcode, packed) == transcoded);
  }
}

TEST_F(Volume, BandsAreDroppedOrFilledWithZero) {
  constexpr size_t kCount = kBlock + 21;
  for (const uint32_t format : AllFormats()) {
    const uint32_t format_order = EncodingOfFormat(format).order;
    const std::string records = RandomRecords(kCount * EncodingOfFormat(format).bytes);
    for (const uint32_t order : {1u, 2u, 3u, 4u, 6u}) {
      const std::vector<float> probes = RandomProbes(kCount, order);
      ASSERT_TRUE(Converted(PackJob(format, order), Bytes(probes)) ==
                  ProbeFile(format, Encode(format, WithOrder(probes, order, format_order))));
      if (format == GAUNT_FORMAT_SH3_F32) continue;  // whose records may be NaN
      ConvertJob unpack = UnpackJob();
      unpack.out.encoding = EncodingOfFloats(order);
      ASSERT_TRUE(Converted(unpack, ProbeFile(format, records)) ==
                  Bytes(WithOrder(Decode(format, records), format_order, order)));
    }
  }
}

TEST_F(Volume, EveryFormatBecomesEveryOther) {
  constexpr size_t kCount = kBlock + 5;
  for (const uint32_t from : AllFormats()) {
    const ProbeEncoding encoding = EncodingOfFormat(from);
    const std::string records = Encode(from, RandomProbes(kCount, encoding.order));
    const std::vector<float> decoded = Decode(from, records);
    for (const uint32_t to : AllFormats()) {
      const std::string expected =
          from == to ? records
                     : Encode(to, WithOrder(decoded, encoding.order, EncodingOfFormat(to).order));
      ASSERT_TRUE(Converted(TranscodeJob(to), ProbeFile(from, records)) == ProbeFile(to, expected))
          << tool::NameOfFormat(from) << " to " << tool::NameOfFormat(to);
      EXPECT_EQ(summary_.errors.has_value(), from != to);
    }
  }
}

TEST_F(Volume, RawFilesHaveRecordsAloneInAnyStride) {
  constexpr size_t kCount = kBlock + 3;
  for (const uint32_t format : AllFormats()) {
    const ProbeEncoding encoding = EncodingOfFormat(format);
    const std::string records = RandomRecords(kCount * encoding.bytes);
    // Of the same format bytes stay as they are, whatever they are.
    for (const size_t in_stride : {encoding.bytes, encoding.bytes + 1, size_t{4096}}) {
      ConvertJob job = TranscodeJob(format);
      job.in.raw = encoding;
      job.in.stride = in_stride;
      job.out.raw = true;
      job.out.stride = encoding.bytes + 3;
      const std::string in = Spread(records, encoding.bytes, in_stride, 'x');
      ASSERT_TRUE(Converted(job, in) == Spread(records, encoding.bytes, encoding.bytes + 3, '\0'));
      job.out.raw = false;
      job.out.stride = 0;
      ASSERT_TRUE(Converted(job, in) == ProbeFile(format, records));
    }
    // Another format, and floats, with gaps on both sides.
    const std::vector<float> probes = RandomProbes(kCount, encoding.order);
    ConvertJob pack = PackJob(format);
    pack.in.stride = 12 * encoding.order * encoding.order + 8;
    ASSERT_TRUE(Converted(pack, Spread(Bytes(probes), pack.in.stride - 8, pack.in.stride, 'x')) ==
                ProbeFile(format, Encode(format, probes)));
    if (format == GAUNT_FORMAT_SH3_F32) continue;
    ConvertJob unpack = UnpackJob();
    unpack.out.stride = pack.in.stride;
    ASSERT_TRUE(Converted(unpack, ProbeFile(format, records)) ==
                Spread(Bytes(Decode(format, records)), pack.in.stride - 8, pack.in.stride, '\0'));
    ConvertJob transcode = TranscodeJob(GAUNT_FORMAT_SH3_F16);
    transcode.in.raw = encoding;
    transcode.in.stride = 111;
    transcode.out.raw = true;
    transcode.out.stride = 64;
    if (format == GAUNT_FORMAT_SH3_F16) continue;
    ASSERT_TRUE(
        Converted(transcode, Spread(records, encoding.bytes, 111, 'x')) ==
        Spread(Encode(GAUNT_FORMAT_SH3_F16, WithOrder(Decode(format, records), encoding.order, 3)),
               54, 64, '\0'));
  }
}

TEST_F(Volume, BlendsMatchTheDefinition) {
  constexpr size_t kCount = kBlock + 9;
  const uint32_t formats[] = {GAUNT_FORMAT_SH3_28, GAUNT_FORMAT_SH2_13, GAUNT_FORMAT_UNREAL_28,
                              GAUNT_FORMAT_SH3_F32};
  for (const uint32_t format_a : formats) {
    for (const uint32_t format_b : formats) {
      const ProbeEncoding encoding_a = EncodingOfFormat(format_a),
                          encoding_b = EncodingOfFormat(format_b);
      const std::string records_a = Encode(format_a, RandomProbes(kCount, encoding_a.order, 1)),
                        records_b = Encode(format_b, RandomProbes(kCount, encoding_b.order, 2));
      const std::vector<float> a = WithOrder(Decode(format_a, records_a), encoding_a.order, 3),
                               b = WithOrder(Decode(format_b, records_b), encoding_b.order, 3);
      Write(Path("other"), ProbeFile(format_b, records_b));
      for (const float weight : {0.0f, 1.0f, 0.5f, 0.3f}) {
        ConvertJob job = TranscodeJob(GAUNT_FORMAT_SH3_F32);
        job.blend = tool::ProbeBlend{{Path("other"), {}, 0}, weight};
        job.out.raw = true;
        const std::vector<float> blend = Floats(Converted(job, ProbeFile(format_a, records_a)));
        ASSERT_EQ(blend.size(), a.size());
        for (size_t k = 0; k < a.size(); ++k) {
          const double expected = (1.0 - weight) * double{a[k]} + weight * double{b[k]};
          ASSERT_NEAR(blend[k], expected,
                      weight == 0.0f || weight == 1.0f
                          ? 0.0
                          : 1.2e-7 * (std::abs(double{a[k]}) + std::abs(double{b[k]})));
        }
        // Packed, it is what the blend packs to.
        job.out = {Path("out"), EncodingOfFormat(GAUNT_FORMAT_SH3_32), false, 0, {}, false};
        ASSERT_TRUE(Converted(job, ProbeFile(format_a, records_a)) ==
                    ProbeFile(GAUNT_FORMAT_SH3_32, Encode(GAUNT_FORMAT_SH3_32, blend)));
        // Floats, of another order.
        job.out = {Path("out"), EncodingOfFloats(2), true, 48 + 4, {}, false};
        ASSERT_TRUE(Converted(job, ProbeFile(format_a, records_a)) ==
                    Spread(Bytes(WithOrder(blend, 3, 2)), 48, 52, '\0'));
      }
    }
  }
  // Raw volumes are read alike.
  const std::string a = RandomRecords(28 * kCount, 1), b = RandomRecords(28 * kCount, 2);
  Write(Path("other"), Spread(b, 28, 32, 'x'));
  ConvertJob job = TranscodeJob(GAUNT_FORMAT_SH3_28);
  job.in.raw = EncodingOfFormat(GAUNT_FORMAT_SH3_28);
  job.in.stride = 32;
  job.blend = tool::ProbeBlend{{Path("other"), job.in.raw, 32}, 1.0f};
  EXPECT_TRUE(
      Converted(job, Spread(a, 28, 32, 'x')) ==
      ProbeFile(GAUNT_FORMAT_SH3_28, Encode(GAUNT_FORMAT_SH3_28, Decode(GAUNT_FORMAT_SH3_28, b))));
}

// Bands that the format lacks are lost, too.
TEST_F(Volume, ErrorsMatchTheDefinition) {
  constexpr size_t kCount = 2 * kBlock + 33;
  const double bands[] = {1.0, 2.0 / 3.0, 0.25, 0.0, -1.0 / 24.0, 0.0, 1.0 / 64.0};  // A_l / pi
  const std::pair<uint32_t, uint32_t> cases[] = {
      // format, order of the input
      {GAUNT_FORMAT_SH3_28, 3},    {GAUNT_FORMAT_SH2_13, 2}, {GAUNT_FORMAT_RGB9E5, 1},
      {GAUNT_FORMAT_UNREAL_28, 3}, {GAUNT_FORMAT_SH3_28, 1}, {GAUNT_FORMAT_SH3_28, 4},
      {GAUNT_FORMAT_SH3_28, 7},    {GAUNT_FORMAT_SH2_13, 3}, {GAUNT_FORMAT_RGB9E5, 2},
      {GAUNT_FORMAT_RGB9E5, 6}};
  for (const auto& [format, order] : cases) {
    const uint32_t kept_order = EncodingOfFormat(format).order;
    const size_t size = size_t{order} * order, planes = 3 * size;
    std::vector<float> probes = RandomProbes(kCount, order);
    // One that is far off, in the middle.
    constexpr size_t kOdd = kBlock + 100;
    if (order > 1) probes[kOdd * planes + 1] = 50.0f;
    std::vector<float> finite = probes;
    probes[7 * planes] = std::numeric_limits<float>::quiet_NaN();
    probes[8 * planes + planes - 1] = std::numeric_limits<float>::infinity();
    Converted(PackJob(format, order), Bytes(probes));
    const tool::EncodingErrors& errors = *summary_.errors;
    EXPECT_EQ(errors.finite, kCount - 2);
    EXPECT_EQ(errors.not_finite, 2u);
    const std::vector<float> decoded = WithOrder(
        Decode(format, Encode(format, WithOrder(finite, order, kept_order))), kept_order, order);
    double light = 0.0, rms = 0.0, worst_rms = 0.0, largest = 0.0, worst_largest = 0.0;
    for (size_t i = 0; i < kCount; ++i) {
      if (i == 7 || i == 8) continue;
      double energy = 0.0, worst_kept = 0.0, worst_dropped = 0.0;  // of a channel
      for (size_t c = 0; c < 3; ++c) {
        light += finite[i * planes + c * size] / std::sqrt(4.0 * kPi) / 3.0;
        double kept = 0.0, dropped = 0.0;
        for (uint32_t l = 0; l < order; ++l) {
          double band = 0.0;
          for (size_t k = l * l; k < (l + 1) * (l + 1); ++k) {
            const size_t at = i * planes + c * size + k;
            band += std::pow(double{finite[at]} - double{decoded[at]}, 2);
          }
          energy += bands[l] * bands[l] * band;
          (l < kept_order ? kept : dropped) +=
              std::abs(bands[l]) * std::sqrt(band) * std::sqrt((2.0 * l + 1.0) / (4.0 * kPi));
        }
        worst_kept = std::max(worst_kept, kept);
        worst_dropped = std::max(worst_dropped, dropped);
      }
      const double one = std::sqrt(energy / (4.0 * kPi * 3.0));
      const double bound = worst_kept + worst_dropped;
      rms += one;
      worst_rms = std::max(worst_rms, one);
      largest += bound;
      worst_largest = std::max(worst_largest, bound);
    }
    const double tolerance = 1e-4;  // errors are small differences
    EXPECT_NEAR(errors.light, light, 1e-9 * light);
    EXPECT_NEAR(errors.rms, rms, tolerance * rms);
    EXPECT_NEAR(errors.largest, largest, tolerance * largest);
    EXPECT_NEAR(errors.worst_rms.error, worst_rms, tolerance * worst_rms);
    EXPECT_NEAR(errors.worst_largest.error, worst_largest, tolerance * worst_largest);
    if (order > 1) {
      EXPECT_EQ(errors.worst_rms.probe, kOdd);
      EXPECT_EQ(errors.worst_largest.probe, kOdd);
    }
  }
  // Every ratio is twice what there may be.
  std::vector<float> probes(48 * 3, 2.0f);
  for (size_t channel = 0; channel < 36; ++channel) probes[4 * channel] = 0.5f;
  Converted(PackJob(GAUNT_FORMAT_SH2_13), Bytes(probes));
  EXPECT_EQ(summary_.errors->clamped, 12u * 9u);
}

TEST_F(Volume, ErrorsOfBandsThatTranscodingDrops) {
  // A probe that every format holds exactly, but for band 2 of green: E/pi = 2 and a quarter of it.
  std::vector<float> probe(27, 0.0f), other(27, 0.0f);
  for (const size_t c : {0u, 1u, 2u}) probe[9 * c] = other[9 * c] = 2.0f;
  probe[9 + 4] = 0.5f;
  other[9 + 4] = -1.0f;
  const auto file = [](const std::vector<float>& p) {
    return ProbeFile(GAUNT_FORMAT_SH3_F32, Encode(GAUNT_FORMAT_SH3_F32, p));
  };
  const auto expect_band = [&](double coefficient) {
    const double e = 0.25 * coefficient, peak = std::sqrt(5.0 / (4.0 * kPi));
    EXPECT_NEAR(summary_.errors->rms, e / std::sqrt(4.0 * kPi * 3.0), 1e-8);
    EXPECT_NEAR(summary_.errors->largest, e * peak, 1e-8);
  };
  ConvertJob job = TranscodeJob(GAUNT_FORMAT_RGB9E5);
  Converted(job, file(probe));
  expect_band(0.5);
  // Of a blend; either volume may have the band.
  job.blend = tool::ProbeBlend{{Path("other"), {}, 0}, 0.25f};
  Write(Path("other"), file(other));
  Converted(job, file(probe));
  expect_band(0.75 * 0.5 - 0.25 * 1.0);
  Converted(job,
            ProbeFile(GAUNT_FORMAT_RGB9E5, Encode(GAUNT_FORMAT_RGB9E5, WithOrder(probe, 3, 1))));
  expect_band(0.25 * 1.0);
  // Floats have no errors, and no band but their own.
  job.out = {Path("out"), EncodingOfFloats(1), true, 0, {}, false};
  EXPECT_EQ(Floats(Converted(job, file(probe))), std::vector<float>(3, 2.0f));
  EXPECT_FALSE(summary_.errors);
}

TEST_F(Volume, RefinedRecordsAreTheLibrarys) {
  constexpr size_t kCount = 70;
  std::vector<float> probes = RandomProbes(kCount, 3);
  gaunt_view view;
  gaunt_view_interleaved(probes.data(), 27, &view);
  std::string records(kCount * 28, '\0');
  ASSERT_EQ(
      gaunt_probe_encode_refined(GAUNT_FORMAT_SH3_28, kCount, &view, records.data(), 28, nullptr),
      GAUNT_OK);
  ConvertJob job = PackJob(GAUNT_FORMAT_SH3_28);
  Converted(job, Bytes(probes));
  const double before = summary_.errors->rms;
  job.out.refined = true;
  EXPECT_TRUE(Converted(job, Bytes(probes)) == ProbeFile(GAUNT_FORMAT_SH3_28, records));
  EXPECT_LT(summary_.errors->rms, 0.99 * before);
}

TEST_F(Volume, GridsAreKept) {
  const ProbeFileGrid grid = {{3, 5, 2}, {-1.5f, 0.0f, 1e9f}, {0.5f, 1.0f, 2.0f}};
  const std::string records = RandomRecords(30 * 28), other = RandomRecords(30 * 28, 2);
  const std::string with_grid = ProbeFile(GAUNT_FORMAT_SH3_28, records, grid);
  const auto grid_bytes = [](const std::string& file) {
    return file.substr(20, 12) + file.substr(40, 24);
  };
  ConvertJob job = TranscodeJob(GAUNT_FORMAT_SH2_13);
  EXPECT_EQ(grid_bytes(Converted(job, with_grid)), grid_bytes(with_grid));
  EXPECT_EQ(summary_.grid.size, grid.size);
  // Of a blend either volume may have it; of two that have, the first counts.
  job.blend = tool::ProbeBlend{{Path("other"), {}, 0}, 0.5f};
  Write(Path("other"), ProbeFile(GAUNT_FORMAT_SH3_28, other));
  EXPECT_EQ(grid_bytes(Converted(job, with_grid)), grid_bytes(with_grid));
  Write(Path("other"), ProbeFile(GAUNT_FORMAT_SH3_28, other, {{3, 5, 2}, {}, {1, 1, 1}}));
  EXPECT_EQ(grid_bytes(Converted(job, with_grid)), grid_bytes(with_grid));
  Write(Path("other"), with_grid);
  EXPECT_EQ(grid_bytes(Converted(job, ProbeFile(GAUNT_FORMAT_SH3_28, records))),
            grid_bytes(with_grid));
  // A new one replaces it.
  job.blend = {};
  job.out.grid = ProbeFileGrid{{30, 1, 1}, {}, {1, 1, 1}};
  const std::string replaced = Converted(job, with_grid);
  EXPECT_EQ(replaced.substr(20, 12), Le(uint32_t{30}) + Le(uint32_t{1}) + Le(uint32_t{1}));
}

TEST_F(Volume, OutputMayBeAnInput) {
  const std::string records = RandomRecords(kBlock * 28 + 28);
  ConvertJob job = TranscodeJob(GAUNT_FORMAT_SH2_13);
  const std::string expected = Converted(job, ProbeFile(GAUNT_FORMAT_SH3_28, records));
  job.out.path = job.in.path;
  Convert(job);
  EXPECT_TRUE(Read(Path("in")) == expected);
}

TEST_F(Volume, ProgressRisesToAll) {
  Write(Path("in"), Bytes(RandomProbes(10 * kBlock, 1)));
  for (const uint64_t threads : {1, 3}) {
    double last = 0.0;
    int calls = 0;
    ConvertJob job = PackJob(GAUNT_FORMAT_RGB9E5);
    job.threads = threads;
    tool::ConvertProbes(job, [&](double share) {
      EXPECT_GT(share, last);
      last = share;
      ++calls;
    });
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(calls, 10);
  }
}

// Twenty times as many probes take no more memory.
TEST_F(Volume, MemoryDoesNotDependOnTheNumberOfProbes) {
  const auto peak = [] {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // KiB
  };
  const auto run = [&](size_t blocks) {
    {
      // Little by little, for the test itself must not need so much.
      std::ofstream file(Path("in"), std::ios::binary);
      const std::string block = Bytes(RandomProbes(kBlock, 3));
      for (size_t k = 0; k < blocks; ++k) file << block;
    }
    ConvertJob pack = PackJob(GAUNT_FORMAT_SH3_28);
    pack.out.path = Path("packed");
    pack.threads = 3;
    Convert(pack);
    ConvertJob transcode = TranscodeJob(GAUNT_FORMAT_SH3_32);
    transcode.in.path = Path("packed");
    transcode.threads = 3;
    transcode.blend = tool::ProbeBlend{{Path("packed"), {}, 0}, 0.5f};
    Convert(transcode);
    ConvertJob unpack = UnpackJob();
    unpack.in.path = Path("packed");
    unpack.threads = 3;
    Convert(unpack);
  };
  run(12);
  const long before = peak();
  run(240);
  EXPECT_EQ(fs::file_size(Path("out")), 240 * kBlock * 108);  // 104 MiB
  EXPECT_LT(peak() - before, 4096);
}

// ---- what is rejected

TEST_F(Volume, RejectsEveryDamagedBit) {
  const ConvertJob job = UnpackJob();
  const std::string good =
      ProbeFile(GAUNT_FORMAT_SH2_13, RandomRecords(3 * 13), {{3, 1, 1}, {0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(Rejection(job, good), "accepted");
  for (size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ 1 << bit);
      const std::string message = Rejection(job, bad);
      if (at < 8) {
        ASSERT_EQ(message, "is no file of packed probes");
      } else if (at < 12) {
        ASSERT_EQ(message.rfind("has version ", 0), 0u) << message;
      } else if (at < kHeader) {
        ASSERT_EQ(message, "is damaged: the checksum of its header is wrong");
      } else {
        ASSERT_EQ(message, "is damaged: the checksum of its probes 0 to 2 is wrong");
      }
    }
  }
}

// The first of several damaged blocks is named, whatever thread finds it.
TEST_F(Volume, RejectsDamagedBlocks) {
  const std::string good = ProbeFile(GAUNT_FORMAT_RGB9E5, RandomRecords(4 * 5 * kBlock + 40));
  constexpr size_t kBlockBytes = 4 * kBlock + 4;
  const auto block_at = [](size_t block) { return kHeader + block * kBlockBytes; };
  for (const uint64_t threads : {1, 2, 8}) {
    ConvertJob job = UnpackJob();
    job.threads = threads;
    std::string swapped = good;
    swapped.replace(block_at(1), kBlockBytes, good, block_at(2), kBlockBytes);
    swapped.replace(block_at(2), kBlockBytes, good, block_at(1), kBlockBytes);
    EXPECT_EQ(Rejection(job, swapped),
              "is damaged: the checksum of its probes 4096 to 8191 is wrong");
    std::string several = good;
    for (const size_t block : {2u, 3u, 4u, 5u}) several[block_at(block)] ^= 1;
    EXPECT_EQ(Rejection(job, several),
              "is damaged: the checksum of its probes 8192 to 12287 is wrong");
    EXPECT_EQ(Rejection(job, several.substr(0, block_at(4))),
              "is damaged: the checksum of its probes 8192 to 12287 is wrong");
    std::string last = good;
    last[good.size() - 5] ^= 64;
    EXPECT_EQ(Rejection(job, last),
              "is damaged: the checksum of its probes 20480 to 20489 is wrong");
    // So is a block of another volume's.
    job = TranscodeJob(GAUNT_FORMAT_RGB9E5);
    job.blend = tool::ProbeBlend{{Path("other"), {}, 0}, 0.5f};
    job.threads = threads;
    Write(Path("other"), several);
    EXPECT_EQ(Rejection(job, good),
              "is damaged: the checksum of its probes 8192 to 12287 is wrong");
  }
}

TEST_F(Volume, RejectsEveryTruncation) {
  const ConvertJob job = UnpackJob();
  const std::string good = ProbeFile(GAUNT_FORMAT_SH2_13, RandomRecords(7 * 13));
  EXPECT_EQ(Rejection(job, good), "accepted");
  EXPECT_EQ(Rejection(job, good + '\0'), "has bytes after its last probe");
  EXPECT_EQ(Rejection(job, good + good), "has bytes after its last probe");
  for (size_t size = 0; size < good.size(); ++size) {
    const std::string message = Rejection(job, good.substr(0, size));
    if (size == 0) {
      ASSERT_EQ(message, "is empty");
    } else if (size < kHeader) {
      ASSERT_EQ(message, "ends in its header");
    } else if (size < good.size() - 4) {
      ASSERT_EQ(message,
                "is cut short: it has " + std::to_string((size - kHeader) / 13) + " of 7 probes");
    } else {
      ASSERT_EQ(message, "is cut short: the checksum after its probe 6 is missing");
    }
  }
  // At the end of a block there is nothing that a checksum would find.
  const std::string blocks = ProbeFile(GAUNT_FORMAT_RGB9E5, RandomRecords(4 * 2 * kBlock));
  EXPECT_EQ(Rejection(job, blocks.substr(0, kHeader + 4 * kBlock + 4)),
            "is cut short: it has 4096 of 8192 probes");
}

TEST_F(Volume, RejectsHeadersThatCannotBe) {
  const std::string records = RandomRecords(6 * 28);
  const auto rejection = [&](auto change) {
    HeaderFields header;
    header.count = 6;
    change(header);
    return Rejection(UnpackJob(), Header(header) + Blocks(records, 28));
  };
  EXPECT_EQ(rejection([](HeaderFields&) {}), "accepted");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.magic = "\x89PNG\r\n\x1a\n"; }),
            "is no file of packed probes");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.version = 2; }),
            "has version 2 of its format, but this program reads version 1");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.version = 0; }),
            "has version 0 of its format, but this program reads version 1");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.format = 0; }),
            "has probes of format 0, which this program does not know");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.format = 4000000000u; }),
            "has probes of format 4000000000, which this program does not know");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.record_bytes = 27; }),
            "has records of 27 bytes, but those of sh3_28 have 28");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.format = GAUNT_FORMAT_SH3_32; }),
            "has records of 28 bytes, but those of sh3_32 have 32");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.count = 0; }), "has no probes");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.count = 5; }),
            "is damaged: the checksum of its probes 0 to 4 is wrong");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.count = 7; }), "is cut short: it has 6 of 7 probes");
  EXPECT_EQ(rejection([](HeaderFields& h) { h.count = uint64_t{1} << 56; }),
            "is cut short: it has 6 of 72057594037927936 probes");
  for (const uint64_t count : {uint64_t{1} << 58, UINT64_MAX}) {
    EXPECT_EQ(rejection([&](HeaderFields& h) { h.count = count; }),
              "cannot have " + std::to_string(count) + " probes");
  }
  const auto grid = [&](uint32_t x, uint32_t y, uint32_t z, float origin, float spacing) {
    return rejection([&](HeaderFields& h) {
      h.grid = {{x, y, z}, {0.0f, origin, 0.0f}, {1.0f, 1.0f, spacing}};
    });
  };
  EXPECT_EQ(grid(1, 2, 3, 0.0f, 1.0f), "accepted");
  EXPECT_EQ(grid(2, 2, 2, 0.0f, 1.0f), "has a grid of 2 x 2 x 2, but 6 probes");
  EXPECT_EQ(grid(6, 0, 0, 0.0f, 1.0f), "has a grid of 6 x 0 x 0, but 6 probes");
  EXPECT_EQ(grid(0, 2, 3, 0.0f, 1.0f), "has a grid of 0 x 2 x 3, but 6 probes");
  // 6 of a product that overflows.
  EXPECT_EQ(grid(3, 2863311531u, 2147483648u, 0.0f, 1.0f),
            "has a grid of 3 x 2863311531 x 2147483648, but 6 probes");
  for (const float bad : {HUGE_VALF, -HUGE_VALF, std::nanf("")}) {
    EXPECT_EQ(grid(1, 2, 3, bad, 1.0f), "has a grid whose origin is not finite");
    EXPECT_EQ(grid(1, 2, 3, 0.0f, bad), "has a grid whose spacing is not finite and above 0");
  }
  EXPECT_EQ(grid(1, 2, 3, 0.0f, 0.0f), "has a grid whose spacing is not finite and above 0");
  EXPECT_EQ(grid(1, 2, 3, 0.0f, -1.0f), "has a grid whose spacing is not finite and above 0");
}

TEST_F(Volume, RejectsRawFilesOfOtherSizes) {
  EXPECT_EQ(Rejection(PackJob(GAUNT_FORMAT_SH3_28), ""), "is empty");
  EXPECT_EQ(Rejection(PackJob(GAUNT_FORMAT_SH3_28), std::string(109, 'x')),
            "has 109 bytes, which is no multiple of 108, those from probe to probe of floats of "
            "order 3");
  ConvertJob job = PackJob(GAUNT_FORMAT_SH3_28);
  job.in.stride = 104;
  EXPECT_EQ(Rejection(job, std::string(108, 'x')),
            "a stride of 104 bytes is less than the 108 of floats of order 3");
  job.in.stride = 110;
  EXPECT_EQ(Rejection(job, std::string(110, 'x')),
            "a stride of 110 bytes is no multiple of the 4 of a float");
  job = TranscodeJob(GAUNT_FORMAT_SH2_13);
  job.in.raw = EncodingOfFormat(GAUNT_FORMAT_SH3_28);
  EXPECT_EQ(Rejection(job, std::string(29, 'x')),
            "has 29 bytes, which is no multiple of 28, those from probe to probe of sh3_28");
  job.out.raw = true;
  job.out.stride = 12;
  EXPECT_EQ(Rejection(job, std::string(28, 'x')),
            "a stride of 12 bytes is less than the 13 of sh2_13");
  job = UnpackJob();
  job.out.stride = 114;
  EXPECT_EQ(Rejection(job, ProbeFile(GAUNT_FORMAT_SH3_28, RandomRecords(28))),
            "a stride of 114 bytes is no multiple of the 4 of a float");
}

TEST_F(Volume, RejectsVolumesThatDoNotFit) {
  const std::string six =
      ProbeFile(GAUNT_FORMAT_SH3_28, RandomRecords(6 * 28), {{1, 2, 3}, {}, {1, 1, 1}});
  ConvertJob job = TranscodeJob(GAUNT_FORMAT_SH3_28);
  job.blend = tool::ProbeBlend{{Path("other"), {}, 0}, 0.5f};
  Write(Path("other"), ProbeFile(GAUNT_FORMAT_SH3_28, RandomRecords(5 * 28)));
  EXPECT_EQ(Rejection(job, six), "has 5 probes, but " + Path("in") + " has 6");
  Write(Path("other"),
        ProbeFile(GAUNT_FORMAT_SH3_28, RandomRecords(6 * 28), {{6, 1, 1}, {}, {1, 1, 1}}));
  EXPECT_EQ(Rejection(job, six), "has a grid of 6 x 1 x 1, but " + Path("in") + " has 1 x 2 x 3");
  Write(Path("other"), six + "x");
  EXPECT_EQ(Rejection(job, six), "has bytes after its last probe");
  job.blend = {};
  job.out.grid = ProbeFileGrid{{4, 1, 1}, {}, {1, 1, 1}};
  EXPECT_EQ(Rejection(job, six), "has a grid of 4 x 1 x 1, but 6 probes");
}

TEST_F(Volume, RejectsFilesThatCannotBeReadOrWritten) {
  Write(Path("in"), ProbeFile(GAUNT_FORMAT_SH3_28, RandomRecords(28)));
  const auto run = [&](const std::string& in, const std::string& out) {
    ConvertJob job = UnpackJob();
    job.in.path = in;
    job.out.path = out;
    Convert(job);
  };
  EXPECT_THROW(run(Path("missing"), Path("out")), BadInput);
  EXPECT_THROW(run(folder_.string(), Path("out")), BadInput);
  EXPECT_THROW(run(Path("in"), folder_.string()), BadInput);
  EXPECT_THROW(run(Path("in"), Path("nowhere/out")), BadInput);
  EXPECT_THROW(run(Path("in"), ""), BadInput);
  EXPECT_EQ(FilesInFolder(), 1u);
  if (fs::exists("/dev/full")) {
    try {
      run(Path("in"), "/dev/full");
      ADD_FAILURE() << "wrote to a full device";
    } catch (const BadInput& error) {
      ADD_FAILURE() << error.what();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
  }
}

// Whatever is done to a file, it is unpacked whole or rejected in one line.
TEST_F(Volume, SurvivesMutations) {
  const std::string good = ProbeFile(GAUNT_FORMAT_SH2_13, RandomRecords(5 * 13));
  Random random(3);
  const auto below = [&](size_t n) { return static_cast<size_t>(random.Bits() % n); };
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes = good;
    for (size_t edits = 1 + below(3); edits > 0; --edits) {
      const size_t at = below(bytes.size()), length = below(bytes.size() - at);
      switch (below(4)) {
        case 0: bytes[at] = static_cast<char>(random.Bits()); break;
        case 1: bytes.erase(at, length); break;
        case 2: bytes.insert(at, bytes.substr(at, length)); break;
        default: bytes.replace(at, length, RandomRecords(length, random.Bits()));
      }
      if (bytes.empty()) bytes = "x";
    }
    const std::string message = Rejection(UnpackJob(), bytes);
    ASSERT_EQ(message == "accepted", bytes == good) << message;
    ASSERT_NE(message.rfind("names no file", 0), 0u) << message;
  }
}

// ---- the pipeline

struct Block {
  uint64_t number = 0;
};

TEST(Pipeline, WritesInOrder) {
  for (const uint64_t threads : {1, 2, 5, 16}) {
    uint64_t read = 0, written = 0;
    std::atomic<int> working{0};
    tool::Pipeline<Block>(
        [&](Block& block) {
          block.number = read;
          return read++ < 500;
        },
        [&](Block& block) {
          ++working;
          // Some take long.
          const auto until =
              std::chrono::steady_clock::now() + std::chrono::microseconds(block.number % 7 * 50);
          while (std::chrono::steady_clock::now() < until) std::this_thread::yield();
        },
        [&](Block& block) { EXPECT_EQ(block.number, written++); })
        .Run(threads);
    EXPECT_EQ(written, 500u);
    EXPECT_EQ(working, 500);
    EXPECT_EQ(read, 501u);
  }
}

TEST(Pipeline, ThrowsTheErrorOfTheFirstBlock) {
  enum Stage { kRead, kWork, kWrite };
  const auto error = [](uint64_t threads, Stage stage, uint64_t from) -> std::string {
    uint64_t read = 0, written = 0;
    const auto fail = [&](Stage here, uint64_t block) {
      if (here == stage && block >= from) throw std::runtime_error(std::to_string(block));
    };
    try {
      tool::Pipeline<Block>(
          [&](Block& block) {
            block.number = read++;
            fail(kRead, block.number);
            return block.number < 40;
          },
          [&](Block& block) {
            // The later ones fail first.
            if (block.number < from + 3) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            fail(kWork, block.number);
          },
          [&](Block& block) {
            fail(kWrite, block.number);
            EXPECT_EQ(block.number, written++);
          })
          .Run(threads);
    } catch (const std::runtime_error& thrown) {
      // All before it, and none after it, are written.
      EXPECT_EQ(written, from);
      return thrown.what();
    }
    return "none";
  };
  for (const uint64_t threads : {1, 2, 5, 16}) {
    for (const Stage stage : {kRead, kWork, kWrite}) {
      for (const uint64_t from : {0, 1, 17, 39}) {
        EXPECT_EQ(error(threads, stage, from), std::to_string(from));
      }
    }
    EXPECT_EQ(error(threads, kWork, 40), "none");
  }
}

}  // namespace
}  // namespace gaunt::test
