// SPDX-License-Identifier: MIT
#include "check.h"
#include "simd/order.h"
#include "simd/target.h"

static_assert(GAUNT_MAX_ORDER == gaunt::kMaxOrder && GAUNT_MAX_CHANNELS == gaunt::kMaxChannels &&
                  GAUNT_MAX_LIGHT_ORDER == gaunt::kMaxUnrolledOrder,
              "the manual's limits are the kernels'");

extern "C" {

uint32_t gaunt_version(void) { return GAUNT_VERSION; }

const char* gaunt_status_string(gaunt_status status) {
  switch (status) {
    case GAUNT_OK: return "ok";
    case GAUNT_ERROR_NULL: return "a pointer that must not be NULL is NULL";
    case GAUNT_ERROR_ORDER: return "the function does not have this order";
    case GAUNT_ERROR_LAYOUT: return "strides or alignment are wrong, or an output overlaps itself";
    case GAUNT_ERROR_RANGE: return "a count, size or number is out of range";
    case GAUNT_ERROR_OVERLAP: return "an output overlaps an input or another output";
    case GAUNT_ERROR_FORMAT: return "unknown format or texel type, or not a prepared product or mesh";
    case GAUNT_ERROR_STRUCT: return "struct_size is wrong";
    case GAUNT_ERROR_TARGET: return "the SIMD target is unknown or does not run here";
    default: return "unknown status";
  }
}

const char* gaunt_target_name(void) { return gaunt::simd::ChosenTargetName(); }

const char* gaunt_target_supported(uint32_t index) {
  return gaunt::simd::SupportedTargetName(index);
}

gaunt_status gaunt_target_select(const char* name) {
  return gaunt::simd::SelectTarget(name) ? GAUNT_OK : GAUNT_ERROR_TARGET;
}

size_t gaunt_plane_stride(size_t count) {
  constexpr size_t kLine = 64;
  if (count > SIZE_MAX / sizeof(float) - 2 * kLine) return 0;
  return ((count * sizeof(float) + kLine - 1) / kLine | 1) * kLine;
}

gaunt_status gaunt_view_planar(float* data, ptrdiff_t plane_stride, gaunt_view* view) {
  GAUNT_REQUIRE(view != nullptr, GAUNT_ERROR_NULL);
  *view = {data, sizeof(float), plane_stride, 0, 0};
  return GAUNT_OK;
}

gaunt_status gaunt_view_interleaved(float* data, size_t planes, gaunt_view* view) {
  GAUNT_REQUIRE(view != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(planes <= PTRDIFF_MAX / sizeof(float), GAUNT_ERROR_RANGE);
  *view = {data, static_cast<ptrdiff_t>(planes * sizeof(float)), sizeof(float), 0, 0};
  return GAUNT_OK;
}

gaunt_status gaunt_view_tiled(float* data, size_t planes, gaunt_view* view) {
  GAUNT_REQUIRE(view != nullptr, GAUNT_ERROR_NULL);
  constexpr ptrdiff_t kPlane = GAUNT_TILE_ITEMS * sizeof(float);
  GAUNT_REQUIRE(planes <= static_cast<size_t>(PTRDIFF_MAX / kPlane), GAUNT_ERROR_RANGE);
  *view = {data, sizeof(float), kPlane, kPlane * static_cast<ptrdiff_t>(planes), GAUNT_TILE_ITEMS};
  return GAUNT_OK;
}

gaunt_status gaunt_view_broadcast(float* data, gaunt_view* view) {
  GAUNT_REQUIRE(view != nullptr, GAUNT_ERROR_NULL);
  *view = {data, 0, sizeof(float), 0, 0};
  return GAUNT_OK;
}

}  // extern "C"
