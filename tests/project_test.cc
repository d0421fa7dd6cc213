// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "gaunt/gaunt.h"
#include "project/project_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

struct TestImage {
  std::vector<float> texels;
  gaunt_image image;
  int pixel_floats, row_floats;

  TestImage(uint32_t width, uint32_t height, int channels, int pixel_padding, int row_padding)
      : pixel_floats(channels + pixel_padding),
        row_floats(static_cast<int>(width) * pixel_floats + row_padding) {
    Random random(width * 131 + height);
    texels.assign(static_cast<size_t>(row_floats) * height, std::nanf(""));
    for (uint32_t y = 0; y < height; ++y) {
      for (uint32_t x = 0; x < width; ++x) {
        for (int c = 0; c < channels; ++c) {
          At(x, y)[c] = std::exp(random.Between(-3.0, 3.0));
        }
      }
    }
    image = {texels.data(),  width, height, pixel_floats * ptrdiff_t{4}, row_floats * ptrdiff_t{4},
             GAUNT_TEXEL_F32};
  }
  float* At(uint32_t x, uint32_t y) {
    return texels.data() + static_cast<ptrdiff_t>(y) * row_floats +
           static_cast<ptrdiff_t>(x) * pixel_floats;
  }
  double MeanMagnitude(int channels) {
    double sum = 0.0;
    for (uint32_t y = 0; y < image.height; ++y) {
      for (uint32_t x = 0; x < image.width; ++x) {
        for (int c = 0; c < channels; ++c) sum += std::abs(At(x, y)[c]);
      }
    }
    return sum / (double{1} * image.width * image.height * channels);
  }
};

class Project : public TargetTest {};

TEST_P(Project, MatchesTheDefinition) {
  const uint32_t sizes[][2] = {{1, 1},  {2, 1},   {1, 5},   {7, 3},
                               {16, 8}, {127, 5}, {129, 4}, {300, 40}};
  for (const auto& size : sizes) {
    for (const int channels : {1, 3, 4}) {
      for (const int padding : {0, 1, 2}) {
        TestImage image(size[0], size[1], channels, padding, padding);
        for (const uint32_t n : {1u, 3u, 6u}) {
          const size_t planes = static_cast<size_t>(channels) * n * n;
          for (const Layout layout : {Layout::kPlanar, Layout::kInterleaved, Layout::kTiled}) {
            Buffer out(layout, 1, planes);
            ASSERT_EQ(gaunt_project_equirect(n, static_cast<uint32_t>(channels), &image.image,
                                             nullptr, out.view()),
                      GAUNT_OK);
            ASSERT_TRUE(out.CanariesIntact());
            std::vector<double> wanted(planes);
            project::EquirectReference(static_cast<int>(n), channels, image.texels.data(),
                                       static_cast<int>(size[0]), static_cast<int>(size[1]),
                                       image.pixel_floats, image.row_floats, wanted.data());
            const double tolerance = 2e-6 * image.MeanMagnitude(channels) * 4.0 * std::acos(-1.0);
            for (size_t p = 0; p < planes; ++p) {
              ASSERT_NEAR(out.Get(0, p), wanted[p], tolerance)
                  << size[0] << "x" << size[1] << " plane " << p;
            }
          }
        }
      }
    }
  }
}

TEST_P(Project, ConstantLightIsAllMean) {
  TestImage image(256, 128, 3, 0, 0);
  for (float& texel : image.texels) texel = 2.0f;
  float f[27];
  gaunt_view out;
  gaunt_view_interleaved(f, 27, &out);
  ASSERT_EQ(gaunt_project_equirect(3, 3, &image.image, nullptr, &out), GAUNT_OK);
  for (int p = 0; p < 27; ++p) {
    // Midpoints of 128 rows leave 4e-4 of band 2.
    EXPECT_NEAR(f[p], p % 9 == 0 ? 4.0 * std::sqrt(std::acos(-1.0)) : 0.0, 1e-3);
  }
}

