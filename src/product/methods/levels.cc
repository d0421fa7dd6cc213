// SPDX-License-Identifier: MIT
#include "product/methods/methods.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/methods/levels.cc"
#include <hwy/foreach_target.h>

#include "product/fixed_grid-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::methods::levels::HWY_NAMESPACE {

namespace kernels = product::HWY_NAMESPACE;
using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

template <int n, int level>
void Batch(size_t count, const simd::InView& a, const simd::InView& b, const simd::OutView& out) {
  constexpr size_t kPlanes = NumCoefficients(n);
  ForEachBatch(count, kernels::FixedGrid<n, n, n, static_cast<Level>(level)>(),
               In<kPlanes>(a, kPlanes, 0, Place::kNearby),
               In<kPlanes>(b, kPlanes, 0, Place::kNearby), Out<kPlanes>(out));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, n...>) {
  return {{{nullptr, nullptr, &Batch<kMinOrder + n, 0>...},
           {nullptr, nullptr, &Batch<kMinOrder + n, 1>...},
           {nullptr, nullptr, &Batch<kMinOrder + n, 2>...},
           {nullptr, nullptr, &Batch<kMinOrder + n, 3>...}}};
}

const Table* GetTable() {
  static constexpr Table kTable =
      MakeTable(std::make_integer_sequence<int, kMaxOrder - kMinOrder + 1>());
  return &kTable;
}

}  // namespace gaunt::product::methods::levels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::methods::levels);
