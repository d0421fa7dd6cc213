// SPDX-License-Identifier: MIT
#include "zh3/zh3.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "zh3/zh3.cc"
#include <hwy/foreach_target.h>

#include "simd/batch-inl.h"
#include "simd/export-inl.h"
#include "zh3/zh3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::zh3::HWY_NAMESPACE {

template <bool shared>
void SolveBatch(size_t count, const simd::InView& sh3, const simd::OutView& k2,
                const simd::OutView* axis) {
  if (axis != nullptr) {
    ForEachBatch(count, Solve<shared>(), In<27>(sh3), Out<3>(k2), Out<kAxisPlanes<shared>>(*axis));
  } else {
    ForEachBatch(count, Solve<shared>(), In<27>(sh3), Out<3>(k2));
  }
}

template <bool shared>
void RefitBatch(size_t count, const simd::InView& sh3, const simd::OutView& sh2,
                const simd::OutView& k2) {
  ForEachBatch(count, Refit<shared>(), In<27>(sh3), Out<12>(sh2), Out<3>(k2));
}

template <bool shared>
void HallucinateBatch(float linear, float quadratic, const float* weights, size_t count,
                      const simd::InView& sh2, const simd::OutView& k2) {
  ForEachBatch(count, Hallucinate<shared>{weights, linear, quadratic}, In<12>(sh2), Out<3>(k2));
}

template <bool shared>
void ExpandBatch(size_t count, const simd::InView& sh2, const simd::InView& k2,
                 const simd::OutView& sh3) {
  ForEachBatch(count, Expand<shared>(), In<12>(sh2), In<3>(k2), Out<27>(sh3));
}

template <bool shared>
void IrradianceBatch(size_t count, const simd::InView& sh2, const simd::InView& k2,
                     const simd::InView& normals, const simd::OutView& out) {
  if (count > 1 && sh2.IsBroadcast() && k2.IsBroadcast()) {
    constexpr size_t kPlanes = kPolynomialPlanes<shared>;
    float polynomial[kPlanes];
    ForEachBatch(1, PreparePolynomial<shared>(), In<12>(sh2), In<3>(k2),
                 Out<kPlanes>(simd::InterleavedOut(polynomial, kPlanes)));
    ForEachBatch(count, EvaluatePolynomial<shared>(), In<kPlanes>(simd::BroadcastIn(polynomial)),
                 In<3>(normals), Out<3>(out));
  } else {
    ForEachBatch(count, Irradiance<shared>(), In<12>(sh2), In<3>(k2), In<3>(normals), Out<3>(out));
  }
}

void GeomericsBatch(size_t count, const simd::InView& sh2, const simd::InView& normals,
                    const simd::OutView& out) {
  if (count > 1 && sh2.IsBroadcast()) {
    float lobe[kLobePlanes];
    ForEachBatch(1, PrepareLobe(), In<12>(sh2),
                 Out<kLobePlanes>(simd::InterleavedOut(lobe, kLobePlanes)));
    ForEachBatch(count, EvaluateLobe(), In<kLobePlanes>(simd::BroadcastIn(lobe)), In<3>(normals),
                 Out<3>(out));
  } else {
    ForEachBatch(count, Geomerics(), In<12>(sh2), In<3>(normals), Out<3>(out));
  }
}

const Table* GetTable() {
  static constexpr Table kTable = {{&SolveBatch<true>, &SolveBatch<false>},
                                   {&RefitBatch<true>, &RefitBatch<false>},
                                   {&HallucinateBatch<true>, &HallucinateBatch<false>},
                                   {&ExpandBatch<true>, &ExpandBatch<false>},
                                   {&IrradianceBatch<true>, &IrradianceBatch<false>},
                                   &GeomericsBatch};
  return &kTable;
}

}  // namespace gaunt::zh3::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(zh3);