TEST_P(Project, AxesAreWhereTheManualSays) {
  TestImage image(64, 32, 1, 0, 0);
  for (float& texel : image.texels) texel = 0.0f;
  *image.At(32, 15) = *image.At(31, 15) = *image.At(32, 16) = *image.At(31, 16) = 1.0f;
  float f[4];
  gaunt_view out;
  gaunt_view_interleaved(f, 4, &out);
  ASSERT_EQ(gaunt_project_equirect(2, 1, &image.image, nullptr, &out), GAUNT_OK);
  EXPECT_GT(-f[3], 0.0f) << "the centre looks at +x";
  EXPECT_NEAR(f[1], 0.0f, 1e-6);
  EXPECT_NEAR(f[2], 0.0f, 1e-6);
  for (float& texel : image.texels) texel = 0.0f;
  *image.At(48, 15) = *image.At(48, 16) = 1.0f;
  ASSERT_EQ(gaunt_project_equirect(2, 1, &image.image, nullptr, &out), GAUNT_OK);
  EXPECT_LT(-f[1], 0.0f) << "right of the centre is -y";
  for (float& texel : image.texels) texel = 0.0f;
  *image.At(5, 0) = 1.0f;
  ASSERT_EQ(gaunt_project_equirect(2, 1, &image.image, nullptr, &out), GAUNT_OK);
  EXPECT_GT(f[2], 0.0f) << "the top row is +z";
}

TEST_P(Project, ClampsTexelsWhereAsked) {
  TestImage bad(40, 20, 3, 0, 0), good(40, 20, 3, 0, 0);
  const float values[] = {-1.0f, std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()};
  for (uint32_t k = 0; k < 60; ++k) {
    bad.At(k % 40, k % 20)[k % 3] = values[k % 4];
    good.At(k % 40, k % 20)[k % 3] = 0.0f;
  }
  float clamped[27], wanted[27], unclamped[27];
  gaunt_view out;
  gaunt_project_options options = {sizeof(options), GAUNT_PROJECT_CLAMP};
  gaunt_view_interleaved(clamped, 27, &out);
  ASSERT_EQ(gaunt_project_equirect(3, 3, &bad.image, &options, &out), GAUNT_OK);
  gaunt_view_interleaved(wanted, 27, &out);
  ASSERT_EQ(gaunt_project_equirect(3, 3, &good.image, nullptr, &out), GAUNT_OK);
  gaunt_view_interleaved(unclamped, 27, &out);
  ASSERT_EQ(gaunt_project_equirect(3, 3, &bad.image, nullptr, &out), GAUNT_OK);
  for (int p = 0; p < 27; ++p) {
    EXPECT_EQ(clamped[p], wanted[p]);
    EXPECT_TRUE(std::isnan(unclamped[p]));
  }
}

TEST_P(Project, RejectsWrongArguments) {
  TestImage test(8, 4, 3, 0, 0);
  float f[27];
  for (float& value : f) value = 5.0f;
  gaunt_view out;
  gaunt_view_interleaved(f, 27, &out);
  const auto project = [&](auto change) {
    gaunt_image image = test.image;
    change(image);
    return gaunt_project_equirect(3, 3, &image, nullptr, &out);
  };
  EXPECT_EQ(gaunt_project_equirect(0, 3, &test.image, nullptr, &out), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_project_equirect(7, 3, &test.image, nullptr, &out), GAUNT_ERROR_ORDER);
  EXPECT_EQ(gaunt_project_equirect(3, 0, &test.image, nullptr, &out), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_equirect(3, 5, &test.image, nullptr, &out), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_equirect(3, 3, nullptr, nullptr, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_equirect(3, 3, &test.image, nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(project([](gaunt_image& i) { i.pixels = nullptr; }), GAUNT_ERROR_NULL);
  EXPECT_EQ(project([](gaunt_image& i) { i.width = 0; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(project([](gaunt_image& i) { i.height = 0; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(project([](gaunt_image& i) { i.width = 65537; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(project([](gaunt_image& i) { i.type = 9; }), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(project([](gaunt_image& i) { i.pixel_stride = 8; }), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(project([](gaunt_image& i) { i.pixel_stride = 13; }), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(project([](gaunt_image& i) { i.row_stride = 2; }), GAUNT_ERROR_LAYOUT);
  gaunt_project_options options = {3, 0};
  EXPECT_EQ(gaunt_project_equirect(3, 3, &test.image, &options, &out), GAUNT_ERROR_STRUCT);
  options = {sizeof(options), 2};
  EXPECT_EQ(gaunt_project_equirect(3, 3, &test.image, &options, &out), GAUNT_ERROR_RANGE);
  for (const float value : f) EXPECT_EQ(value, 5.0f);
}

GAUNT_INSTANTIATE_TARGETS(Project);

}  // namespace
}  // namespace gaunt::test
