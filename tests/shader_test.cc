// SPDX-License-Identifier: MIT
// gaunt.glsl and gaunt.hlsl against the C library: run by Mesa's software renderer, in the shaders
// of tests/shader, and read as text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "basis/basis_reference.h"
#include "evaluate/constants.h"
#include "gaunt/gaunt.h"
#include "light/constants.h"
#include "probe/format.h"
#include "tests/support/compute.h"
#include "tests/support/random.h"

namespace gaunt::test {
namespace {

// What the heads of gaunt.glsl and gaunt.hlsl promise, in units of the norm of the coefficients.
constexpr double kTolerance = 1e-6;

constexpr size_t kItemsPerGroup = 64;  // as in tests/shader
constexpr size_t kCount = 64 * kItemsPerGroup;

std::string ReadFile(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The fields of one item, plane by plane.
template <class Item, size_t n>
gaunt_view View(std::vector<Item>& items, float (Item::*field)[n]) {
  return {items[0].*field, sizeof(Item), sizeof(float), 0, 0};
}

double Norm(const float* values, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += double{values[i]} * values[i];
  return std::sqrt(sum);
}

// A field of all items: |got - wanted| <= kTolerance * scale(item, plane).
template <class Item, size_t n, class Scale>
void ExpectClose(const std::string& name, const std::vector<Item>& got,
                 const std::vector<Item>& wanted, float (Item::*field)[n], const Scale& scale) {
  double worst = 0.0;
  size_t at = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    for (size_t p = 0; p < n; ++p) {
      const double difference = std::abs(double{(got[i].*field)[p]} - (wanted[i].*field)[p]);
      double error = difference == 0.0 ? 0.0 : difference / scale(i, p);
      if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
      if (error > worst) {
        worst = error;
        at = i;
      }
    }
  }
  testing::Test::RecordProperty(name, std::to_string(worst / kTolerance));
  EXPECT_LE(worst, kTolerance) << name << " of item " << at;
}

// The axes, the diagonals, then random ones.
void MakeDirection(Random& random, size_t item, float* d) {
  constexpr size_t kSpecial = 26;
  if (item >= kSpecial) return random.Direction(d);
  const size_t code = item < kSpecial / 2 ? item : item + 1;  // 13 is the zero vector
  const double v[3] = {code % 3 - 1.0, code / 3 % 3 - 1.0, code / 9 - 1.0};
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int k = 0; k < 3; ++k) d[k] = static_cast<float>(v[k] / length);
}

// Radiance as probes have it: an ambient light and some directional ones, of many magnitudes.
void MakeRadiance(Random& random, int order, float* f) {
  const auto n = static_cast<size_t>(order * order);
  std::vector<double> sum(3 * n, 0.0);
  const double scale = std::pow(10.0, random.Between(-4.0, 4.0));
  for (size_t c = 0; c < 3; ++c) sum[c * n] = scale * random.Between(0.1, 1.0);
  for (uint64_t lights = 1 + random.Bits() % 4; lights > 0; --lights) {
    float d[3];
    random.Direction(d);
    const double direction[3] = {d[0], d[1], d[2]};
    std::vector<double> y(n);
    basis::EvalReference(order, direction, y.data());
    for (size_t c = 0; c < 3; ++c) {
      const double colour = scale * random.Between(0.0, 3.0);
      for (size_t i = 0; i < n; ++i) sum[c * n + i] += colour * y[i];
    }
  }
  std::copy(sum.begin(), sum.end(), f);
}

// Runs on the shaders that came from one language.
class Shader : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    std::string reason;
    compute_ = Compute::Open(&reason);
    if (compute_ == nullptr) GTEST_SKIP() << "no software renderer: " << reason;
    RecordProperty("renderer", compute_->renderer());
  }

  template <class Out, class In>
  std::vector<Out> Run(const std::string& kernel, const std::vector<In>& in) {
    return Run<Out>(kernel, in.size(), in.data(), in.size() * sizeof(In));
  }
  template <class Out>
  std::vector<Out> Run(const std::string& kernel, size_t items, const void* in, size_t in_bytes) {
    const std::string path = std::string(GAUNT_SHADER_DIR "/") + kernel + "." + GetParam();
    const std::string source = ReadFile(path + ".comp");
    EXPECT_FALSE(source.empty()) << path;
    Out nothing;
    float* const values = reinterpret_cast<float*>(&nothing);
    std::fill(values, values + sizeof(Out) / sizeof(float), std::nanf(""));
    std::vector<Out> out(items, nothing);
    EXPECT_EQ(compute_->Run(source, items / kItemsPerGroup, in, in_bytes, out.data(),
                            out.size() * sizeof(Out)),
              "");
    return out;
  }

 private:
  std::unique_ptr<Compute> compute_;
};

