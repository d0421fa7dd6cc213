// SPDX-License-Identifier: MIT
// Operations of the kernels about an axis, by running them on counting lanes.
#include "product/axial-inl.h"
#include "product/axis-inl.h"
#include "simd/count.h"

namespace gaunt::product {

void AppendAxialOperations(OperationRows& rows);

namespace {

namespace kernels = axial::HWY_NAMESPACE;
constexpr CountPlanes kPlanes;

void Append(OperationRows& rows, const std::string& op, const std::string& order,
            const Operations& operations, const Operations& turns) {
  rows.push_back({op, order, "mono", operations});
  rows.push_back({op + "_axis", order, "mono", operations + turns});
}

// To the axes and back. Kernels of an order do the same as those of any.
Operations CountTurns(int in_order, int out_order) {
  using ToZ = kernels::TurnAxis<kernels::kAnyOrder, true, kMaxOrder>;
  using FromZ = kernels::TurnAxis<kernels::kAnyOrder, false, rotate::kMaxOrder>;
  return CountKernel(kernels::AnglesOfAxis(), kPlanes, kPlanes) +
         CountKernel(ToZ{in_order, 1}, kPlanes, kPlanes, kPlanes) +
         CountKernel(FromZ{out_order, 1}, kPlanes, kPlanes, kPlanes);
}

template <int n>
void AppendZonal(OperationRows& rows) {
  Append(rows, "product_zonal", std::to_string(n),
         CountKernel(kernels::MultiplyByZonal<n>{1}, kPlanes, kPlanes, kPlanes),
         CountTurns(n, n));
  if constexpr (n < kernels::kMaxZonalOrder) AppendZonal<n + 1>(rows);
}

template <int n>
void AppendUnrolled(OperationRows& rows) {
  const std::string order = std::to_string(n);
  const Operations turns = CountTurns(n, n);
  Append(rows, "product_hemisphere", order,
         CountKernel(kernels::MultiplyByFixed<axial::Hemisphere, n>{1}, kPlanes, kPlanes), turns);
  Append(rows, "product_cosine", order,
         CountKernel(kernels::MultiplyByFixed<axial::Cosine, n>{1}, kPlanes, kPlanes), turns);
  if constexpr (n < kMaxUnrolledOrder) AppendUnrolled<n + 1>(rows);
}

void AppendZonal(OperationRows& rows, const std::string& order, const Orders& orders) {
  Append(rows, "product_zonal", order,
         CountKernel(kernels::MultiplyByZonalAny{orders}, kPlanes, kPlanes, kPlanes),
         CountTurns(orders.b, orders.out));
}

}  // namespace

void AppendAxialOperations(OperationRows& rows) {
  AppendZonal<1>(rows);
  AppendUnrolled<1>(rows);
  for (int n = kernels::kMaxZonalOrder + 1; n <= kMaxOrder; ++n) {
    AppendZonal(rows, std::to_string(n), {n, n, n});
  }
  for (int n = kMaxUnrolledOrder + 1; n <= kMaxOrder; ++n) {
    const std::string order = std::to_string(n);
    const Operations turns = CountTurns(n, n);
    Append(rows, "product_hemisphere", order,
           CountKernel(kernels::MultiplyByFixedAny<axial::Hemisphere>{n}, kPlanes, kPlanes), turns);
    Append(rows, "product_cosine", order,
           CountKernel(kernels::MultiplyByFixedAny<axial::Cosine>{n}, kPlanes, kPlanes), turns);
  }
  for (const Orders& orders : {Orders{3, 6, 6}, Orders{6, 3, 3}, Orders{6, 6, 11}}) {
    AppendZonal(rows,
                std::to_string(orders.a) + "x" + std::to_string(orders.b) + "->" +
                    std::to_string(orders.out),
                orders);
  }
}

}  // namespace gaunt::product
