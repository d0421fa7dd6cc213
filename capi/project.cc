// SPDX-License-Identifier: MIT
#include "project/project.h"

#include <cstring>

#include "check.h"

using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

constexpr uint32_t kMaxSize = 65536;

gaunt_status CheckImage(const gaunt_image* image, uint32_t channels) {
  GAUNT_REQUIRE(image != nullptr && image->pixels != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(image->type == GAUNT_TEXEL_F32, GAUNT_ERROR_FORMAT);
  GAUNT_REQUIRE(InRange(image->width, 1, kMaxSize) && InRange(image->height, 1, kMaxSize),
                GAUNT_ERROR_RANGE);
  constexpr ptrdiff_t kFloat = sizeof(float);
  GAUNT_REQUIRE(reinterpret_cast<uintptr_t>(image->pixels) % alignof(float) == 0 &&
                    image->pixel_stride % kFloat == 0 && image->row_stride % kFloat == 0,
                GAUNT_ERROR_LAYOUT);
  const ptrdiff_t texel = static_cast<ptrdiff_t>(channels) * kFloat;
  GAUNT_REQUIRE(image->width == 1 || image->pixel_stride >= texel || image->pixel_stride <= -texel,
                GAUNT_ERROR_LAYOUT);
  return GAUNT_OK;
}

}  // namespace

extern "C" gaunt_status gaunt_project_equirect(uint32_t n, uint32_t channels,
                                               const gaunt_image* image,
                                               const gaunt_project_options* options,
                                               const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, gaunt::kMaxUnrolledOrder), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(CheckImage(image, channels));
  uint32_t flags = 0;
  if (options != nullptr) {
    GAUNT_REQUIRE(options->struct_size == sizeof(*options), GAUNT_ERROR_STRUCT);
    GAUNT_REQUIRE((options->flags & ~static_cast<uint32_t>(GAUNT_PROJECT_CLAMP)) == 0,
                  GAUNT_ERROR_RANGE);
    flags = options->flags;
  }
  const size_t planes = channels * n * n;
  GAUNT_CHECK(MemoryCheck(1).Out(out, planes).status());

  double sums[GAUNT_MAX_CHANNELS * 36] = {};
  const gaunt::project::Image pixels = {static_cast<const unsigned char*>(image->pixels),
                                        image->width, image->height, image->pixel_stride,
                                        image->row_stride};
  gaunt::project::Kernels().equirect(static_cast<int>(n), channels, pixels, 0, image->height,
                                     (flags & GAUNT_PROJECT_CLAMP) != 0, sums);
  const gaunt::simd::OutView view = OutputOf(*out, 1);
  for (size_t p = 0; p < planes; ++p) {
    const float sum = static_cast<float>(sums[p]);
    std::memcpy(view.FromPlane(p).data, &sum, sizeof(sum));
  }
  return GAUNT_OK;
}
