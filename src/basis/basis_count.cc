// SPDX-License-Identifier: MIT
// Operations of the basis kernels, by running them on counting lanes.
#include "basis/basis-inl.h"
#include "basis/basis.h"
#include "simd/count.h"

namespace gaunt::basis {

void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;

template <int n>
void AppendUnrolled(OperationRows& rows) {
  rows.push_back({"basis", std::to_string(n), "unrolled",
                  CountKernel(kernels::Eval<n>(), CountPlanes(), CountPlanes())});
  if constexpr (n <= kMaxUnrolledGradient) {
    const CountPlanes planes;
    rows.push_back({"basis_gradient", std::to_string(n), "unrolled",
                    CountKernel(kernels::EvalGradient<n>(), planes, planes, planes, planes)});
  }
  if constexpr (n < kMaxUnrolled) AppendUnrolled<n + 1>(rows);
}

// Bands l < order, each by what `count` says of it.
template <class Count>
Operations SumOverBands(int order, const Count& count) {
  Operations sum;
  for (int l = 0; l < order; ++l) sum = sum + count(l);
  return sum;
}

Operations CountBand(int l) {
  const CountPlanes planes;
  return CountKernel(kernels::EvalBand{l}, planes, planes, planes, planes);
}

Operations CountGradientBand(int l) {
  const CountPlanes planes;
  return CountBand(l) +
         CountKernel(kernels::GradientBand{l, -l, l + 1}, planes, planes, planes, planes, planes);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  AppendUnrolled<1>(rows);
  for (const int n : CountedOrders()) {
    rows.push_back({"basis", std::to_string(n), "bands", SumOverBands(n, CountBand)});
    rows.push_back(
        {"basis_gradient", std::to_string(n), "bands", SumOverBands(n, CountGradientBand)});
  }
  rows.push_back({"directions_normalize", "-", "-",
                  CountKernel(kernels::Normalize(), CountPlanes(), CountPlanes())});
}

}  // namespace gaunt::basis