// ---- basis, radiance, irradiance ---------------------------------------------------------------

struct EvaluateIn {
  float radiance[27];
  float direction[3];
  float matrix[16];  // of the red channel
};
struct EvaluateOut {
  float basis_2[4];
  float basis_3[9];
  float sh2_radiance[3];
  float sh3_radiance[3];
  float sh2_irradiance[3];
  float sh3_irradiance[3];
  float constants[28];
  float irradiance[3];
  float matrix[1];
};

TEST_P(Shader, EvaluatesAsTheLibrary) {
  Random random(1);
  std::vector<EvaluateIn> in(kCount);
  std::vector<EvaluateOut> wanted(kCount);
  std::vector<float> sh2(kCount * 12);
  for (size_t i = 0; i < kCount; ++i) {
    MakeDirection(random, i, in[i].direction);
    if (i % 4 == 3) {
      random.Fill(in[i].radiance, 27, -1.0, 1.0);
    } else {
      MakeRadiance(random, 3, in[i].radiance);
    }
    for (size_t p = 0; p < 12; ++p) sh2[12 * i + p] = in[i].radiance[p / 4 * 9 + p % 4];
  }
  const gaunt_view d = View(in, &EvaluateIn::direction), f3 = View(in, &EvaluateIn::radiance);
  gaunt_view f2;
  gaunt_view_interleaved(sh2.data(), 12, &f2);
  const auto out = [&](auto field) { return View(wanted, field); };
  const gaunt_view basis_2 = out(&EvaluateOut::basis_2), basis_3 = out(&EvaluateOut::basis_3);
  const gaunt_view radiance_2 = out(&EvaluateOut::sh2_radiance);
  const gaunt_view radiance_3 = out(&EvaluateOut::sh3_radiance);
  const gaunt_view irradiance_2 = out(&EvaluateOut::sh2_irradiance);
  const gaunt_view irradiance_3 = out(&EvaluateOut::sh3_irradiance);
  const gaunt_view constants = out(&EvaluateOut::constants);
  ASSERT_EQ(gaunt_basis_eval(2, kCount, &d, &basis_2), GAUNT_OK);
  ASSERT_EQ(gaunt_basis_eval(3, kCount, &d, &basis_3), GAUNT_OK);
  ASSERT_EQ(gaunt_sh_evaluate(2, 3, kCount, &f2, &d, &radiance_2), GAUNT_OK);
  ASSERT_EQ(gaunt_sh_evaluate(3, 3, kCount, &f3, &d, &radiance_3), GAUNT_OK);
  ASSERT_EQ(gaunt_irradiance_evaluate(2, 3, kCount, &f2, &d, &irradiance_2), GAUNT_OK);
  ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, kCount, &f3, &d, &irradiance_3), GAUNT_OK);
  ASSERT_EQ(gaunt_irradiance_constants(3, kCount, &f3, &constants), GAUNT_OK);
  // The matrix of the first channel: planes of records, as the channel's coefficients are.
  const gaunt_view matrix = View(in, &EvaluateIn::matrix);
  ASSERT_EQ(gaunt_irradiance_matrix(3, 1, kCount, &f3, &matrix), GAUNT_OK);
  for (size_t i = 0; i < kCount; ++i) {
    std::copy_n(wanted[i].sh3_irradiance, 3, wanted[i].irradiance);
    wanted[i].matrix[0] = wanted[i].sh3_irradiance[0];
  }

  const std::vector<EvaluateOut> got = Run<EvaluateOut>("evaluate", in);
  const auto one = [](size_t, size_t) { return 1.0; };
  const auto norm_2 = [&](size_t i, size_t c) { return Norm(in[i].radiance + 9 * c, 4); };
  const auto norm_3 = [&](size_t i, size_t c) { return Norm(in[i].radiance + 9 * c, 9); };
  const auto norm_of_constant = [&](size_t i, size_t p) {
    return p == 27 ? 1.0 : norm_3(i, p < 24 ? p % 12 / 4 : p - 24);
  };
  ExpectClose("basis_2", got, wanted, &EvaluateOut::basis_2, one);
  ExpectClose("basis_3", got, wanted, &EvaluateOut::basis_3, one);
  ExpectClose("sh2_radiance", got, wanted, &EvaluateOut::sh2_radiance, norm_2);
  ExpectClose("sh3_radiance", got, wanted, &EvaluateOut::sh3_radiance, norm_3);
  ExpectClose("sh2_irradiance", got, wanted, &EvaluateOut::sh2_irradiance, norm_2);
  ExpectClose("sh3_irradiance", got, wanted, &EvaluateOut::sh3_irradiance, norm_3);
  ExpectClose("irradiance_constants", got, wanted, &EvaluateOut::constants, norm_of_constant);
  ExpectClose("irradiance", got, wanted, &EvaluateOut::irradiance, norm_3);
  ExpectClose("irradiance_matrix", got, wanted, &EvaluateOut::matrix, norm_3);
}

