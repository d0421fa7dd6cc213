// SPDX-License-Identifier: MIT
#include "tetra/tetra.h"

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::MemoryCheck;
using gaunt::tetra::kCorners;
using gaunt::tetra::Mesh;

namespace {

constexpr size_t kMaxTetrahedra = size_t{1} << 28;
constexpr size_t kWord = sizeof(uint32_t);

}  // namespace

extern "C" {

gaunt_status gaunt_tetrahedra_prepare(size_t vertex_count, const gaunt_view* vertices, size_t count,
                                      const uint32_t* corners, const uint32_t* neighbours,
                                      void* mesh, size_t* mesh_size) {
  GAUNT_REQUIRE(vertex_count >= 1 && vertex_count <= GAUNT_NO_PROBE, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(count >= 1 && count <= kMaxTetrahedra, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(mesh_size != nullptr, GAUNT_ERROR_NULL);
  const uint32_t used_vertices = static_cast<uint32_t>(vertex_count);
  const uint32_t tetrahedra = static_cast<uint32_t>(count);
  const size_t size = gaunt::tetra::SizeOf(used_vertices, tetrahedra);
  GAUNT_REQUIRE(size != 0, GAUNT_ERROR_RANGE);
  if (mesh != nullptr) {
    GAUNT_REQUIRE(*mesh_size >= size, GAUNT_ERROR_RANGE);
    MemoryCheck check(vertex_count);
    check.In(vertices, 3).InRecords(corners, count * kCorners, kWord, kWord);
    if (neighbours != nullptr) check.InRecords(neighbours, count * kCorners, kWord, kWord);
    check.OutRecords(mesh, 1, size, size)
        .OutRecords(mesh_size, 1, sizeof(*mesh_size), sizeof(*mesh_size));
    GAUNT_CHECK(check.status());
    const gaunt::simd::InView positions = InputOf(*vertices, vertex_count);
    GAUNT_REQUIRE(gaunt::tetra::IsSound(used_vertices, positions, tetrahedra, corners, neighbours),
                  GAUNT_ERROR_RANGE);
    gaunt::tetra::Prepare(used_vertices, positions, tetrahedra, corners, neighbours, mesh);
  }
  *mesh_size = size;
  return GAUNT_OK;
}

gaunt_status gaunt_tetrahedra_taps(const void* mesh, size_t mesh_size, size_t count,
                                   const gaunt_view* positions, uint32_t* tetrahedra,
                                   uint32_t* indices, float* weights) {
  GAUNT_REQUIRE(mesh != nullptr, GAUNT_ERROR_NULL);
  Mesh found;
  GAUNT_REQUIRE(gaunt::tetra::FindMesh(mesh, mesh_size, &found), GAUNT_ERROR_FORMAT);
  GAUNT_REQUIRE(count <= SIZE_MAX / kCorners, GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .InRecords(mesh, 1, mesh_size, mesh_size)
                  .In(positions, 3)
                  .OutRecords(tetrahedra, count, kWord, kWord)
                  .OutRecords(indices, count * kCorners, kWord, kWord)
                  .OutRecords(weights, count * kCorners, sizeof(*weights), sizeof(*weights))
                  .status());
  if (count == 0) return GAUNT_OK;
  gaunt::tetra::Kernels().taps(found, count, InputOf(*positions, count), tetrahedra, indices,
                               weights);
  return GAUNT_OK;
}

}  // extern "C"
