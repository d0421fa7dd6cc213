// SPDX-License-Identifier: MIT
// Operations of the light kernels, by running them on counting lanes.
#include "light/light-inl.h"
#include "simd/count.h"

namespace gaunt::light {

void AppendOperations(OperationRows& rows);

namespace {

constexpr float kWeights[kMaxChannels] = {};

template <int n>
void Append(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    rows.push_back(
        {"light_direction", std::to_string(n), variant,
         CountKernel(kernels::Direction{NumCoefficients(n), channels, kWeights}, planes, planes)});
    rows.push_back({"light_extract", std::to_string(n), variant + "_irradiance",
                    CountKernel(kernels::Extract<n, evaluate::IrradianceBands>{channels}, planes,
                                planes, planes, planes)});
    rows.push_back({"light_extract", std::to_string(n), variant + "_radiance",
                    CountKernel(kernels::Extract<n, evaluate::RadianceBands>{channels}, planes,
                                planes, planes, planes)});
  }
  if constexpr (n < kMaxUnrolledOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) { Append<2>(rows); }

}  // namespace gaunt::light