// ---- ZH3 ---------------------------------------------------------------------------------------

struct Zh3In {
  float sh2[12];
  float k2[3];
  float normal[3];
  float curve[2];
};
struct Zh3Out {
  float axis[3];
  float axes[9];
  float zonal[1];
  float k2[3];
  float k2_axes[3];
  float curve[3];
  float irradiance[3];
  float irradiance_axes[3];
  float expanded[27];
};

// What a naive shader fails on, in seven items of eight.
void MakeZh3(Random& random, size_t item, Zh3In* in) {
  MakeRadiance(random, 2, in->sh2);
  const size_t channel = item / 8 % 3;
  float* const f = in->sh2 + 4 * channel;
  switch (item % 8) {
    case 1: f[0] = 0.0f; break;                     // no mean: 0 / 0
    case 2: f[0] = -f[0]; break;                    // a negative ratio
    case 3: f[0] *= 1e-6f; break;                   // a ratio beyond sqrt(3)
    case 4: std::fill(f + 1, f + 4, 0.0f); break;   // a channel without direction
    case 5: std::fill_n(in->sh2, 12, 0.0f); break;  // black
    case 6:                                         // ambient light only
      for (size_t p = 0; p < 12; ++p) in->sh2[p] = p % 4 == 0 ? in->sh2[p] : 0.0f;
      break;
    case 7:  // so dark that squares vanish
      for (float& value : in->sh2) value *= 1e-24f;
      break;
    default: break;
  }
  for (size_t c = 0; c < 3; ++c) {
    in->k2[c] = std::abs(in->sh2[4 * c]) * random.Between(-1.1, 2.2);
  }
}

// The unit vector along the optimal linear direction of band 1, or zero.
void Direction(const double band[3], double axis[3]) {
  const double v[3] = {-band[2], -band[0], band[1]};
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int k = 0; k < 3; ++k) axis[k] = length > 0.0 ? v[k] / length : 0.0;
}

