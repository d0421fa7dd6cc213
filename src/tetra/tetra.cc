// SPDX-License-Identifier: MIT
#include "tetra/tetra.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tetra/tetra.cc"
#include <hwy/foreach_target.h>

#include "simd/batch-inl.h"
#include "simd/export-inl.h"
#include "tetra/tetra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::tetra::HWY_NAMESPACE {

void TapsBatch(const Mesh& mesh, size_t count, const simd::InView& positions, uint32_t* tetrahedra,
               uint32_t* indices, float* weights) {
  constexpr size_t kPlanes = kCorners;
  float* const at = reinterpret_cast<float*>(tetrahedra);
  ForEachBatch(count, Taps{mesh}, In<3>(positions), In<1>(simd::PlanarIn(at, 0)),
               Out<1>(simd::InterleavedOut(at, 1)),
               Out<kPlanes>(simd::InterleavedOut(reinterpret_cast<float*>(indices), kPlanes)),
               Out<kPlanes>(simd::InterleavedOut(weights, kPlanes)));
}

const Table* GetTable() {
  static constexpr Table kTable = {&TapsBatch};
  return &kTable;
}

}  // namespace gaunt::tetra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(tetra);
