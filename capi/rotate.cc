// SPDX-License-Identifier: MIT
#include "rotate/rotate.h"

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::OutputOf;

namespace {

gaunt_status Rotate(const gaunt::rotate::RotateFn* kernels, size_t rotation_planes, uint32_t n,
                    uint32_t channels, size_t count, const gaunt_view* rotations,
                    const gaunt_view* in, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ROTATE_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  // In place on `in` only: a rotation may have as many planes as the output.
  GAUNT_CHECK(gaunt::capi::MemoryCheck(count).In(in, planes).OutInPlace(out, planes).status());
  GAUNT_CHECK(
      gaunt::capi::MemoryCheck(count).In(rotations, rotation_planes).Out(out, planes).status());
  if (count == 0) return GAUNT_OK;
  kernels[n](channels, count, InputOf(*rotations, count), InputOf(*in, count),
             OutputOf(*out, count));
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_rotate(uint32_t n, uint32_t channels, size_t count,
                          const gaunt_view* quaternions, const gaunt_view* in,
                          const gaunt_view* out) {
  return Rotate(gaunt::rotate::Kernels().quaternion, 4, n, channels, count, quaternions, in, out);
}

gaunt_status gaunt_rotate_matrix(uint32_t n, uint32_t channels, size_t count,
                                 const gaunt_view* matrices, const gaunt_view* in,
                                 const gaunt_view* out) {
  return Rotate(gaunt::rotate::Kernels().matrix, 9, n, channels, count, matrices, in, out);
}

gaunt_status gaunt_rotation_check(size_t count, const gaunt_view* matrices, float* worst) {
  GAUNT_REQUIRE(worst != nullptr, GAUNT_ERROR_NULL);
  GAUNT_CHECK(gaunt::capi::MemoryCheck(count).In(matrices, 9).status());
  *worst = count == 0 ? 0.0f
                      : gaunt::rotate::Kernels().deviation(count, InputOf(*matrices, count));
  return GAUNT_OK;
}

}  // extern "C"
