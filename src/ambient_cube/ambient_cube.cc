// SPDX-License-Identifier: MIT
#include "ambient_cube/ambient_cube.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ambient_cube/ambient_cube.cc"
#include <hwy/foreach_target.h>

#include "ambient_cube/ambient_cube-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::ambient_cube::HWY_NAMESPACE {

template <int n>
void ProjectBatch(Mode mode, size_t count, const simd::InView& radiance,
                  const simd::OutView& cube) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  const auto run = [&](const auto& kernel) {
    ForEachBatch(count, kernel, In<kChannels * kCoefficients>(radiance), Out<kPlanes>(cube));
  };
  if (mode == kClosest) {
    run(Project<std::min(n, 3)>{kCoefficients, kClosestLinear});
  } else if constexpr (n < 5) {
    run(Project<std::min(n, 3)>{kCoefficients, kSampledLinear});
  } else {
    run(Project<5>{kCoefficients, kSampledLinear});
  }
}

template <int n>
void ToShBatch(size_t count, const simd::InView& cube, const simd::OutView& radiance) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  ForEachBatch(count, ToSh<std::min(n, 3)>{kCoefficients}, In<kPlanes>(cube),
               Out<kChannels * kCoefficients>(radiance));
}

void EvaluateBatch(size_t count, const simd::InView& cube, const simd::InView& normals,
                   const simd::OutView& out) {
  if (count > 1 && cube.IsBroadcast()) {
    EvaluateOne one;
    for (size_t p = 0; p < kPlanes; ++p) {
      std::memcpy(&one.cube[p], cube.FromPlane(p).data, sizeof(float));
    }
    ForEachBatch(count, one, In<3>(normals), Out<kChannels>(out));
  } else {
    ForEachBatch(count, Evaluate(), In<kPlanes>(cube), In<3>(normals), Out<kChannels>(out));
  }
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &ProjectBatch<n>...}, {nullptr, &ToShBatch<n>...}, &EvaluateBatch};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxUnrolledOrder>());
  return &kTable;
}

}  // namespace gaunt::ambient_cube::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(ambient_cube);
