// SPDX-License-Identifier: MIT
#include "rotate/rotate.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rotate/rotate.cc"
#include <hwy/foreach_target.h>

#include "rotate/rotate-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

template <int n>
void MatrixBatch(size_t channels, size_t count, const simd::InView& matrices,
                 const simd::InView& in, const simd::OutView& out) {
  constexpr size_t kMaxPlanes = kMaxChannels * NumCoefficients(n);
  const size_t planes = channels * NumCoefficients(n);
  ForEachBatch(count, RotateMatrix<n>{channels}, In<9>(matrices), In<kMaxPlanes>(in, planes),
               Out<kMaxPlanes>(out, planes));
}

template <int n>
void QuaternionBatch(size_t channels, size_t count, const simd::InView& quaternions,
                     const simd::InView& in, const simd::OutView& out) {
  if (quaternions.IsBroadcast()) {
    float matrix[9];
    ForEachBatch(1, MatrixFromQuaternion(), In<4>(quaternions),
                 Out<9>(simd::InterleavedOut(matrix, 9)));
    return MatrixBatch<n>(channels, count, simd::BroadcastIn(matrix), in, out);
  }
  constexpr size_t kMaxPlanes = kMaxChannels * NumCoefficients(n);
  const size_t planes = channels * NumCoefficients(n);
  ForEachBatch(count, RotateQuaternion<n>{channels}, In<4>(quaternions), In<kMaxPlanes>(in, planes),
               Out<kMaxPlanes>(out, planes));
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &QuaternionBatch<n>...}, {nullptr, &MatrixBatch<n>...}};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxOrder>());
  return &kTable;
}

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(rotate);
