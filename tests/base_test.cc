// SPDX-License-Identifier: MIT
// Version, statuses, targets and the helpers of views.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "gaunt/gaunt.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

TEST(Base, VersionIsTheHeaders) { EXPECT_EQ(gaunt_version(), uint32_t{GAUNT_VERSION}); }

TEST(Base, EveryStatusHasItsOwnText) {
  std::set<std::string> texts;
  for (gaunt_status status = 0; status >= GAUNT_ERROR_TARGET; --status) {
    texts.insert(gaunt_status_string(status));
  }
  EXPECT_EQ(texts.size(), 9u);
  EXPECT_STREQ(gaunt_status_string(1), "unknown status");
  EXPECT_STREQ(gaunt_status_string(INT32_MIN), "unknown status");
}

TEST(Base, TargetsCanBeSelected) {
  const std::vector<std::string> targets = SupportedTargets();
  ASSERT_FALSE(targets.empty());
  for (const std::string& target : targets) {
    EXPECT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    EXPECT_EQ(gaunt_target_name(), target);
  }
  EXPECT_EQ(gaunt_target_select("no such target"), GAUNT_ERROR_TARGET);
  EXPECT_EQ(gaunt_target_select(""), GAUNT_ERROR_TARGET);
  EXPECT_EQ(gaunt_target_name(), targets.back()) << "a failure changes nothing";
}

TEST(Base, TheEnvironmentNamesTheFirstTarget) {
  const std::vector<std::string> targets = SupportedTargets();
  setenv("GAUNT_TARGET", targets.back().c_str(), 1);
  EXPECT_EQ(gaunt_target_select(nullptr), GAUNT_OK);
  EXPECT_EQ(gaunt_target_name(), targets.back());
  setenv("GAUNT_TARGET", "no such target", 1);
  EXPECT_EQ(gaunt_target_select(nullptr), GAUNT_OK);
  EXPECT_EQ(gaunt_target_name(), targets.front());
  unsetenv("GAUNT_TARGET");
  EXPECT_EQ(gaunt_target_select(nullptr), GAUNT_OK);
  EXPECT_EQ(gaunt_target_name(), targets.front());
}

TEST(Base, PlaneStrideAvoidsPowersOfTwo) {
  for (size_t count = 0; count < 3000; ++count) {
    const size_t stride = gaunt_plane_stride(count);
    EXPECT_GE(stride, count * 4);
    EXPECT_EQ(stride / 64 % 2, 1u);
    EXPECT_EQ(stride % 64, 0u);
    EXPECT_LE(stride, count * 4 + 128);
  }
  EXPECT_EQ(gaunt_plane_stride(SIZE_MAX), 0u);
}

TEST(Base, ViewHelpersDescribeTheirLayouts) {
  float data[1];
  gaunt_view view;
  ASSERT_EQ(gaunt_view_planar(data, 4096, &view), GAUNT_OK);
  EXPECT_EQ(view.item_stride, 4);
  EXPECT_EQ(view.plane_stride, 4096);
  EXPECT_EQ(view.tile_items, 0u);
  ASSERT_EQ(gaunt_view_interleaved(data, 9, &view), GAUNT_OK);
  EXPECT_EQ(view.item_stride, 36);
  EXPECT_EQ(view.plane_stride, 4);
  ASSERT_EQ(gaunt_view_tiled(data, 9, &view), GAUNT_OK);
  EXPECT_EQ(view.item_stride, 4);
  EXPECT_EQ(view.plane_stride, 64);
  EXPECT_EQ(view.tile_stride, 576);
  EXPECT_EQ(view.tile_items, 16u);
  ASSERT_EQ(gaunt_view_broadcast(data, &view), GAUNT_OK);
  EXPECT_EQ(view.data, data);
  EXPECT_EQ(view.item_stride, 0);
  EXPECT_EQ(view.tile_stride, 0);
  EXPECT_EQ(gaunt_view_planar(data, 4, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_view_interleaved(data, 4, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_view_tiled(data, 4, nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_view_broadcast(data, nullptr), GAUNT_ERROR_NULL);
}

// Directions and the basis in the fields of one record, interleaved and in tiles.
TEST(Base, FieldsOfOneRecordDoNotOverlap) {
  constexpr size_t kCount = 40;
  std::vector<float> memory(48 * 12);
  gaunt_view directions, basis;
  gaunt_view_interleaved(memory.data(), 12, &directions);
  gaunt_view_interleaved(memory.data() + 3, 12, &basis);
  EXPECT_EQ(gaunt_basis_eval(3, kCount, &directions, &basis), GAUNT_OK);
  basis.data -= 1;
  EXPECT_EQ(gaunt_basis_eval(3, kCount, &directions, &basis), GAUNT_ERROR_OVERLAP);
  gaunt_view_tiled(memory.data(), 12, &directions);
  gaunt_view_tiled(memory.data() + 3 * 16, 12, &basis);
  EXPECT_EQ(gaunt_basis_eval(3, kCount, &directions, &basis), GAUNT_OK);
  basis.data -= 1;
  EXPECT_EQ(gaunt_basis_eval(3, kCount, &directions, &basis), GAUNT_ERROR_OVERLAP);
  basis.data += 2;  // the next tile's directions are in the way
  EXPECT_EQ(gaunt_basis_eval(3, kCount, &directions, &basis), GAUNT_ERROR_OVERLAP);
}

}  // namespace
}  // namespace gaunt::test
