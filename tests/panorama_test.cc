// SPDX-License-Identifier: MIT
// What holds for any light, on real light: projections of real panoramas, turned, mirrored, and
// converted.
#include "tests/support/panorama.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "formats/format_error.h"
#include "project/project_reference.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

class Panoramic : public TargetTest {
 protected:
  void SetUp() override {
    TargetTest::SetUp();
    if (Panoramas().empty()) GTEST_SKIP() << "no panoramas: install Debian's blender-data";
  }
};

std::vector<float> Project(uint32_t n, const gaunt_image& image) {
  std::vector<float> f(3 * n * n);
  gaunt_view out;
  gaunt_view_interleaved(f.data(), f.size(), &out);
  EXPECT_EQ(gaunt_project_equirect(n, 3, &image, nullptr, &out), GAUNT_OK);
  return f;
}

double Norm(const std::vector<float>& f) {
  double sum = 0.0;
  for (const float x : f) sum += double{x} * double{x};
  return std::sqrt(sum);
}

void ExpectClose(const std::vector<float>& got, const std::vector<float>& wanted, double relative) {
  const double norm = Norm(wanted);
  for (size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(got[i], wanted[i], relative * norm) << i;
}

std::vector<float> Rotate(const std::vector<float>& f, const float quaternion[4]) {
  std::vector<float> in = f, out(f.size());
  float q[4];
  std::copy(quaternion, quaternion + 4, q);
  gaunt_view vq, vi, vo;
  gaunt_view_interleaved(q, 4, &vq);
  gaunt_view_interleaved(in.data(), in.size(), &vi);
  gaunt_view_interleaved(out.data(), out.size(), &vo);
  EXPECT_EQ(gaunt_rotate(3, 3, 1, &vq, &vi, &vo), GAUNT_OK);
  return out;
}

TEST_P(Panoramic, ProjectionMatchesTheDefinition) {
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    // The definition is slow: every eighth row, as an image of its own.
    gaunt_image rows = panorama.image;
    rows.row_stride *= 8;
    rows.height /= 8;
    const std::vector<float> got = Project(4, rows);
    std::vector<double> wanted(got.size());
    const auto texel = [&](int column, int row, int channel) {
      const size_t at = static_cast<size_t>(8 * row) * rows.width + static_cast<size_t>(column);
      return double{panorama.texels[3 * at + static_cast<size_t>(channel)]};
    };
    project::EquirectReference(4, 3, static_cast<int>(rows.width), static_cast<int>(rows.height),
                               texel, wanted.data());
    ExpectClose(got, std::vector<float>(wanted.begin(), wanted.end()), 1e-6);
  }
}

// A panorama that is shifted by a quarter of its columns is the light turned by a quarter.
TEST_P(Panoramic, ShiftedColumnsAreARotation) {
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    const std::vector<float> f = Project(3, panorama.image);
    std::vector<float> shifted = panorama.texels;
    const size_t row = size_t{3} * panorama.image.width;
    for (size_t y = 0; y < panorama.image.height; ++y) {
      const auto begin = shifted.begin() + static_cast<ptrdiff_t>(y * row);
      std::rotate(begin, begin + static_cast<ptrdiff_t>(row / 4),
                  begin + static_cast<ptrdiff_t>(row));
    }
    gaunt_image image = panorama.image;
    image.pixels = shifted.data();
    // Columns move to the left, where azimuths grow.
    const float turn[4] = {0.0f, 0.0f, std::sqrt(0.5f), std::sqrt(0.5f)};
    ExpectClose(Project(3, image), Rotate(f, turn), 1e-6);
  }
}

TEST_P(Panoramic, RotationsGoRoundTrip) {
  Random random(9);
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    const std::vector<float> f = Project(3, panorama.image);
    std::vector<float> turned = f;
    for (int trial = 0; trial < 20; ++trial) {
      float q[4];
      random.Fill(q, 4, -1.0, 1.0);
      const float back[4] = {-q[0], -q[1], -q[2], q[3]};
      turned = Rotate(Rotate(turned, q), back);
    }
    ExpectClose(turned, f, 1e-5);
  }
}

