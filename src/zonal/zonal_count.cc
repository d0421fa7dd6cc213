// SPDX-License-Identifier: MIT
// Operations of the zonal kernels, by running them on counting lanes.
#include "simd/count.h"
#include "zonal/zonal-inl.h"

namespace gaunt::zonal {

void AppendOperations(OperationRows& rows);

namespace {

namespace kernels = HWY_NAMESPACE;

void AppendRows(OperationRows& rows, int order, size_t channels, const Operations& rotate,
                const Operations& rotate_add, const Operations& convolve) {
  const std::string variant = channels == 1 ? "mono" : "rgb";
  rows.push_back({"zonal_rotate", std::to_string(order), variant, rotate});
  rows.push_back({"zonal_rotate_add", std::to_string(order), variant, rotate_add});
  rows.push_back({"zonal_convolve", std::to_string(order), variant, convolve});
}

template <int n>
void Append(OperationRows& rows) {
  const CountPlanes p;
  for (const size_t channels : {1, 3}) {
    const kernels::Rotate<n> rotate{channels};
    AppendRows(rows, n, channels, CountKernel(rotate, p, p, p), CountKernel(rotate, p, p, p, p),
               CountKernel(kernels::Convolve<n>{channels}, p, p, p));
    const std::string variant = channels == 1 ? "mono" : "rgb";
    // One direction for all, whose basis is found once per call, and one kernel, weighed once.
    rows.push_back({"zonal_one_direction", std::to_string(n), variant,
                    CountKernel(kernels::RotateToOne<n>{channels, {}}, p, p)});
    rows.push_back({"zonal_one_kernel", std::to_string(n), variant,
                    CountKernel(kernels::ConvolveWeighed<n>{channels}, p, p, p)});
  }
  if constexpr (n < kMaxUnrolledOrder) Append<n + 1>(rows);
}

void AppendBands(OperationRows& rows, int order, size_t channels) {
  const CountPlanes p;
  const Operations weigh = CountKernel(kernels::WeighBands{static_cast<size_t>(order)}, p, p);
  Operations rotate = channels * weigh, rotate_add = rotate, convolve = weigh;
  for (int l = 0; l < order; ++l) {
    const Operations basis = CountKernel(basis::HWY_NAMESPACE::EvalBand{l}, p, p, p, p);
    const Operations scale = channels * CountKernel(kernels::ScaleBand{l}, p, p, p);
    rotate = rotate + basis + scale;
    rotate_add = rotate_add + basis + channels * CountKernel(kernels::ScaleBand{l}, p, p, p, p);
    convolve = convolve + scale;
  }
  AppendRows(rows, order, channels, rotate, rotate_add, convolve);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  Append<1>(rows);
  for (const int order : CountedOrders()) {
    if (order <= kMaxUnrolledOrder) continue;
    for (const size_t channels : {1, 3}) AppendBands(rows, order, channels);
  }
}

}  // namespace gaunt::zonal
