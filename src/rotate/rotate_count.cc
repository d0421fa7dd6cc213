// SPDX-License-Identifier: MIT
// Operations of the rotate kernels, by running them on counting lanes.
#include "rotate/rotate-inl.h"
#include "rotate/rotate.h"
#include "simd/count.h"

namespace gaunt::rotate {

void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;
constexpr CountPlanes kPlanes;

template <int n>
Operations ByQuaternion(size_t channels) {
  if constexpr (n <= kernels::kMaxTensorOrder) {
    return CountKernel(kernels::RotateTensorsByQuaternion<n>{channels}, kPlanes, kPlanes, kPlanes);
  } else {
    return CountKernel(kernels::AnglesFromQuaternion(), kPlanes, kPlanes) +
           CountKernel(kernels::RotateBands<n, false>(n, channels), kPlanes, kPlanes, kPlanes);
  }
}

template <int n>
Operations ByMatrix(size_t channels) {
  if constexpr (n <= kernels::kMaxTensorOrder) {
    return CountKernel(kernels::RotateTensorsByMatrix<n>{channels}, kPlanes, kPlanes, kPlanes);
  } else {
    return CountKernel(kernels::AnglesFromMatrix(), kPlanes, kPlanes) +
           CountKernel(kernels::RotateBands<n, true>(n, channels), kPlanes, kPlanes, kPlanes);
  }
}

template <int n>
void Append(OperationRows& rows) {
  const std::string order = std::to_string(n);
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    rows.push_back({"rotate", order, variant, ByQuaternion<n>(channels)});
    rows.push_back({"rotate_matrix", order, variant, ByMatrix<n>(channels)});
    // The plan is made once per call.
    rows.push_back({"rotate_broadcast", order, variant,
                    CountKernel(kernels::ApplyPlan<n>({}, n, channels), kPlanes, kPlanes)});
  }
  if constexpr (n < kMaxOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) { Append<1>(rows); }

}  // namespace gaunt::rotate
