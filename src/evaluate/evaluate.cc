// SPDX-License-Identifier: MIT
#include "evaluate/evaluate.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "evaluate/evaluate.cc"
#include <hwy/foreach_target.h>

#include "evaluate/evaluate-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::evaluate::HWY_NAMESPACE {

template <int n, class Quantity>
void EvaluateBatch(size_t channels, size_t count, const simd::InView& coefficients,
                   const simd::InView& directions, const simd::OutView& out) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  ForEachBatch(count, Evaluate<n, Quantity>{channels},
               In<kMaxChannels * kCoefficients>(coefficients, channels * kCoefficients),
               In<3>(directions), Out<kMaxChannels>(out, channels));
}

void ConstantsBatch(size_t count, const simd::InView& radiance, const simd::OutView& out) {
  ForEachBatch(count, Constants(), In<27>(radiance), Out<kConstantPlanes>(out));
}

// Planes are independent, so any number of them goes a stack tile's worth at a time.
void BlendBatch(size_t planes, size_t count, const simd::InView& a, const simd::InView& b,
                const simd::InView& t, const simd::OutView& out) {
  constexpr size_t kChunk = 32;
  for (size_t p = 0; p < planes; p += kChunk) {
    const size_t chunk = std::min(kChunk, planes - p);
    ForEachBatch(count, Blend{chunk}, In<kChunk>(a.FromPlane(p), chunk),
                 In<kChunk>(b.FromPlane(p), chunk), In<1>(t), Out<kChunk>(out.FromPlane(p), chunk));
  }
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &EvaluateBatch<n, RadianceBands>...},
          {nullptr, &EvaluateBatch<n, IrradianceBands>...},
          &ConstantsBatch,
          &BlendBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::evaluate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(evaluate);
