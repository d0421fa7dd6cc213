// SPDX-License-Identifier: MIT
// Operations of the rotate kernels, by running them on counting lanes.
#include "rotate/rotate-inl.h"
#include "rotate/rotate.h"
#include "simd/count.h"

namespace gaunt::rotate {

void AppendOperations(OperationRows& rows);

namespace {

template <int n>
void Append(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  const CountPlanes planes;
  const Plan plan = {};
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    const std::string order = std::to_string(n);
    rows.push_back({"rotate", order, variant,
                    CountKernel(kernels::RotateByQuaternion<n>(channels), planes, planes, planes)});
    rows.push_back({"rotate_matrix", order, variant,
                    CountKernel(kernels::RotateByMatrix<n>(channels), planes, planes, planes)});
    // The plan is made once per call.
    rows.push_back({"rotate_broadcast", order, variant,
                    CountKernel(kernels::ApplyPlan{n, channels, plan}, planes, planes)});
  }
  if constexpr (n < kMaxOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) { Append<1>(rows); }

}  // namespace gaunt::rotate
