// SPDX-License-Identifier: MIT
// Operations of the ambient cube's kernels, by running them on counting lanes.
#include <algorithm>

#include "ambient_cube/ambient_cube-inl.h"
#include "simd/count.h"
#include "simd/order.h"

namespace gaunt::ambient_cube {

void AppendOperations(OperationRows& rows);

namespace {

template <int n>
void Append(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  constexpr size_t kCoefficients = NumCoefficients(n);
  constexpr int kLow = std::min(n, 3);
  const CountPlanes planes;
  const auto row = [&](const std::string& op, const std::string& variant,
                       const Operations& counted) {
    rows.push_back({op, std::to_string(n), variant, counted});
  };
  row("ambient_cube_project", "least_squares",
      CountKernel(kernels::Project<kLow>{kCoefficients, kClosestLinear}, planes, planes));
  row("ambient_cube_project", "sampled",
      CountKernel(kernels::Project < n < 5 ? kLow : 5 > {kCoefficients, kSampledLinear}, planes,
                  planes));
  row("ambient_cube_to_sh", "rgb", CountKernel(kernels::ToSh<kLow>{kCoefficients}, planes, planes));
  if constexpr (n < kMaxUnrolledOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  const CountPlanes planes;
  Append<1>(rows);
  rows.push_back({"ambient_cube_evaluate", "-", "rgb",
                  CountKernel(HWY_NAMESPACE::Evaluate(), planes, planes, planes)});
}

}  // namespace gaunt::ambient_cube
