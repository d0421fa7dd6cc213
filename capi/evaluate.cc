// SPDX-License-Identifier: MIT
#include "evaluate/evaluate.h"

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

gaunt_status Evaluate(const gaunt::evaluate::EvaluateFn* unrolled,
                      gaunt::evaluate::EvaluateAnyFn any, uint32_t n, uint32_t channels,
                      size_t count, const gaunt_view* coefficients, const gaunt_view* directions,
                      const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(coefficients, channels * n * n)
                  .In(directions, 3)
                  .Out(out, channels)
                  .status());
  if (count == 0) return GAUNT_OK;
  if (n <= gaunt::kMaxUnrolledOrder) {
    unrolled[n](channels, count, InputOf(*coefficients, count), InputOf(*directions, count),
                OutputOf(*out, count));
  } else {
    any(static_cast<int>(n), channels, count, InputOf(*coefficients, count),
        InputOf(*directions, count), OutputOf(*out, count));
  }
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_sh_evaluate(uint32_t n, uint32_t channels, size_t count,
                               const gaunt_view* coefficients, const gaunt_view* directions,
                               const gaunt_view* out) {
  const gaunt::evaluate::Table& kernels = gaunt::evaluate::Kernels();
  return Evaluate(kernels.sh, kernels.sh_any, n, channels, count, coefficients, directions, out);
}

gaunt_status gaunt_irradiance_evaluate(uint32_t n, uint32_t channels, size_t count,
                                       const gaunt_view* radiance, const gaunt_view* normals,
                                       const gaunt_view* out) {
  const gaunt::evaluate::Table& kernels = gaunt::evaluate::Kernels();
  return Evaluate(kernels.irradiance, kernels.irradiance_any, n, channels, count, radiance, normals,
                  out);
}

gaunt_status gaunt_irradiance_constants(uint32_t n, size_t count, const gaunt_view* radiance,
                                        const gaunt_view* out) {
  GAUNT_REQUIRE(n == 3, GAUNT_ERROR_ORDER);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(radiance, 3 * n * n)
                  .Out(out, gaunt::evaluate::kConstantPlanes)
                  .status());
  if (count == 0) return GAUNT_OK;
  gaunt::evaluate::Kernels().constants(count, InputOf(*radiance, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_irradiance_matrix(uint32_t n, uint32_t channels, size_t count,
                                     const gaunt_view* radiance, const gaunt_view* out) {
  GAUNT_REQUIRE(n == 3, GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(radiance, channels * n * n)
                  .Out(out, channels * gaunt::evaluate::kMatrixPlanes)
                  .status());
  if (count == 0) return GAUNT_OK;
  gaunt::evaluate::Kernels().matrix(channels, count, InputOf(*radiance, count),
                                    OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_sh_dot(uint32_t n, uint32_t channels, size_t count, const gaunt_view* a,
                          const gaunt_view* b, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  GAUNT_CHECK(MemoryCheck(count).In(a, planes).In(b, planes).Out(out, channels).status());
  if (count == 0) return GAUNT_OK;
  gaunt::evaluate::Kernels().dot(n * n, channels, count, InputOf(*a, count), InputOf(*b, count),
                                 OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_sh_blend(uint32_t n, uint32_t channels, size_t count, const gaunt_view* a,
                            const gaunt_view* b, const gaunt_view* t, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  GAUNT_CHECK(
      MemoryCheck(count).In(a, planes).In(b, planes).In(t, 1).OutInPlace(out, planes).status());
  if (count == 0) return GAUNT_OK;
  gaunt::evaluate::Kernels().blend(planes, count, InputOf(*a, count), InputOf(*b, count),
                                   InputOf(*t, count), OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