double Curve(double mean, double along, double a, double b) {
  if (!(mean > 0.0)) return 0.0;
  const double r = std::min(std::abs(along) / mean, std::sqrt(3.0));
  return mean * (a * r + b * r * r);
}

// y_2m(axis) sqrt(4 pi / 5): the zonal function of band 2 and norm 1 about the axis.
void ZonalBand(const double axis[3], double out[5]) {
  double y[9];
  basis::EvalReference(3, axis, y);
  const bool none = axis[0] == 0.0 && axis[1] == 0.0 && axis[2] == 0.0;
  for (size_t m = 0; m < 5; ++m) out[m] = none ? 0.0 : std::sqrt(4.0 * kPi / 5.0) * y[4 + m];
}

// The definition of everything about one item but irradiance; and for that, ZH3 written out as
// order 3, with the shared axis and with one for each channel.
void Zh3Reference(const Zh3In& in, Zh3Out* out, float* expanded, float* expanded_axes) {
  double luminance[3] = {}, axes[4][3];  // the channels' and the shared one
  for (size_t c = 0; c < 3; ++c) {
    const float* f = in.sh2 + 4 * c;
    const double band[3] = {f[1], f[2], f[3]};
    Direction(band, axes[c]);
    for (size_t k = 0; k < 3; ++k) luminance[k] += light::kLuminance[c] * band[k];
  }
  Direction(luminance, axes[3]);
  std::copy_n(axes[0], 9, out->axes);
  std::copy_n(axes[3], 3, out->axis);
  double bands[4][5];
  for (size_t k = 0; k < 4; ++k) ZonalBand(axes[k], bands[k]);
  const double normal[3] = {in.normal[0], in.normal[1], in.normal[2]};
  double y[9], zonal = 0.0;
  basis::EvalReference(3, normal, y);
  for (size_t m = 0; m < 5; ++m) zonal += bands[3][m] * y[4 + m];
  out->zonal[0] = static_cast<float>(zonal);
  for (size_t c = 0; c < 3; ++c) {
    const float* f = in.sh2 + 4 * c;
    const auto along = [&](const double axis[3]) {
      return -axis[0] * f[3] - axis[1] * f[1] + axis[2] * f[2];
    };
    out->k2[c] = static_cast<float>(Curve(f[0], along(axes[3]), 0.08, 0.6));
    out->k2_axes[c] = static_cast<float>(Curve(f[0], along(axes[c]), 0.08, 0.6));
    out->curve[c] = static_cast<float>(Curve(f[0], f[2], in.curve[0], in.curve[1]));
    std::copy_n(f, 4, expanded + 9 * c);
    std::copy_n(f, 4, expanded_axes + 9 * c);
    for (size_t m = 0; m < 5; ++m) {
      expanded[9 * c + 4 + m] = static_cast<float>(in.k2[c] * bands[3][m]);
      expanded_axes[9 * c + 4 + m] = static_cast<float>(in.k2[c] * bands[c][m]);
    }
  }
}

