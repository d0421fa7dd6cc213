// SPDX-License-Identifier: MIT
#include "basis/basis.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/basis.cc"
#include <hwy/foreach_target.h>

#include "basis/basis-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::basis::HWY_NAMESPACE {

template <int n>
void EvalBatch(size_t count, const simd::InView& directions, const simd::OutView& out) {
  ForEachBatch(count, Eval<n>(), In<3>(directions), Out<NumCoefficients(n)>(out));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &EvalBatch<n>...}};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::basis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(basis);
