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

// Any order: the basis by bands, and a dot product per band, channel and quantity.
template <class Quantity>
Operations CountAny(int order, size_t channels) {
  const CountPlanes planes;
  Operations sum;
  for (int l = 0; l < order; ++l) {
    sum = sum + CountKernel(basis::HWY_NAMESPACE::EvalBand{l}, planes, planes, planes, planes);
    if (Quantity::Band(l) == 0.0) continue;
    const HWY_NAMESPACE::AddDot dot{static_cast<size_t>(2 * l + 1), Quantity::Band(l)};
    sum = sum + channels * CountKernel(dot, planes, planes, planes, planes);
  }
  return sum;
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  Append<1>(rows);
  for (const int n : CountedOrders()) {
    for (const size_t channels : {1, 3}) {
      const std::string variant = channels == 1 ? "mono" : "rgb";
      if (n > kMaxUnrolledOrder) {
        rows.push_back(
            {"sh_evaluate", std::to_string(n), variant, CountAny<RadianceBands>(n, channels)});
        rows.push_back({"irradiance_evaluate", std::to_string(n), variant,
                        CountAny<IrradianceBands>(n, channels)});
      }
      const kernels::AddDot dot{static_cast<size_t>(NumCoefficients(n)), 1.0};
      rows.push_back({"sh_dot", std::to_string(n), variant,
                      channels * CountKernel(dot, planes, planes, planes, planes)});
    }
  }
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    rows.push_back({"irradiance_matrix", "3", variant,
                    CountKernel(kernels::Matrix{channels}, planes, planes)});
  }
  // One function, many directions: what finding its polynomial takes is shared by all of them.
  rows.push_back({"evaluate_broadcast", "3", "mono",
                  CountKernel(kernels::EvaluateQuadratics<1>(), planes, planes)});
  rows.push_back({"evaluate_broadcast", "3", "rgb",
                  CountKernel(kernels::EvaluateQuadratics<3>(), planes, planes)});
  rows.push_back(
      {"irradiance_constants", "3", "rgb", CountKernel(kernels::Constants(), planes, planes)});
}

}  // namespace gaunt::evaluate
