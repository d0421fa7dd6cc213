// SPDX-License-Identifier: MIT
// Operations of the basis kernels, by running them on counting lanes.
#include "basis/basis-inl.h"
#include "simd/count.h"

namespace gaunt::basis {

void AppendOperations(OperationRows& rows);

namespace {

template <int n>
void Append(OperationRows& rows) {
  rows.push_back({"basis", std::to_string(n), "unrolled",
                  CountKernel(HWY_NAMESPACE::Eval<n>(), CountPlanes(), CountPlanes())});
  if constexpr (n < kMaxUnrolledOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) { Append<1>(rows); }

}  // namespace gaunt::basis
