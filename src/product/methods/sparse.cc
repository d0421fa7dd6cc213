// SPDX-License-Identifier: MIT
#include "product/methods/methods.h"
#include "product/methods/sparse_plan.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/methods/sparse.cc"
#include <hwy/foreach_target.h>

#include "product/methods/sparse-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::methods::sparse::HWY_NAMESPACE {

namespace kernels = methods::HWY_NAMESPACE;
using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

template <int n, class Kernel>
void Batch(size_t count, const simd::InView& a, const simd::InView& b, const simd::OutView& out) {
  constexpr size_t kPlanes = NumCoefficients(n);
  ForEachBatch(count, Kernel(), In<kPlanes>(a), In<kPlanes>(b), Out<kPlanes>(out));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, n...>) {
  return {{nullptr, nullptr, &Batch<kMinOrder + n, kernels::ByOutput<kMinOrder + n>>...},
          {nullptr, nullptr, &Batch<kMinOrder + n, kernels::ByPairs<kMinOrder + n>>...}};
}

const Table* GetTable() {
  static constexpr Table kTable =
      MakeTable(std::make_integer_sequence<int, kMaxOrder - kMinOrder + 1>());
  return &kTable;
}

}  // namespace gaunt::product::methods::sparse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::methods::sparse);
