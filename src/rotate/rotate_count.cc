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
  for (const size_t channels : {1, 3}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    const Operations matrix =
        CountKernel(kernels::RotateMatrix<n>{channels}, planes, planes, planes);
    rows.push_back({"rotate", std::to_string(n), variant,
                    CountKernel(kernels::RotateQuaternion<n>{channels}, planes, planes, planes)});
    rows.push_back({"rotate_matrix", std::to_string(n), variant, matrix});
    // The matrix of the one quaternion is made once per call.
    rows.push_back({"rotate_broadcast", std::to_string(n), variant, matrix});
  }
  if constexpr (n < kMaxOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) { Append<1>(rows); }

}  // namespace gaunt::rotate
