// SPDX-License-Identifier: MIT
// Operations of the evaluate kernels, by running them on counting lanes.
#include "evaluate/evaluate-inl.h"
#include "simd/count.h"

namespace gaunt::evaluate {

void AppendOperations(OperationRows& rows);

namespace {

template <int n>
void Append(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    rows.push_back(
        {"sh_evaluate", std::to_string(n), variant,
         CountKernel(kernels::Evaluate<n, RadianceBands>{channels}, planes, planes, planes)});
    rows.push_back(
        {"irradiance_evaluate", std::to_string(n), variant,
         CountKernel(kernels::Evaluate<n, IrradianceBands>{channels}, planes, planes, planes)});
    rows.push_back({"sh_blend", std::to_string(n), variant,
                    CountKernel(kernels::Blend{channels * NumCoefficients(n)}, planes, planes,
                                planes, planes)});
  }
  if constexpr (n < kMaxUnrolledOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  Append<1>(rows);
  rows.push_back({"irradiance_constants", "3", "rgb",
                  CountKernel(HWY_NAMESPACE::Constants(), CountPlanes(), CountPlanes())});
}

}  // namespace gaunt::evaluate
