// SPDX-License-Identifier: MIT
#include "basis/basis.h"

#include "check.h"

using gaunt::basis::Kernels;
using gaunt::basis::kMaxUnrolled;
using gaunt::basis::kMaxUnrolledGradient;
using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

extern "C" {

gaunt_status gaunt_basis_eval(uint32_t n, size_t count, const gaunt_view* directions,
                              const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_CHECK(MemoryCheck(count).In(directions, 3).Out(out, n * n).status());
  if (count == 0) return GAUNT_OK;
  if (n <= kMaxUnrolled) {
    Kernels().eval[n](count, InputOf(*directions, count), OutputOf(*out, count));
  } else {
    Kernels().eval_any(static_cast<int>(n), count, InputOf(*directions, count),
                       OutputOf(*out, count));
  }
  return GAUNT_OK;
}

gaunt_status gaunt_basis_gradient(uint32_t n, size_t count, const gaunt_view* directions,
                                  const gaunt_view* d_dx, const gaunt_view* d_dy,
                                  const gaunt_view* d_dz) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(directions, 3)
                  .Out(d_dx, n * n)
                  .Out(d_dy, n * n)
                  .Out(d_dz, n * n)
                  .status());
  if (count == 0) return GAUNT_OK;
  const gaunt::simd::InView in = InputOf(*directions, count);
  const gaunt::simd::OutView dx = OutputOf(*d_dx, count), dy = OutputOf(*d_dy, count),
                             dz = OutputOf(*d_dz, count);
  if (n <= kMaxUnrolledGradient) {
    Kernels().gradient[n](count, in, dx, dy, dz);
  } else {
    Kernels().gradient_any(static_cast<int>(n), count, in, dx, dy, dz);
  }
  return GAUNT_OK;
}

gaunt_status gaunt_directions_normalize(size_t count, const gaunt_view* in, const gaunt_view* out) {
  GAUNT_CHECK(MemoryCheck(count).In(in, 3).OutInPlace(out, 3).status());
  if (count == 0) return GAUNT_OK;
  Kernels().normalize(count, InputOf(*in, count), OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
