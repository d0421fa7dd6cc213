// SPDX-License-Identifier: MIT
// Wrong arguments of every projecting function: the status, and nothing written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "gaunt/gaunt.h"
#include "tests/support/guarded.h"
#include "tests/support/images.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

class ProjectArguments : public TargetTest {};

TEST_P(ProjectArguments, AreChecked) {
  TestImage test(8, 4, 3, Styles()[0]);
  TestCube cube(4, 3, Styles()[0]);
  float f[27];
  double sums[27];
  for (float& value : f) value = 5.0f;
  for (double& value : sums) value = 5.0;
  gaunt_view out;
  gaunt_view_interleaved(f, 27, &out);
  const gaunt_image* const image = test.image();
  float numbers[60] = {};
  gaunt_view d, v, w;
  gaunt_view_interleaved(numbers, 3, &d);
  gaunt_view_interleaved(numbers, 3, &v);
  gaunt_view_interleaved(numbers, 1, &w);
  using Options = gaunt_project_options;

  // Every function of an order and channels.
  const auto all = [&](uint32_t n, uint32_t channels, gaunt_status wanted) {
    EXPECT_EQ(gaunt_project_equirect(n, channels, image, nullptr, &out), wanted);
    EXPECT_EQ(gaunt_project_equirect_rows(n, channels, image, 0, 4, nullptr, sums), wanted);
    EXPECT_EQ(gaunt_project_cubemap(n, channels, cube.images(), nullptr, &out), wanted);
    EXPECT_EQ(gaunt_project_cubemap_rows(n, channels, 0, cube.images()[0], 0, nullptr, sums),
              wanted);
    EXPECT_EQ(gaunt_project_samples(n, channels, 9, &d, &v, &w, &out), wanted);
    EXPECT_EQ(gaunt_project_samples_add(n, channels, 9, &d, &v, &w, sums), wanted);
    EXPECT_EQ(gaunt_project_sums(n, channels, sums, &out), wanted);
  };
  all(0, 3, GAUNT_ERROR_ORDER);
  all(65, 3, GAUNT_ERROR_ORDER);
  all(3, 0, GAUNT_ERROR_RANGE);
  all(3, 5, GAUNT_ERROR_RANGE);

  // Every function of images.
  const auto changed = [&](gaunt_status wanted, auto change) {
    gaunt_image bad = *image;
    change(bad);
    EXPECT_EQ(gaunt_project_equirect(3, 3, &bad, nullptr, &out), wanted);
    EXPECT_EQ(gaunt_project_equirect_rows(3, 3, &bad, 0, 4, nullptr, sums), wanted);
    for (int k = 0; k < 6; ++k) {
      const gaunt_image* faces[6];
      std::copy(cube.images(), cube.images() + 6, faces);
      gaunt_image face = *faces[k];
      change(face);
      faces[k] = &face;
      EXPECT_EQ(gaunt_project_cubemap(3, 3, faces, nullptr, &out), wanted);
      EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, &face, 0, nullptr, sums), wanted);
    }
  };
  changed(GAUNT_ERROR_NULL, [](gaunt_image& i) { i.pixels = nullptr; });
  changed(GAUNT_ERROR_RANGE, [](gaunt_image& i) { i.width = 0; });
  changed(GAUNT_ERROR_RANGE, [](gaunt_image& i) { i.height = 0; });
  changed(GAUNT_ERROR_RANGE, [](gaunt_image& i) { i.width = 65537; });
  changed(GAUNT_ERROR_RANGE, [](gaunt_image& i) { i.height = 65537; });
  changed(GAUNT_ERROR_FORMAT, [](gaunt_image& i) { i.type = 9; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.pixel_stride = 8; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.pixel_stride = -8; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.pixel_stride = 13; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.pixel_stride = 14; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.row_stride = 2; });
  changed(GAUNT_ERROR_LAYOUT,
          [](gaunt_image& i) { i.pixels = static_cast<const char*>(i.pixels) + 2; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.type = GAUNT_TEXEL_F16, i.row_stride = 3; });
  changed(GAUNT_ERROR_LAYOUT, [](gaunt_image& i) { i.type = GAUNT_TEXEL_F16, i.pixel_stride = 4; });

  // Every function of options.
  const auto with = [&](gaunt_status wanted, const Options& options) {
    EXPECT_EQ(gaunt_project_equirect(3, 3, image, &options, &out), wanted);
    EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 0, 4, &options, sums), wanted);
    EXPECT_EQ(gaunt_project_cubemap(3, 3, cube.images(), &options, &out), wanted);
    EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, cube.images()[0], 0, &options, sums), wanted);
  };
  for (const uint32_t size : {0u, 4u, 7u, 9u, 11u, 13u, 16u}) {
    with(GAUNT_ERROR_STRUCT, {size, 0, GAUNT_CUBE_D3D});
  }
  with(GAUNT_ERROR_RANGE, {sizeof(Options), 2, GAUNT_CUBE_D3D});
  with(GAUNT_ERROR_RANGE, {8, 2, GAUNT_CUBE_D3D});
  with(GAUNT_ERROR_RANGE, {sizeof(Options), 0, 3});

  EXPECT_EQ(gaunt_project_equirect(3, 3, nullptr, nullptr, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_equirect(3, 3, image, nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, nullptr, 0, 4, nullptr, sums), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 0, 4, nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 0, 3, nullptr, sums), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 1, 4, nullptr, sums), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, UINT32_MAX, 4, nullptr, sums),
            GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 0, 65537, nullptr, sums), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_cubemap(3, 3, nullptr, nullptr, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_cubemap(3, 3, cube.images(), nullptr, nullptr), GAUNT_ERROR_NULL);
  for (int k = 0; k < 6; ++k) {
    const gaunt_image* faces[6];
    std::copy(cube.images(), cube.images() + 6, faces);
    faces[k] = nullptr;
    EXPECT_EQ(gaunt_project_cubemap(3, 3, faces, nullptr, &out), GAUNT_ERROR_NULL);
    gaunt_image other = *cube.images()[k];
    other.height = 3;
    faces[k] = &other;
    EXPECT_EQ(gaunt_project_cubemap(3, 3, faces, nullptr, &out), GAUNT_ERROR_RANGE);
    other.width = 3;
    EXPECT_EQ(gaunt_project_cubemap(3, 3, faces, nullptr, &out), GAUNT_ERROR_RANGE);
  }
  const gaunt_image* const face = cube.images()[0];
  EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 6, face, 0, nullptr, sums), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, nullptr, 0, nullptr, sums), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, face, 0, nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, face, 1, nullptr, sums), GAUNT_ERROR_RANGE);
  double* const askew = reinterpret_cast<double*>(reinterpret_cast<char*>(sums) + 4);
  EXPECT_EQ(gaunt_project_equirect_rows(3, 3, image, 0, 4, nullptr, askew), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_cubemap_rows(3, 3, 0, face, 0, nullptr, askew), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_samples_add(3, 3, 9, &d, &v, &w, askew), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_sums(3, 3, askew, &out), GAUNT_ERROR_LAYOUT);

  gaunt_view bad = out;
  bad.plane_stride = 2;
  EXPECT_EQ(gaunt_project_equirect(3, 3, image, nullptr, &bad), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_cubemap(3, 3, cube.images(), nullptr, &bad), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, &d, &v, &w, &bad), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_sums(3, 3, sums, &bad), GAUNT_ERROR_LAYOUT);
  bad = out;
  bad.plane_stride = 0;
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, &d, &v, &w, &bad), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, nullptr, &v, &w, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, &d, nullptr, &w, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, &d, &v, nullptr, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples(3, 3, 9, &d, &v, &w, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples(3, 3, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples_add(3, 3, 9, &d, &v, &w, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples_add(3, 3, 9, nullptr, &v, &w, sums), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_samples(3, 3, SIZE_MAX, &d, &v, &w, &out), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_project_sums(3, 3, nullptr, &out), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_project_sums(3, 3, sums, nullptr), GAUNT_ERROR_NULL);
  // Outputs over inputs.
  gaunt_view inside = out;
  inside.data = f + 2;
  EXPECT_EQ(gaunt_project_samples(3, 3, 5, &inside, &v, &w, &out), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_project_samples(3, 3, 5, &d, &v, &inside, &out), GAUNT_ERROR_OVERLAP);
  gaunt_view over_sums = out;
  over_sums.data = reinterpret_cast<float*>(sums);
  EXPECT_EQ(gaunt_project_samples_add(3, 3, 1, &over_sums, &v, &w, sums), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_project_sums(3, 3, sums, &over_sums), GAUNT_ERROR_OVERLAP);

  for (const float value : f) EXPECT_EQ(value, 5.0f);
  for (const double value : sums) EXPECT_EQ(value, 5.0);
}

TEST_P(ProjectArguments, OptionsOfTheFirstVersionAreValid) {
  TestCube cube(4, 1, Styles()[0]);
  cube.Fill([](int, int, int, int) { return -1.0; });
  // No byte beyond the size is read.
  GuardedBytes memory(8);
  const uint32_t first[2] = {8, GAUNT_PROJECT_CLAMP};
  std::memcpy(memory.data(), first, 8);
  float f[1] = {1.0f};
  gaunt_view out;
  gaunt_view_interleaved(f, 1, &out);
  const auto* const options = reinterpret_cast<const gaunt_project_options*>(memory.data());
  ASSERT_EQ(gaunt_project_cubemap(1, 1, cube.images(), options, &out), GAUNT_OK);
  EXPECT_EQ(f[0], 0.0f);
}

GAUNT_INSTANTIATE_TARGETS(ProjectArguments);

}  // namespace
}  // namespace gaunt::test