// From engine to engine, and back to where it began; E goes by E only, and FuMa ends at order 4.
TEST_P(Panoramic, ConventionsGoRoundTrip) {
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    const std::vector<float> f = Project(3, panorama.image);
    std::vector<float> converted = f;
    gaunt_view view;
    gaunt_view_interleaved(converted.data(), converted.size(), &view);
    gaunt_convention from = {sizeof(from), 0, 0, 0, 0, {}, 0}, to = from;
    ASSERT_EQ(gaunt_convention_preset(GAUNT_ENGINE_GAUNT, &from), GAUNT_OK);
    for (uint32_t engine = GAUNT_ENGINE_D3DX; engine <= GAUNT_ENGINE_FUMA; ++engine) {
      ASSERT_EQ(gaunt_convention_preset(engine, &to), GAUNT_OK);
      ASSERT_EQ(gaunt_convert(3, 3, 1, &from, &to, &view, &view), GAUNT_OK) << engine;
      from = to;
    }
    ASSERT_EQ(gaunt_convention_preset(GAUNT_ENGINE_GAUNT, &to), GAUNT_OK);
    ASSERT_EQ(gaunt_convert(3, 3, 1, &from, &to, &view, &view), GAUNT_OK);
    ExpectClose(converted, f, 2e-6);
  }
}

TEST_P(Panoramic, MirroredColumnsAreAnotherHand) {
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    std::vector<float> f = Project(3, panorama.image), mirrored(f.size());
    // From right to left, the columns are those of a world in a mirror: y points the other way.
    gaunt_image image = panorama.image;
    image.pixels = panorama.texels.data() + 3 * (image.width - 1);
    image.pixel_stride = -image.pixel_stride;
    gaunt_convention from = {sizeof(from), 0, 0, 0, 0, {}, 0};
    ASSERT_EQ(gaunt_convention_preset(GAUNT_ENGINE_GAUNT, &from), GAUNT_OK);
    gaunt_convention to = from;
    to.axes[1] = GAUNT_AXIS_RIGHT;
    gaunt_view in, out;
    gaunt_view_interleaved(f.data(), f.size(), &in);
    gaunt_view_interleaved(mirrored.data(), f.size(), &out);
    ASSERT_EQ(gaunt_convert(3, 3, 1, &from, &to, &in, &out), GAUNT_OK);
    ExpectClose(Project(3, image), mirrored, 1e-6);
  }
}

// Clamping takes the slightly negative texels of the files away, and nothing else.
TEST_P(Panoramic, ClampingRemovesLittle) {
  for (const Panorama& panorama : Panoramas()) {
    SCOPED_TRACE(panorama.name);
    const gaunt_project_options options = {sizeof(options), GAUNT_PROJECT_CLAMP, GAUNT_CUBE_D3D};
    std::vector<float> clamped(27);
    gaunt_view out;
    gaunt_view_interleaved(clamped.data(), 27, &out);
    ASSERT_EQ(gaunt_project_equirect(3, 3, &panorama.image, &options, &out), GAUNT_OK);
    const std::vector<float> f = Project(3, panorama.image);
    for (size_t c = 0; c < 3; ++c) EXPECT_GE(clamped[9 * c], f[9 * c] * (1.0f - 1e-6f));
    ExpectClose(clamped, f, 1e-3);
  }
}

// What a format adds to the error of the same order unpacked, the mean over all panoramas.
TEST_P(Panoramic, FormatsOfOrder3AddLittle) {
  const auto added = [](uint32_t format) {
    double sum = 0.0;
    for (const Panorama& panorama : Panoramas()) {
      const tool::Light light = tool::ProjectLight(panorama.image);
      sum += tool::ErrorOfFormat(format, false, light).rms - tool::ErrorOfOrder(3, light).rms;
    }
    return sum / static_cast<double>(Panoramas().size());
  };
  EXPECT_LE(added(GAUNT_FORMAT_SH3_28), 0.0005);
  EXPECT_LE(added(GAUNT_FORMAT_SH3_32), 0.0005);
  EXPECT_LE(added(GAUNT_FORMAT_SH3_CHROMA_21), 0.0025);
  EXPECT_LE(added(GAUNT_FORMAT_SH3_CHROMA_16), 0.0095);
}

GAUNT_INSTANTIATE_TARGETS(Panoramic);

}  // namespace
}  // namespace gaunt::test