TEST_P(Shader, Zh3AsTheLibrary) {
  Random random(2);
  std::vector<Zh3In> in(kCount);
  std::vector<Zh3Out> wanted(kCount);
  std::vector<float> expanded(27 * kCount), expanded_axes(27 * kCount);
  for (size_t i = 0; i < kCount; ++i) {
    MakeZh3(random, i, &in[i]);
    MakeDirection(random, i / 8, in[i].normal);  // each of them with each case
    const double root = std::sqrt(5.0 / 3.0);
    const double curves[3][2] = {{root, 0.0},
                                 {-root, 2.0 * std::sqrt(5.0) / 3.0},
                                 {random.Between(-1.0, 1.0), random.Between(-1.0, 1.0)}};
    std::copy_n(curves[i % 3], 2, in[i].curve);
    Zh3Reference(in[i], &wanted[i], &expanded[27 * i], &expanded_axes[27 * i]);
  }
  const gaunt_view normals = View(in, &Zh3In::normal);
  const gaunt_view irradiance = View(wanted, &Zh3Out::irradiance);
  const gaunt_view irradiance_axes = View(wanted, &Zh3Out::irradiance_axes);
  gaunt_view f, f_axes;
  gaunt_view_interleaved(expanded.data(), 27, &f);
  gaunt_view_interleaved(expanded_axes.data(), 27, &f_axes);
  ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, kCount, &f, &normals, &irradiance), GAUNT_OK);
  for (size_t i = 0; i < kCount; ++i) std::copy_n(&expanded[27 * i], 27, wanted[i].expanded);
  ASSERT_EQ(gaunt_irradiance_evaluate(3, 3, kCount, &f_axes, &normals, &irradiance_axes), GAUNT_OK);

  const std::vector<Zh3Out> got = Run<Zh3Out>("zh3", in);
  const auto one = [](size_t, size_t) { return 1.0; };
  const auto norm = [&](size_t i, size_t c) { return Norm(in[i].sh2 + 4 * c, 4); };
  const auto norm_3 = [&](size_t i, size_t c) { return Norm(&expanded[27 * i + 9 * c], 9); };
  ExpectClose("zh3_axis", got, wanted, &Zh3Out::axis, one);
  ExpectClose("zh3_axes", got, wanted, &Zh3Out::axes, one);
  ExpectClose("zh3_zonal", got, wanted, &Zh3Out::zonal, one);
  ExpectClose("zh3_hallucinate", got, wanted, &Zh3Out::k2, norm);
  ExpectClose("zh3_hallucinate_axes", got, wanted, &Zh3Out::k2_axes, norm);
  ExpectClose("zh3_curve", got, wanted, &Zh3Out::curve,
              [&](size_t i, size_t c) { return std::max(0.0, double{in[i].sh2[4 * c]}); });
  ExpectClose("zh3_irradiance", got, wanted, &Zh3Out::irradiance, norm_3);
  ExpectClose("zh3_irradiance_axes", got, wanted, &Zh3Out::irradiance_axes, norm_3);
  ExpectClose("zh3_expand", got, wanted, &Zh3Out::expanded,
              [&](size_t i, size_t p) { return norm_3(i, p / 9); });

  // The shared axis is the library's dominant light, wherever that has a direction.
  std::vector<Zh3Out> library(kCount);
  const gaunt_view sh2 = View(in, &Zh3In::sh2), directions = View(library, &Zh3Out::axis);
  ASSERT_EQ(gaunt_light_direction(2, 3, kCount, &sh2, nullptr, &directions), GAUNT_OK);
  for (size_t i = 0; i < kCount; i += 8) {
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(got[i].axis[k], library[i].axis[k], 1e-5) << i;
  }

  // And so are its k2 and E/pi, everywhere.
  const gaunt_view k2 = View(in, &Zh3In::k2);
  const gaunt_view out[] = {View(library, &Zh3Out::k2), View(library, &Zh3Out::k2_axes),
                            View(library, &Zh3Out::irradiance),
                            View(library, &Zh3Out::irradiance_axes)};
  for (size_t each = 0; each < 2; ++each) {
    const uint32_t mode = each == 0 ? GAUNT_ZH3_AXIS_LUMINANCE : GAUNT_ZH3_AXIS_CHANNEL;
    ASSERT_EQ(gaunt_zh3_hallucinate(GAUNT_ZH3_MODEL_CURVE, mode, kCount, &sh2, &out[each]),
              GAUNT_OK);
    ASSERT_EQ(gaunt_zh3_irradiance(mode, kCount, &sh2, &k2, &normals, &out[2 + each]), GAUNT_OK);
  }
  ExpectClose("zh3_hallucinate", got, library, &Zh3Out::k2, norm);
  ExpectClose("zh3_hallucinate_axes", got, library, &Zh3Out::k2_axes, norm);
  ExpectClose("zh3_irradiance", got, library, &Zh3Out::irradiance, norm_3);
  ExpectClose("zh3_irradiance_axes", got, library, &Zh3Out::irradiance_axes, norm_3);
  const gaunt_view sh3 = View(library, &Zh3Out::expanded);
  ASSERT_EQ(gaunt_zh3_expand(GAUNT_ZH3_AXIS_LUMINANCE, kCount, &sh2, &k2, &sh3), GAUNT_OK);
  ExpectClose("zh3_expand", got, library, &Zh3Out::expanded,
              [&](size_t i, size_t p) { return norm_3(i, p / 9); });
}

