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

// High orders go channel by channel, each with its angles.
template <int n>
uint64_t Times(size_t channels) {
  return n <= kernels::kMaxInlinedOrder ? 1 : channels;
}

template <int n, bool kMirrors>
Operations CountBands(size_t channels) {
  const uint64_t times = Times<n>(channels);
  return times * CountKernel(kernels::RotateBands<n, kMirrors>(n, channels / times), kPlanes,
                             kPlanes, kPlanes);
}

template <int n>
Operations ByQuaternion(size_t channels) {
  if constexpr (n <= kernels::kMaxTensorOrder) {
    return CountKernel(kernels::RotateTensorsByQuaternion<n>{channels}, kPlanes, kPlanes, kPlanes);
  } else {
    return Times<n>(channels) * CountKernel(kernels::AnglesFromQuaternion(), kPlanes, kPlanes) +
           CountBands<n, false>(channels);
  }
}

template <int n>
Operations ByMatrix(size_t channels) {
  if constexpr (n <= kernels::kMaxTensorOrder) {
    return CountKernel(kernels::RotateTensorsByMatrix<n>{channels}, kPlanes, kPlanes, kPlanes);
  } else {
    return Times<n>(channels) * CountKernel(kernels::AnglesFromMatrix(), kPlanes, kPlanes) +
           CountBands<n, true>(channels);
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
