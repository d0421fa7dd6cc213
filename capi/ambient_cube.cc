// SPDX-License-Identifier: MIT
#include "ambient_cube/ambient_cube.h"

#include "ambient_cube/constants.h"
#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

static_assert(GAUNT_MAX_AMBIENT_CUBE_ORDER == gaunt::kMaxUnrolledOrder &&
                  GAUNT_AMBIENT_CUBE_PLANES == gaunt::ambient_cube::kPlanes,
              "the header and the kernels must agree");

extern "C" {

gaunt_status gaunt_ambient_cube_project(uint32_t n, uint32_t mode, size_t count,
                                        const gaunt_view* radiance, const gaunt_view* cube) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_AMBIENT_CUBE_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(mode, GAUNT_AMBIENT_CUBE_LEAST_SQUARES, GAUNT_AMBIENT_CUBE_SAMPLED),
                GAUNT_ERROR_RANGE);
  GAUNT_CHECK(
      MemoryCheck(count).In(radiance, 3 * n * n).Out(cube, GAUNT_AMBIENT_CUBE_PLANES).status());
  if (count == 0) return GAUNT_OK;
  gaunt::ambient_cube::Kernels().project[n](
      mode == GAUNT_AMBIENT_CUBE_SAMPLED ? gaunt::ambient_cube::kSampled
                                         : gaunt::ambient_cube::kClosest,
      count, InputOf(*radiance, count), OutputOf(*cube, count));
  return GAUNT_OK;
}

gaunt_status gaunt_ambient_cube_evaluate(size_t count, const gaunt_view* cube,
                                         const gaunt_view* normals, const gaunt_view* out) {
  GAUNT_CHECK(
      MemoryCheck(count).In(cube, GAUNT_AMBIENT_CUBE_PLANES).In(normals, 3).Out(out, 3).status());
  if (count == 0) return GAUNT_OK;
  gaunt::ambient_cube::Kernels().evaluate(count, InputOf(*cube, count), InputOf(*normals, count),
                                          OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_ambient_cube_to_sh(uint32_t n, size_t count, const gaunt_view* cube,
                                      const gaunt_view* radiance) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_AMBIENT_CUBE_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_CHECK(
      MemoryCheck(count).In(cube, GAUNT_AMBIENT_CUBE_PLANES).Out(radiance, 3 * n * n).status());
  if (count == 0) return GAUNT_OK;
  gaunt::ambient_cube::Kernels().to_sh[n](count, InputOf(*cube, count), OutputOf(*radiance, count));
  return GAUNT_OK;
}

}  // extern "C"
