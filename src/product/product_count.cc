// SPDX-License-Identifier: MIT
// Operations of the product kernels, by running them on counting lanes.
#include "product/product-inl.h"
#include "simd/count.h"

namespace gaunt::product {

void AppendAxialOperations(OperationRows& rows);
void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;
constexpr CountPlanes kPlanes;

std::string OrderOf(int a, int b, int out) {
  return a == b && b == out
             ? std::to_string(a)
             : std::to_string(a) + "x" + std::to_string(b) + "->" + std::to_string(out);
}

// What the library runs is fast; with the values at the points themselves it has the fewest
// multiplications, and more additions.
template <int a, int b, int out>
void AppendProduct(OperationRows& rows) {
  const std::string order = OrderOf(a, b, out);
  rows.push_back({"product", order, "fast",
                  CountKernel(kernels::ProductKernel<a, b, out>(), kPlanes, kPlanes, kPlanes)});
  if constexpr (a > 2) {
    rows.push_back({"product", order, "fewest",
                    CountKernel(kernels::FixedGrid<a, b, out, Level::kPoints>(), kPlanes, kPlanes,
                                kPlanes)});
  }
}

template <int n>
void AppendOrder(OperationRows& rows) {
  AppendProduct<n, n, n>(rows);
  using kernels::Second;
  const std::string order = std::to_string(n);
  rows.push_back({"product_square", order, "fast",
                  CountKernel(kernels::SquareKernel<n>(), kPlanes, kPlanes)});
  if constexpr (n > 2) {
    rows.push_back({"product_square", order, "fewest",
                    CountKernel(kernels::FixedGrid<n, n, n, Level::kPoints, Second::kSame>(),
                                kPlanes, kPlanes)});
  }
  rows.push_back({"product_prepared", order, "fast",
                  CountKernel(kernels::PreparedKernel<n>(), kPlanes, kPlanes)});
  if constexpr (n > 2) {
    rows.push_back({"product_prepared", order, "fewest",
                    CountKernel(kernels::FixedGrid<n, n, n, Level::kPoints, Second::kPrepared>(),
                                kPlanes, kPlanes)});
  }
  if constexpr (n < kMaxOrder) AppendOrder<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  AppendOrder<2>(rows);
  AppendProduct<6, 6, 3>(rows);
  AppendProduct<6, 6, 4>(rows);
  AppendProduct<3, 6, 6>(rows);
  AppendAxialOperations(rows);
}

}  // namespace gaunt::product