// ---- packed probes -----------------------------------------------------------------------------

// An item, and, behind all items, records of a format one after the other, wherever they begin.
struct ProbeIn {
  uint32_t format;
  uint32_t at;  // where the record begins, in bytes
  float normal[3];
};
struct ProbeOut {
  float radiance[75];
  float irradiance[3];
};

// What shaders decode: coefficients below `equal` exactly as gaunt_probe_decode().
struct Decoded {
  const char* name;
  uint32_t format;
  size_t equal;
};
constexpr size_t kProbes = 16 * kItemsPerGroup;  // of each format
constexpr Decoded kDecoded[] = {{"sh3_28", GAUNT_FORMAT_SH3_28, 9},
                                {"sh2_13", GAUNT_FORMAT_SH2_13, 4},
                                {"sh3_32", GAUNT_FORMAT_SH3_32, 9},
                                {"sh5_55", GAUNT_FORMAT_SH5_55, 25},
                                {"sh3_f16", GAUNT_FORMAT_SH3_F16, 9},
                                {"rgb9e5", GAUNT_FORMAT_RGB9E5, 1},
                                {"sh3_luma_12", GAUNT_FORMAT_SH3_LUMA_12, 9},
                                {"sh3_chroma_16", GAUNT_FORMAT_SH3_CHROMA_16, 1},
                                {"sh3_chroma_21", GAUNT_FORMAT_SH3_CHROMA_21, 1},
                                {"zh3_16", GAUNT_FORMAT_ZH3_16, 4},
                                {"zh3_luma_8", GAUNT_FORMAT_ZH3_LUMA_8, 4}};

gaunt_format_properties PropertiesOf(uint32_t format) {
  gaunt_format_properties properties = {};
  properties.struct_size = sizeof(properties);
  EXPECT_EQ(gaunt_format_info(format, &properties), GAUNT_OK);
  return properties;
}

// Random bytes, and extremes of those behind RGB9E5; every exponent of that, black, and the largest
// means.
void MakeRecord(Random& random, size_t item, size_t bytes, uint8_t* record) {
  const size_t kind = item / 32 % 8;
  constexpr uint8_t kEdges[8] = {0, 0, 0, 0x80, 0x81, 0x7F, 0, 0xFF};
  for (size_t k = 0; k < bytes; ++k) {
    record[k] = k < 4 || kind < 3 ? static_cast<uint8_t>(random.Bits()) : kEdges[kind];
  }
  constexpr uint32_t kMantissas = (1u << 27) - 1;
  uint32_t means;
  std::memcpy(&means, record, sizeof(means));
  means = (means & kMantissas) | static_cast<uint32_t>(item % 32) << 27;
  if (kind == 1) means &= ~kMantissas;
  if (kind == 2) means |= kMantissas;
  std::memcpy(record, &means, sizeof(means));
}

