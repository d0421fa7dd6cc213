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
         CountKernel(kernels::MultiplyByZonal<n>{1}, kPlanes, kPlanes, kPlanes), CountTurns(n, n));
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

template <int a>
void AppendZonal(OperationRows& rows, int order, int out_order) {
  const bool is_square = order == a && out_order == a;
  Append(rows, "product_zonal",
         is_square
             ? std::to_string(a)
             : std::to_string(a) + "x" + std::to_string(order) + "->" + std::to_string(out_order),
         CountKernel(kernels::MultiplyByZonalAny<a>{order, out_order}, kPlanes, kPlanes, kPlanes),
         CountTurns(order, out_order));
}

}  // namespace

void AppendAxialOperations(OperationRows& rows) {
  AppendZonal<1>(rows);
  AppendUnrolled<1>(rows);
  AppendZonal<9>(rows, 9, 9);
  AppendZonal<10>(rows, 10, 10);
  AppendZonal<2>(rows, 6, 6);
  AppendZonal<3>(rows, 6, 6);
  AppendZonal<6>(rows, 3, 3);
  AppendZonal<6>(rows, 6, 11);
  for (int n = kMaxUnrolledOrder + 1; n <= kMaxOrder; ++n) {
    const std::string order = std::to_string(n);
    const Operations turns = CountTurns(n, n);
    Append(rows, "product_hemisphere", order,
           CountKernel(kernels::MultiplyByFixedAny<axial::Hemisphere>{n}, kPlanes, kPlanes), turns);
    Append(rows, "product_cosine", order,
           CountKernel(kernels::MultiplyByFixedAny<axial::Cosine>{n}, kPlanes, kPlanes), turns);
  }
}

}  // namespace gaunt::product
