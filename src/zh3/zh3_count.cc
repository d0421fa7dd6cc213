// SPDX-License-Identifier: MIT
// Operations of the ZH3 kernels, by running them on counting lanes.
#include "simd/count.h"
#include "zh3/zh3-inl.h"

namespace gaunt::zh3 {

void AppendOperations(OperationRows& rows);

namespace {

template <bool shared>
void Append(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  const std::string variant = shared ? "luminance" : "channel";
  const auto row = [&](const std::string& op, const std::string& order, const Operations& counted) {
    rows.push_back({op, order, variant, counted});
  };
  row("zh3_solve", "3", CountKernel(kernels::Solve<shared>(), planes, planes));
  row("zh3_refit", "3", CountKernel(kernels::Refit<shared>(), planes, planes, planes));
  row("zh3_hallucinate", "2",
      CountKernel(kernels::Hallucinate<shared>{kLuminance, 0.0f, 0.0f}, planes, planes));
  row("zh3_expand", "3", CountKernel(kernels::Expand<shared>(), planes, planes, planes));
  row("zh3_irradiance", "3",
      CountKernel(kernels::Irradiance<shared>(), planes, planes, planes, planes));
  row("zh3_irradiance_one_probe", "3",
      CountKernel(kernels::EvaluatePolynomial<shared>(), planes, planes, planes));
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  Append<true>(rows);
  Append<false>(rows);
  rows.push_back({"geomerics_irradiance", "2", "rgb",
                  CountKernel(kernels::Geomerics(), planes, planes, planes)});
  rows.push_back({"geomerics_irradiance_one_probe", "2", "rgb",
                  CountKernel(kernels::EvaluateLobe(), planes, planes, planes)});
}

}  // namespace gaunt::zh3
