// SPDX-License-Identifier: MIT
// Version, statuses, targets and the helpers of views.
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
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

TEST(Views, RejectMorePlanesThanThereIsMemory) {
  gaunt_view view = {nullptr, 1, 2, 3, 4};
  EXPECT_EQ(gaunt_view_tiled(nullptr, SIZE_MAX / 64, &view), GAUNT_ERROR_RANGE);
  EXPECT_EQ(gaunt_view_interleaved(nullptr, SIZE_MAX / 4, &view), GAUNT_ERROR_RANGE);
  EXPECT_EQ(view.item_stride, 1);
  EXPECT_EQ(gaunt_plane_stride(SIZE_MAX / 4), 0u);
}

#ifndef __SANITIZE_ADDRESS__

// Calls of the highest order, on a thread whose stack is what the manual promises.
void* CallOnSmallStack(void*) {
  constexpr uint32_t n = GAUNT_MAX_ORDER, kChannels = 4;
  constexpr size_t kPlanes = size_t{kChannels} * n * n, kCount = 5;
  static float d[kCount * 3], f[kCount * kPlanes], out[3][kCount * kPlanes];
  static double sums[kPlanes];
  for (size_t i = 0; i < kCount; ++i) d[3 * i + 2] = 1.0f;
  const auto view = [](float* data, size_t planes) {
    gaunt_view v;
    gaunt_view_interleaved(data, planes, &v);
    return v;
  };
  const gaunt_view vd = view(d, 3), vf = view(f, kPlanes), few = view(out[0], kChannels);
  const gaunt_view y[3] = {view(out[0], n * n), view(out[1], n * n), view(out[2], n * n)};
  const gaunt_view weights = view(f, 1), all = view(out[0], kPlanes);
  EXPECT_EQ(gaunt_basis_eval(n, kCount, &vd, &y[0]), GAUNT_OK);
  for (const uint32_t order : {4u, 5u, 6u, n}) {
    const gaunt_view g[3] = {view(out[0], order * order), view(out[1], order * order),
                             view(out[2], order * order)};
    EXPECT_EQ(gaunt_basis_gradient(order, kCount, &vd, &g[0], &g[1], &g[2]), GAUNT_OK);
  }
  EXPECT_EQ(gaunt_sh_evaluate(n, kChannels, kCount, &vf, &vd, &few), GAUNT_OK);
  EXPECT_EQ(gaunt_sh_dot(n, kChannels, kCount, &vf, &vf, &few), GAUNT_OK);
  EXPECT_EQ(gaunt_sh_blend(n, kChannels, kCount, &vf, &vf, &weights, &all), GAUNT_OK);
  EXPECT_EQ(gaunt_project_samples_add(n, kChannels, kCount, &vd, &few, &weights, sums), GAUNT_OK);
  const gaunt_view one = {d, 0, 4, 0, 0};
  for (const uint32_t order : {6u, n}) {
    const gaunt_view zonal = view(f, kChannels * order);
    const gaunt_view turned = view(out[0], kChannels * order * order);
    for (const gaunt_view* directions : {&vd, &one}) {
      EXPECT_EQ(gaunt_zonal_rotate_add(order, kChannels, kCount, &zonal, directions, &turned),
                GAUNT_OK);
    }
    EXPECT_EQ(gaunt_zonal_convolve(order, kChannels, kCount, &zonal, &turned, &turned), GAUNT_OK);
  }
  static float rotated[600 * kChannels * 16 * 16], rotations[600 * 9];
  for (size_t i = 0; i < 600 * 9; ++i) rotations[i] = static_cast<float>(i % 7) - 3.0f;
  const gaunt_view first = {rotations, 0, 4, 0, 0};
  for (const uint32_t order : {3u, 6u, 8u, 9u, 16u}) {
    const gaunt_view in_place = view(rotated, kChannels * order * order);
    const gaunt_view q = view(rotations, 4), m = view(rotations, 9);
    for (const bool for_all : {false, true}) {
      EXPECT_EQ(gaunt_rotate(order, kChannels, 600, for_all ? &first : &q, &in_place, &in_place),
                GAUNT_OK);
      EXPECT_EQ(
          gaunt_rotate_matrix(order, kChannels, 600, for_all ? &first : &m, &in_place, &in_place),
          GAUNT_OK);
    }
  }
  static float op[16384];
  for (const uint32_t order : {6u, 7u, 8u, 9u, 10u}) {
    const gaunt_view fa = view(f, kChannels * order * order);
    for (const uint32_t wide : {order, 2 * order - 1}) {
      const gaunt_view product = view(rotated, kChannels * wide * wide);
      EXPECT_EQ(gaunt_product(order, order, wide, kChannels, 5, &fa, &fa, &product), GAUNT_OK);
      EXPECT_EQ(gaunt_product_square(order, wide, kChannels, 5, &fa, &product), GAUNT_OK);
      size_t size = sizeof(op);
      EXPECT_EQ(gaunt_product_prepare(order, order, wide, &fa, op, &size), GAUNT_OK);
      EXPECT_EQ(gaunt_product_apply(op, size, kChannels, 5, &fa, &product), GAUNT_OK);
    }
    const gaunt_view zonal = view(f, kChannels * order);
    const gaunt_view product = view(rotated, kChannels * order * order);
    EXPECT_EQ(
        gaunt_product_zonal_axis(order, order, order, kChannels, 5, &zonal, &vd, &fa, &product),
        GAUNT_OK);
    EXPECT_EQ(gaunt_product_cosine_axis(order, kChannels, 5, &vd, &fa, &product), GAUNT_OK);
  }
  const gaunt_view values = view(out[1], kChannels);
  EXPECT_EQ(gaunt_project_samples(n, kChannels, kCount, &vd, &values, &weights, &all), GAUNT_OK);
  const gaunt_image image = {f, 32, 32, 16, 512, GAUNT_TEXEL_F32};
  const gaunt_image* const faces[6] = {&image, &image, &image, &image, &image, &image};
  for (const uint32_t order : {3u, 10u, n}) {
    const gaunt_view projected = view(out[0], kChannels * order * order);
    EXPECT_EQ(gaunt_project_equirect(order, kChannels, &image, nullptr, &projected), GAUNT_OK);
    EXPECT_EQ(gaunt_project_cubemap(order, kChannels, faces, nullptr, &projected), GAUNT_OK);
  }
  static uint32_t taps[kCount * 8];
  static float tap_weights[kCount * 8];
  static unsigned char records[108];
  gaunt_format_properties shape = {sizeof(shape), 0, 0, 0};
  for (uint32_t format = 1; gaunt_format_info(format, &shape) == GAUNT_OK; ++format) {
    const gaunt_view history = view(rotated, 27), turns = view(rotations, 4);
    const gaunt_view lit = view(out[0], 27), constants = view(out[1], 28);
    const gaunt_view light[3] = {view(f, 3), view(f + 3 * kCount, 3), view(f + 6 * kCount, 3)};
    gaunt_frame_job job = {};
    job.struct_size = sizeof(job);
    job.taps = 8;
    job.indices = taps;
    job.weights = tap_weights;
    job.packed = records;
    job.packed_count = 1;
    job.stride = shape.bytes;
    job.history = &history, job.alpha = &one, job.quaternions = &turns, job.radiance = &lit;
    job.directions = &light[0], job.colours = &light[1], job.ambient = &light[2];
    job.constants = &constants;
    EXPECT_EQ(gaunt_frame_light(format, kCount, &job), GAUNT_OK) << format;
  }
  gaunt_convention from = {sizeof(from), 0, 0, 0, 0, {}, 0}, to = from;
  EXPECT_EQ(gaunt_convention_preset(GAUNT_ENGINE_GAUNT, &from), GAUNT_OK);
  EXPECT_EQ(gaunt_convention_preset(GAUNT_ENGINE_THREEJS, &to), GAUNT_OK);
  EXPECT_EQ(gaunt_convert(16, kChannels, kCount, &from, &to, &vf, &all), GAUNT_OK);
  to.axes[0] = GAUNT_AXIS_FORWARD, to.axes[1] = GAUNT_AXIS_LEFT, to.axes[2] = GAUNT_AXIS_UP;
  EXPECT_EQ(gaunt_convert(n, kChannels, kCount, &from, &to, &vf, &all), GAUNT_OK);
  return nullptr;
}

TEST(Stack, IsWhatTheManualPromises) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  // What the test and the C library need comes on top; some systems want more in any case.
  constexpr size_t kPromised = 84 << 10, kOwn = 4 << 10;
  const size_t least = static_cast<size_t>(sysconf(_SC_THREAD_STACK_MIN));
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::max(kPromised + kOwn, least)), 0);
  for (const std::string& target : SupportedTargets()) {
    SCOPED_TRACE(target);
    ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, &CallOnSmallStack, nullptr), 0);
    pthread_join(thread, nullptr);
  }
  gaunt_target_select(nullptr);
  pthread_attr_destroy(&attributes);
}

#endif  // __SANITIZE_ADDRESS__

}  // namespace
}  // namespace gaunt::test
