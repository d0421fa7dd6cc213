// SPDX-License-Identifier: MIT
// Operations of the product kernels, by running them on counting lanes.
#include "product/matrix-inl.h"
#include "product/prepared.h"
#include "product/product-inl.h"
#include "simd/count.h"

namespace gaunt::product {

void AppendAxialOperations(OperationRows& rows);
void AppendMethodOperations(OperationRows& rows);
void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;
constexpr CountPlanes kPlanes;

std::string OrderOf(int a, int b, int out) {
  return a == b && b == out
             ? std::to_string(a)
             : std::to_string(a) + "x" + std::to_string(b) + "->" + std::to_string(out);
}

using kernels::Second;

// Of any orders, as the library runs them where they have no kernel of their own.
template <int a, int b, int out>
auto AnyKernel() {
  constexpr Degrees kDegrees = Coupled({a, b, out});
  constexpr int kPoints = PointsOf(GridOf(kDegrees.a + kDegrees.b + kDegrees.out));
  return kernels::AnyGrid<kPoints, kLevel>{kDegrees};
}

template <int a, int b, int out>
Operations FastProduct() {
  if constexpr (a == b && b == out && a > kernels::kMaxFixed) {
    return CountKernel(AnyKernel<a, b, out>(), kPlanes, kPlanes, kPlanes);
  } else {
    return CountKernel(kernels::ProductKernel<a, b, out>(), kPlanes, kPlanes, kPlanes);
  }
}

// What the library runs is fast. With the values at the points themselves, the grid has the fewest
// multiplications and more additions.
template <int a, int b, int out>
void AppendProduct(OperationRows& rows) {
  const std::string order = OrderOf(a, b, out);
  rows.push_back({"product", order, "fast", FastProduct<a, b, out>()});
  if constexpr (a > 2) {
    rows.push_back(
        {"product", order, "fewest",
         CountKernel(kernels::FixedGrid<a, b, out, Level::kPoints>(), kPlanes, kPlanes, kPlanes)});
  }
}

template <int n, Second second>
void AppendFewest(OperationRows& rows, const std::string& op) {
  if constexpr (n > 2) {
    rows.push_back(
        {op, std::to_string(n), "fewest",
         CountKernel(kernels::FixedGrid<n, n, n, Level::kPoints, second>(), kPlanes, kPlanes)});
  }
}

template <int n>
void AppendSquare(OperationRows& rows) {
  Operations fast;
  if constexpr (n <= kernels::kMaxFixed) {
    fast = CountKernel(kernels::SquareKernel<n>(), kPlanes, kPlanes);
  } else {
    fast = CountKernel(AnyKernel<n, n, n>(), kPlanes, kPlanes);
  }
  rows.push_back({"product_square", std::to_string(n), "fast", fast});
  AppendFewest<n, Second::kSame>(rows, "product_square");
}

template <int n>
void AppendPrepared(OperationRows& rows) {
  Operations fast;
  constexpr prepared::Header kHeader = {0, 0, n, n, n, 0};
  if constexpr (n < prepared::kMinPreparedFixed) {
    fast = CountKernel(kernels::Matrix<n>{nullptr}, kPlanes, kPlanes);
  } else if constexpr (prepared::KindOf(kHeader) == prepared::kMatrix) {
    fast = CountKernel(kernels::AnyMatrix{nullptr, n * n, n * n}, kPlanes, kPlanes);
  } else if constexpr (prepared::HasFixedKernel(kHeader)) {
    fast = CountKernel(kernels::PreparedKernel<n>(), kPlanes, kPlanes);
  } else {
    fast = CountKernel(AnyKernel<n, n, n>(), kPlanes, kPlanes);
  }
  rows.push_back({"product_prepared", std::to_string(n), "fast", fast});
  AppendFewest<n, Second::kPrepared>(rows, "product_prepared");
}

template <int n>
void AppendOrder(OperationRows& rows) {
  AppendProduct<n, n, n>(rows);
  AppendSquare<n>(rows);
  AppendPrepared<n>(rows);
  if constexpr (n < kMaxOrder) AppendOrder<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  AppendOrder<1>(rows);
  AppendProduct<6, 6, 3>(rows);
  AppendProduct<6, 6, 4>(rows);
  AppendProduct<2, 6, 6>(rows);
  AppendProduct<3, 6, 6>(rows);
  rows.push_back({"product", "6x6->11", "fast",
                  CountKernel(AnyKernel<6, 6, 11>(), kPlanes, kPlanes, kPlanes)});
  AppendAxialOperations(rows);
  AppendMethodOperations(rows);
}

}  // namespace gaunt::product
