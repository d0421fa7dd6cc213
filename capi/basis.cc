// SPDX-License-Identifier: MIT
#include "basis/basis.h"

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::OutputOf;

extern "C" gaunt_status gaunt_basis_eval(uint32_t n, size_t count, const gaunt_view* directions,
                                         const gaunt_view* out) {
  GAUNT_REQUIRE(gaunt::capi::InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_CHECK(gaunt::capi::MemoryCheck(count).In(directions, 3).Out(out, n * n).status());
  if (count == 0) return GAUNT_OK;
  gaunt::basis::Kernels().eval[n](count, InputOf(*directions, count), OutputOf(*out, count));
  return GAUNT_OK;
}
