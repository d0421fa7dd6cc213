// SPDX-License-Identifier: MIT
#include "light/light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/light.cc"
#include <hwy/foreach_target.h>

#include "light/light-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::light::HWY_NAMESPACE {

void DirectionBatch(size_t coefficients, size_t channels, const float* weights, size_t count,
                    const simd::InView& in, const simd::OutView& directions) {
  constexpr size_t kMaxPlanes = kMaxChannels * NumCoefficients(kMaxUnrolledOrder);
  ForEachBatch(count, Direction{coefficients, channels, weights},
               In<kMaxPlanes>(in, (channels - 1) * coefficients + 4), Out<3>(directions));
}

template <int n, class Quantity>
void ExtractBatch(size_t channels, size_t count, const simd::InView& in,
                  const simd::InView& directions, const simd::OutView& colours,
                  const simd::OutView& ambient) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  ForEachBatch(count, Extract<n, Quantity>{channels},
               In<kMaxChannels * kCoefficients>(in, channels * kCoefficients), In<3>(directions),
               Out<kMaxChannels>(colours, channels), Out<kMaxChannels>(ambient, channels));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, 1, n...>) {
  return {&DirectionBatch,
          {nullptr, nullptr, &ExtractBatch<n, evaluate::RadianceBands>...},
          {nullptr, nullptr, &ExtractBatch<n, evaluate::IrradianceBands>...}};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(light);