TEST_P(Shader, DecodesAsTheLibrary) {
  Random random(3);
  const size_t items = std::size(kDecoded) * kProbes;
  std::vector<ProbeIn> in(items);
  std::vector<uint8_t> records;
  std::vector<ProbeOut> wanted(items);
  for (size_t f = 0; f < std::size(kDecoded); ++f) {
    SCOPED_TRACE(kDecoded[f].name);
    const uint32_t format = kDecoded[f].format;
    const gaunt_format_properties properties = PropertiesOf(format);
    const size_t begin = records.size();
    records.resize(begin + kProbes * properties.bytes);
    for (size_t i = 0; i < kProbes; ++i) {
      const size_t at = begin + i * properties.bytes;
      MakeRecord(random, i, properties.bytes, &records[at]);
      ProbeIn& item = in[f * kProbes + i];
      item.format = format;
      item.at = static_cast<uint32_t>(items * sizeof(ProbeIn) + at);
      MakeDirection(random, i, item.normal);
    }
    constexpr size_t kIn = sizeof(ProbeIn), kOut = sizeof(ProbeOut), kFloat = sizeof(float);
    const gaunt_view normals = {in[f * kProbes].normal, kIn, kFloat, 0, 0};
    const gaunt_view radiance = {wanted[f * kProbes].radiance, kOut, kFloat, 0, 0};
    const gaunt_view irradiance = {wanted[f * kProbes].irradiance, kOut, kFloat, 0, 0};
    ASSERT_EQ(gaunt_probe_decode(format, kProbes, &records[begin], properties.bytes, &radiance),
              GAUNT_OK);
    ASSERT_EQ(
        gaunt_irradiance_evaluate(properties.order, 3, kProbes, &radiance, &normals, &irradiance),
        GAUNT_OK);
  }
  // As gaunt_word() asks for, a word more than the records fill.
  std::vector<uint8_t> buffer(items * sizeof(ProbeIn) + (records.size() + 3) / 4 * 4 + 4, 0xFF);
  std::memcpy(buffer.data(), in.data(), items * sizeof(ProbeIn));
  std::copy(records.begin(), records.end(), buffer.begin() + items * sizeof(ProbeIn));

  const std::vector<ProbeOut> all = Run<ProbeOut>("probe", items, buffer.data(), buffer.size());
  for (size_t f = 0; f < std::size(kDecoded); ++f) {
    const std::string name = kDecoded[f].name;
    const size_t order = PropertiesOf(kDecoded[f].format).order, size = order * order;
    const std::vector<ProbeOut> got(&all[f * kProbes], &all[f * kProbes] + kProbes);
    const std::vector<ProbeOut> library(&wanted[f * kProbes], &wanted[f * kProbes] + kProbes);
    const auto largest = [&](size_t i, size_t coefficients) {  // of a channel: colours mix them
      const float* const v = library[i].radiance;
      return std::max(
          {Norm(v, coefficients), Norm(v + size, coefficients), Norm(v + 2 * size, coefficients)});
    };
    ExpectClose(name, got, library, &ProbeOut::radiance, [&](size_t i, size_t p) {
      return p % size < kDecoded[f].equal ? 0.0 : probe::kAxialRange * largest(i, 1);
    });
    ExpectClose(name + " irradiance", got, library, &ProbeOut::irradiance,
                [&](size_t i, size_t) { return largest(i, size); });
  }
}

INSTANTIATE_TEST_SUITE_P(, Shader, testing::Values("glsl", "hlsl"),
                         [](const auto& language) { return std::string(language.param); });

// ---- the text ----------------------------------------------------------------------------------

class ShaderText : public testing::TestWithParam<const char*> {
 protected:
  const std::string text_ = ReadFile(std::string(GAUNT_INCLUDE_DIR "/gaunt.") + GetParam());
};

