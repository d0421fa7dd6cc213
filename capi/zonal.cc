// SPDX-License-Identifier: MIT
#include "zonal/zonal.h"

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

gaunt_status Rotate(const gaunt::zonal::RotateFn* unrolled, gaunt::zonal::RotateAnyFn any,
                    uint32_t n, uint32_t channels, size_t count, const gaunt_view* zonal,
                    const gaunt_view* directions, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(zonal, channels * n)
                  .In(directions, 3)
                  .Out(out, channels * n * n)
                  .status());
  if (count == 0) return GAUNT_OK;
  if (n <= gaunt::kMaxUnrolledOrder) {
    unrolled[n](channels, count, InputOf(*zonal, count), InputOf(*directions, count),
                OutputOf(*out, count));
  } else {
    any(static_cast<int>(n), channels, count, InputOf(*zonal, count), InputOf(*directions, count),
        OutputOf(*out, count));
  }
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_zonal_rotate(uint32_t n, uint32_t channels, size_t count,
                                const gaunt_view* zonal, const gaunt_view* directions,
                                const gaunt_view* out) {
  const gaunt::zonal::Table& kernels = gaunt::zonal::Kernels();
  return Rotate(kernels.rotate, kernels.rotate_any, n, channels, count, zonal, directions, out);
}

gaunt_status gaunt_zonal_rotate_add(uint32_t n, uint32_t channels, size_t count,
                                    const gaunt_view* zonal, const gaunt_view* directions,
                                    const gaunt_view* out) {
  const gaunt::zonal::Table& kernels = gaunt::zonal::Kernels();
  return Rotate(kernels.rotate_add, kernels.rotate_add_any, n, channels, count, zonal, directions,
                out);
}

gaunt_status gaunt_zonal_convolve(uint32_t n, uint32_t channels, size_t count,
                                  const gaunt_view* kernel, const gaunt_view* in,
                                  const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  // In place on `in` only: at order 1 the kernel has as many planes as the output.
  GAUNT_CHECK(MemoryCheck(count).In(in, planes).OutInPlace(out, planes).status());
  GAUNT_CHECK(MemoryCheck(count).In(kernel, n).Out(out, planes).status());
  if (count == 0) return GAUNT_OK;
  const gaunt::zonal::Table& kernels = gaunt::zonal::Kernels();
  if (n <= gaunt::kMaxUnrolledOrder) {
    kernels.convolve[n](channels, count, InputOf(*kernel, count), InputOf(*in, count),
                        OutputOf(*out, count));
  } else {
    kernels.convolve_any(static_cast<int>(n), channels, count, InputOf(*kernel, count),
                         InputOf(*in, count), OutputOf(*out, count));
  }
  return GAUNT_OK;
}

}  // extern "C"
