// SPDX-License-Identifier: MIT
#include "product/methods/methods.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/methods/dense.cc"
#include <hwy/foreach_target.h>

#include "product/matrix-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::methods::dense::HWY_NAMESPACE {

namespace kernels = product::HWY_NAMESPACE;
using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

template <int n>
void Batch(const float* matrix, size_t count, const simd::InView& in, const simd::OutView& out) {
  constexpr int kPlanes = NumCoefficients(n);
  ForEachBatch(count, kernels::Matrix<n>{matrix},
               In<kPlanes>(in, kPlanes, 0, Place::kNearby), Out<kPlanes>(out));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, n...>) {
  return {{nullptr, nullptr, &Batch<kMinOrder + n>...}};
}

const Table* GetTable() {
  static constexpr Table kTable =
      MakeTable(std::make_integer_sequence<int, product::kMaxOrder - kMinOrder + 1>());
  return &kTable;
}

}  // namespace gaunt::product::methods::dense::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::methods::dense);