TEST_P(ShaderText, ConstantsAreTheLibrarys) {
  const auto basis = [](size_t i, double x, double y, double z) {
    const double d[3] = {x, y, z};
    double values[25];
    basis::EvalReference(5, d, values);
    return values[i];
  };
  const double diagonal = std::sqrt(0.5);
  using Irradiance = evaluate::QuadraticConstants<evaluate::IrradianceBands>;
  const std::map<std::string, double> library = {
      {"Y0", basis(0, 0, 0, 1)},
      {"Y1", basis(2, 0, 0, 1)},
      {"Y2", basis(4, diagonal, diagonal, 0) * 2.0},
      {"Y20", basis(6, 0, 0, 1) / 2.0},
      {"Y22", basis(8, 1, 0, 0)},
      {"C0", Irradiance::kMean},
      {"C1", Irradiance::kLinear},
      {"C2", Irradiance::kProduct},
      {"C3", -Irradiance::kOffset},
      {"C4", Irradiance::kDifference},
      {"C40", -evaluate::CosineBand(4) * basis(20, 0, 0, 1) / 8.0},
      {"C41", evaluate::CosineBand(4) * basis(21, diagonal, 0, diagonal) * 4.0},
      {"C42", evaluate::CosineBand(4) * basis(22, 1, 0, 0)},
      {"C43", evaluate::CosineBand(4) * basis(23, diagonal, 0, diagonal) * 4.0},
      {"C44", -evaluate::CosineBand(4) * basis(24, 1, 0, 0)},
      {"COSINE_2", evaluate::CosineBand(2)},
      {"MAX_RATIO", probe::Bound(1)},
      {"LUMINANCE_R", light::kLuminance[0]},
      {"LUMINANCE_G", light::kLuminance[1]},
      {"LUMINANCE_B", light::kLuminance[2]},
      {"ZH3_A", 0.08},
      {"ZH3_B", 0.6},
      {"ZONAL_2", std::sqrt(4.0 * kPi / 5.0)},
      {"STEP_1", probe::Bound(1) / 127.0},
      {"STEP_2", probe::Bound(4) / 127.0},
      {"STEP_20", probe::Bound(6) / 127.0},
      {"STEP_40", probe::Bound(20) / 127.0},
      {"STEP_41", probe::Bound(21) / 127.0},
      {"STEP_42", probe::Bound(22) / 127.0},
      {"STEP_43", probe::Bound(23) / 127.0},
      {"STEP_44", probe::Bound(24) / 127.0},
      {"COLOUR_1", probe::SharedFormat::ColourRange(1)},
      {"COLOUR_2", probe::SharedFormat::ColourRange(4)}};
  size_t found = 0;
  std::istringstream lines(text_);
  for (std::string line; std::getline(lines, line);) {
    const std::string start = "const float GAUNT_";
    const size_t name_at = line.find(start) + start.size(), equals = line.find(" = ");
    if (line.find(start) == std::string::npos) continue;
    SCOPED_TRACE(line);
    const auto wanted = library.find(line.substr(name_at, equals - name_at));
    ASSERT_NE(wanted, library.end());
    char* rest = nullptr;
    const double value = std::strtod(line.c_str() + equals + 3, &rest);
    EXPECT_EQ(*rest, ';');
    EXPECT_NEAR(value, wanted->second, 1e-14);
    EXPECT_EQ(static_cast<float>(value), static_cast<float>(wanted->second));
    ++found;
  }
  EXPECT_EQ(found, library.size());
}

INSTANTIATE_TEST_SUITE_P(, ShaderText, testing::Values("glsl", "hlsl"),
                         [](const auto& language) { return std::string(language.param); });

// The names of the functions, in order.
std::vector<std::string> Functions(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    // "type gaunt_name(" at the start of a line.
    const size_t space = line.find(' ');
    const std::string start = " gaunt_";
    if (std::isalpha(static_cast<unsigned char>(line[0])) != 0 &&
        line.compare(std::min(space, line.size()), start.size(), start) == 0) {
      names.push_back(line.substr(space + 1, line.find('(') - space - 1));
    }
  }
  return names;
}

TEST(ShaderTexts, HaveTheSameFunctions) {
  const std::vector<std::string> names = Functions(ReadFile(GAUNT_INCLUDE_DIR "/gaunt.glsl"));
  EXPECT_FALSE(names.empty());
  EXPECT_EQ(names, Functions(ReadFile(GAUNT_INCLUDE_DIR "/gaunt.hlsl")));
}

}  // namespace
}  // namespace gaunt::test
