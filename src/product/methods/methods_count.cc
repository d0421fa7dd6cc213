// SPDX-License-Identifier: MIT
// Operations of the other ways to make products, by running them on counting lanes.
#include "product/fixed_grid-inl.h"
#include "product/matrix-inl.h"
#include "product/methods/methods.h"
#include "product/methods/sparse-inl.h"
#include "simd/count.h"

namespace gaunt::product {

// A part of the family's AppendOperations().
void AppendMethodOperations(OperationRows& rows);

namespace {

constexpr CountPlanes kPlanes;

template <class Kernel>
Operations CountProduct(const Kernel& kernel) {
  return CountKernel(kernel, kPlanes, kPlanes, kPlanes);
}

template <int n, int level>
void AppendLevels(OperationRows& rows) {
  using Kernel = HWY_NAMESPACE::FixedGrid<n, n, n, static_cast<Level>(level)>;
  rows.push_back({"product", std::to_string(n), "grid" + std::to_string(level),
                  CountProduct(Kernel())});
  if constexpr (level + 1 < methods::levels::kLevels) AppendLevels<n, level + 1>(rows);
}

template <int n>
void Append(OperationRows& rows) {
  const std::string order = std::to_string(n);
  if constexpr (n <= methods::sparse::kMaxCountedOrder) {
    rows.push_back({"product", order, "by_output",
                    CountProduct(methods::HWY_NAMESPACE::ByOutput<n>())});
    rows.push_back({"product", order, "by_pairs",
                    CountProduct(methods::HWY_NAMESPACE::ByPairs<n>())});
  }
  AppendLevels<n, 0>(rows);
  rows.push_back({"product_prepared", order, "matrix",
                  CountKernel(HWY_NAMESPACE::Matrix<n>{nullptr}, kPlanes, kPlanes)});
  if constexpr (n < kMaxOrder) Append<n + 1>(rows);
}

}  // namespace

void AppendMethodOperations(OperationRows& rows) { Append<methods::kMinOrder>(rows); }

}  // namespace gaunt::product
