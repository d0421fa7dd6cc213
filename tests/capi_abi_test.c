/* SPDX-License-Identifier: MIT */
/* The header is C99 and stands alone; sizes, offsets and values stay what they are. */
#include <stdio.h>

#include "gaunt/gaunt.h"

static int failures = 0;
#define EXPECT_SAME(value, wanted)                                        \
  do {                                                                    \
    const long long got = (long long)(value), want = (long long)(wanted); \
    if (got != want) {                                                    \
      printf("%s is %lld, expected %lld\n", #value, got, want);           \
      ++failures;                                                         \
    }                                                                     \
  } while (0)

int main(void) {
  const size_t word = sizeof(void*);
  EXPECT_SAME(GAUNT_OK, 0);
  EXPECT_SAME(GAUNT_ERROR_NULL, -1);
  EXPECT_SAME(GAUNT_ERROR_ORDER, -2);
  EXPECT_SAME(GAUNT_ERROR_LAYOUT, -3);
  EXPECT_SAME(GAUNT_ERROR_RANGE, -4);
  EXPECT_SAME(GAUNT_ERROR_OVERLAP, -5);
  EXPECT_SAME(GAUNT_ERROR_FORMAT, -6);
  EXPECT_SAME(GAUNT_ERROR_STRUCT, -7);
  EXPECT_SAME(GAUNT_ERROR_TARGET, -8);
  EXPECT_SAME(GAUNT_MAX_PRODUCT_ORDER, 10);
  EXPECT_SAME(GAUNT_MAX_AMBIENT_CUBE_ORDER, 6);
  EXPECT_SAME(GAUNT_AMBIENT_CUBE_PLANES, 18);
  EXPECT_SAME(GAUNT_AMBIENT_CUBE_LEAST_SQUARES, 1);
  EXPECT_SAME(GAUNT_AMBIENT_CUBE_SAMPLED, 2);
  EXPECT_SAME(GAUNT_FORMAT_SH3_28, 1);
  EXPECT_SAME(GAUNT_FORMAT_SH2_13, 2);
  EXPECT_SAME(GAUNT_FORMAT_SH3_32, 3);
  EXPECT_SAME(GAUNT_FORMAT_SH5_55, 4);
  EXPECT_SAME(GAUNT_FORMAT_SH3_F16, 5);
  EXPECT_SAME(GAUNT_FORMAT_SH3_F32, 6);
  EXPECT_SAME(GAUNT_FORMAT_UNREAL_28, 7);
  EXPECT_SAME(GAUNT_FORMAT_UNITY_L1_16, 8);
  EXPECT_SAME(GAUNT_FORMAT_UNITY_L2_32, 9);
  EXPECT_SAME(GAUNT_FORMAT_RGB9E5, 10);
  EXPECT_SAME(GAUNT_FORMAT_R11G11B10F, 11);
  EXPECT_SAME(GAUNT_NO_PROBE, 0xFFFFFFFFu);
  EXPECT_SAME(GAUNT_SENSE_RADIANCE, 0);
  EXPECT_SAME(GAUNT_SENSE_IRRADIANCE, 1);
  EXPECT_SAME(GAUNT_TEXEL_F32, 0);
  EXPECT_SAME(GAUNT_TEXEL_F16, 1);
  EXPECT_SAME(GAUNT_PROJECT_CLAMP, 1);
  EXPECT_SAME(GAUNT_CUBE_D3D, 0);
  EXPECT_SAME(GAUNT_CUBE_GL, 1);
  EXPECT_SAME(GAUNT_CUBE_UNITY, 2);
  EXPECT_SAME(GAUNT_REPORT_PLANES, 3);
  EXPECT_SAME(sizeof(gaunt_status), 4);
  EXPECT_SAME(sizeof(gaunt_view), 5 * word);
  EXPECT_SAME(offsetof(gaunt_view, data), 0);
  EXPECT_SAME(offsetof(gaunt_view, item_stride), word);
  EXPECT_SAME(offsetof(gaunt_view, plane_stride), 2 * word);
  EXPECT_SAME(offsetof(gaunt_view, tile_stride), 3 * word);
  EXPECT_SAME(offsetof(gaunt_view, tile_items), 4 * word);
  EXPECT_SAME(offsetof(gaunt_image, width), word);
  EXPECT_SAME(offsetof(gaunt_image, height), word + 4);
  EXPECT_SAME(offsetof(gaunt_image, pixel_stride), word + 8);
  EXPECT_SAME(offsetof(gaunt_image, row_stride), 2 * word + 8);
  EXPECT_SAME(offsetof(gaunt_image, type), 3 * word + 8);
  EXPECT_SAME(sizeof(gaunt_project_options), 12);
  EXPECT_SAME(offsetof(gaunt_project_options, cube), 8);
  EXPECT_SAME(sizeof(gaunt_format_properties), 16);
  EXPECT_SAME(sizeof(gaunt_grid), 56);
  EXPECT_SAME(offsetof(gaunt_grid, size), 4);
  EXPECT_SAME(offsetof(gaunt_grid, origin), 16);
  EXPECT_SAME(offsetof(gaunt_grid, spacing), 28);
  EXPECT_SAME(offsetof(gaunt_grid, first), 40);
  EXPECT_SAME(offsetof(gaunt_grid, strides), 44);
  EXPECT_SAME(sizeof(gaunt_brick_cell), 8);
  EXPECT_SAME(offsetof(gaunt_brick_cell, size), 4);
  EXPECT_SAME(sizeof(gaunt_bricks), 60);
  EXPECT_SAME(offsetof(gaunt_bricks, size), 4);
  EXPECT_SAME(offsetof(gaunt_bricks, origin), 16);
  EXPECT_SAME(offsetof(gaunt_bricks, spacing), 28);
  EXPECT_SAME(offsetof(gaunt_bricks, probes), 40);
  EXPECT_SAME(offsetof(gaunt_bricks, strides), 44);
  EXPECT_SAME(offsetof(gaunt_bricks, probe_count), 56);
  EXPECT_SAME(sizeof(gaunt_frame_job), 8 + 13 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, taps), 4);
  EXPECT_SAME(offsetof(gaunt_frame_job, indices), 8);
  EXPECT_SAME(offsetof(gaunt_frame_job, weights), 8 + word);
  EXPECT_SAME(offsetof(gaunt_frame_job, packed), 8 + 2 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, packed_count), 8 + 3 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, stride), 8 + 4 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, history), 8 + 5 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, alpha), 8 + 6 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, quaternions), 8 + 7 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, radiance), 8 + 8 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, directions), 8 + 9 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, colours), 8 + 10 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, ambient), 8 + 11 * word);
  EXPECT_SAME(offsetof(gaunt_frame_job, constants), 8 + 12 * word);
  EXPECT_SAME(GAUNT_SIGN_CONDON_SHORTLEY, 0);
  EXPECT_SAME(GAUNT_SIGN_POSITIVE, 1);
  EXPECT_SAME(GAUNT_COEFFICIENTS_ACN, 0);
  EXPECT_SAME(GAUNT_COEFFICIENTS_SID, 1);
  EXPECT_SAME(GAUNT_COEFFICIENTS_FUMA, 2);
  EXPECT_SAME(GAUNT_SCALE_ORTHONORMAL, 0);
  EXPECT_SAME(GAUNT_SCALE_N3D, 1);
  EXPECT_SAME(GAUNT_SCALE_SN3D, 2);
  EXPECT_SAME(GAUNT_SCALE_FUMA, 3);
  EXPECT_SAME(GAUNT_SCALE_POLYNOMIAL, 4);
  EXPECT_SAME(GAUNT_QUANTITY_RADIANCE, 0);
  EXPECT_SAME(GAUNT_QUANTITY_RADIANCE_OVER_PI, 1);
  EXPECT_SAME(GAUNT_QUANTITY_IRRADIANCE, 2);
  EXPECT_SAME(GAUNT_QUANTITY_IRRADIANCE_OVER_PI, 3);
  EXPECT_SAME(GAUNT_AXIS_RIGHT, 0);
  EXPECT_SAME(GAUNT_AXIS_LEFT, 1);
  EXPECT_SAME(GAUNT_AXIS_UP, 2);
  EXPECT_SAME(GAUNT_AXIS_DOWN, 3);
  EXPECT_SAME(GAUNT_AXIS_FORWARD, 4);
  EXPECT_SAME(GAUNT_AXIS_BACKWARD, 5);
  EXPECT_SAME(GAUNT_ENGINE_GAUNT, 0);
  EXPECT_SAME(GAUNT_ENGINE_D3DX, 1);
  EXPECT_SAME(GAUNT_ENGINE_UNREAL, 2);
  EXPECT_SAME(GAUNT_ENGINE_UNITY, 3);
  EXPECT_SAME(GAUNT_ENGINE_GODOT, 4);
  EXPECT_SAME(GAUNT_ENGINE_THREEJS, 5);
  EXPECT_SAME(GAUNT_ENGINE_FILAMENT, 6);
  EXPECT_SAME(GAUNT_ENGINE_GAUSSIAN_SPLATS, 7);
  EXPECT_SAME(GAUNT_ENGINE_AMBIX, 8);
  EXPECT_SAME(GAUNT_ENGINE_FUMA, 9);
  EXPECT_SAME(sizeof(gaunt_convention), 36);
  EXPECT_SAME(offsetof(gaunt_convention, sign), 4);
  EXPECT_SAME(offsetof(gaunt_convention, coefficients), 8);
  EXPECT_SAME(offsetof(gaunt_convention, scale), 12);
  EXPECT_SAME(offsetof(gaunt_convention, quantity), 16);
  EXPECT_SAME(offsetof(gaunt_convention, axes), 20);
  EXPECT_SAME(offsetof(gaunt_convention, offset), 32);
  EXPECT_SAME(gaunt_version(), GAUNT_VERSION);
  return failures == 0 ? 0 : 1;
}
