// SPDX-License-Identifier: MIT
// Operations of conversions, by running them on counting lanes. Those of sums are in double
// precision.
#include "convert/convert-inl.h"
#include "convert/convert.h"
#include "simd/count.h"

namespace gaunt::convert {

void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;

Operations Count(const Convention& from, const Convention& to, int order, size_t channels) {
  const Conversion conversion(from, to);
  const CountPlanes planes;
  Operations sum;
  Plan plan;
  for (int l = 0; l < order; l = plan.end_band) {
    conversion.Fill(l, ChunkEnd(l, order), plan);
    plan.staged = false;
    sum = sum +
          (plan.exact
               ? CountKernel(kernels::Bands<kernels::MoveRow>{&plan, channels, 0}, planes, planes)
               : CountKernel(kernels::Bands<kernels::SumRow>{&plan, channels, 0}, planes, planes));
  }
  return sum;
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  const Convention gaunt = PresetOf(Engine::kGaunt);
  const auto append = [&](const char* variant, const Convention& from, const Convention& to,
                          int least, int most) {
    for (int order = least; order <= most; ++order) {
      rows.push_back({"convert", std::to_string(order), variant, Count(from, to, order, 3)});
    }
  };
  Convention other = gaunt;
  other.sign = Sign::kPositive;
  append("rgb sign", gaunt, other, 1, 6);
  other.scale = Scale::kSn3d;
  append("rgb scale", gaunt, other, 1, 6);
  append("rgb z to y up", gaunt, PresetOf(Engine::kThreejs), 1, 6);
  append("rgb from Unity", PresetOf(Engine::kUnity), gaunt, 1, 3);
  append("rgb to Unity", gaunt, PresetOf(Engine::kUnity), 1, 3);
}

}  // namespace gaunt::convert
