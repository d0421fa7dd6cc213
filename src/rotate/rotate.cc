// SPDX-License-Identifier: MIT
#include "rotate/rotate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rotate/rotate.cc"
#include <hwy/foreach_target.h>

#include "rotate/rotate-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

// The kernel of order n: its own, or the one that higher orders share.
template <int n>
inline constexpr int kKernelOf = n <= kMaxInlinedOrder ? n : kAnyOrder;

// run(channels, in, out) for all channels at once, or for each of them where all of their planes
// are more than the stack should hold.
template <int n, class Run>
void ForChannels(size_t channels, const simd::InView& in, const simd::OutView& out,
                 const Run& run) {
  constexpr size_t kCoefficients = NumCoefficients(n);
  if constexpr (n <= kMaxInlinedOrder) {
    constexpr size_t kMaxPlanes = kMaxChannels * kCoefficients;
    const size_t planes = channels * kCoefficients;
    run(channels, In<kMaxPlanes>(in, planes), Out<kMaxPlanes>(out, planes));
  } else {
    constexpr size_t kMaxPlanes = NumCoefficients(kMaxOrder);
    for (size_t c = 0; c < channels; ++c) {
      run(1, In<kMaxPlanes>(in.FromPlane(c * kCoefficients), kCoefficients),
          Out<kMaxPlanes>(out.FromPlane(c * kCoefficients), kCoefficients));
    }
  }
}

// The first item.
template <size_t kPlanes>
std::array<float, kPlanes> FirstItem(const simd::InView& view) {
  std::array<float, kPlanes> item;
  for (size_t p = 0; p < kPlanes; ++p) {
    std::memcpy(&item[p], view.FromPlane(p).data, sizeof(float));
  }
  return item;
}

// One rotation for many items is worth a plan, but not at order 1, where it is a copy. Measured:
// making it takes as long as it saves on some 100 to 400 items, most at low orders.
template <int n>
constexpr size_t LeastPlannedItems() {
  return n == 1 ? std::numeric_limits<size_t>::max() : n <= kMaxTensorOrder ? 512 : 256;
}

// Those that follow are out of line: the stack holds the tiles of one of them at most.

template <int n>
HWY_NOINLINE void MoveBatch(const Moves& moves, size_t channels, size_t count,
                            const simd::InView& in, const simd::OutView& out) {
  ForChannels<n>(channels, in, out, [&](size_t now, auto&& from, auto&& to) {
    ForEachBatch(count, ApplyMoves{n, now, moves}, from, to);
  });
}

template <int n>
HWY_NOINLINE void PlanBatch(const Rotation& rotation, size_t channels, size_t count,
                            const simd::InView& in, const simd::OutView& out) {
  const Plan plan = rotation.MakePlan(n);
  ForChannels<n>(channels, in, out, [&](size_t now, auto&& from, auto&& to) {
    ForEachBatch(count, ApplyPlan<kKernelOf<n>>(plan, n, now), from, to);
  });
}

// first(rotation, middle), then second(middle, from, to); of one rotation for all the first once.
template <size_t kRotation, size_t kMiddle, class First, class Second, class From, class To>
void StagedBatch(size_t count, const First& first, const simd::InView& rotations,
                 const Second& second, From& from, To& to) {
  if (rotations.IsBroadcast()) {
    float middle[kMiddle] = {};
    ForEachBatch(1, first, In<kRotation>(rotations),
                 Out<kMiddle>(simd::InterleavedOut(middle, kMiddle)));
    ForEachBatch(count, second, In<kMiddle>(simd::BroadcastIn(middle)), from, to);
  } else {
    ForEachStaged<kMiddle>(count, first, In<kRotation>(rotations), second, from, to);
  }
}

template <int n>
HWY_NOINLINE void EachQuaternionBatch(size_t channels, size_t count,
                                      const simd::InView& quaternions, const simd::InView& in,
                                      const simd::OutView& out) {
  ForChannels<n>(channels, in, out, [&](size_t now, auto&& from, auto&& to) {
    if constexpr (n <= kMaxFusedOrder) {
      ForEachBatch(count, RotateTensorsByQuaternion<n>{now}, In<4>(quaternions), from, to);
    } else if constexpr (n <= kMaxTensorOrder) {
      StagedBatch<4, 9>(count, MatrixFromQuaternion(), quaternions, RotateTensorsByMatrix<n>{now},
                        from, to);
    } else {
      StagedBatch<4, kAnglePlanes>(count, AnglesFromQuaternion(), quaternions,
                                   RotateBands<kKernelOf<n>, false>(n, now), from, to);
    }
  });
}

template <int n>
HWY_NOINLINE void EachMatrixBatch(size_t channels, size_t count, const simd::InView& matrices,
                                  const simd::InView& in, const simd::OutView& out) {
  ForChannels<n>(channels, in, out, [&](size_t now, auto&& from, auto&& to) {
    if constexpr (n <= kMaxTensorOrder) {
      ForEachBatch(count, RotateTensorsByMatrix<n>{now}, In<9>(matrices), from, to);
    } else {
      StagedBatch<9, kAnglePlanes>(count, AnglesFromMatrix(), matrices,
                                   RotateBands<kKernelOf<n>, true>(n, now), from, to);
    }
  });
}

// Whether the rotation is one for all and has been applied as such.
template <int n>
bool OneBatch(const Rotation& rotation, size_t channels, size_t count, const simd::InView& in,
              const simd::OutView& out) {
  Moves moves;
  if (rotation.MakeMoves(moves)) {
    MoveBatch<n>(moves, channels, count, in, out);
  } else if (count >= LeastPlannedItems<n>()) {
    PlanBatch<n>(rotation, channels, count, in, out);
  } else {
    return false;
  }
  return true;
}

template <int n>
void QuaternionBatch(size_t channels, size_t count, const simd::InView& quaternions,
                     const simd::InView& in, const simd::OutView& out) {
  if (quaternions.IsBroadcast()) {
    const auto one = FirstItem<4>(quaternions);
    if ((count >= LeastPlannedItems<n>() || Rotation::MayKeepZ(one)) &&
        OneBatch<n>(Rotation::OfQuaternion(one.data()), channels, count, in, out)) {
      return;
    }
  }
  EachQuaternionBatch<n>(channels, count, quaternions, in, out);
}

template <int n>
void MatrixBatch(size_t channels, size_t count, const simd::InView& matrices,
                 const simd::InView& in, const simd::OutView& out) {
  if (matrices.IsBroadcast()) {
    const auto one = FirstItem<9>(matrices);
    if ((count >= LeastPlannedItems<n>() || Rotation::MayKeepZ(one)) &&
        OneBatch<n>(Rotation::OfMatrix(one.data()), channels, count, in, out)) {
      return;
    }
  }
  EachMatrixBatch<n>(channels, count, matrices, in, out);
}

float Deviations(size_t count, const simd::InView& matrices) {
  constexpr size_t kItems = 8 * kTileItems;
  float deviations[kItems];
  float worst = 0.0f;
  for (size_t first = 0; first < count; first += kItems) {
    const size_t n = std::min(kItems, count - first);
    ForEachBatch(n, Deviation(), In<9>(matrices, 9, first),
                 Out<1>(simd::InterleavedOut(deviations, 1)));
    for (size_t i = 0; i < n; ++i) {
      const float deviation = deviations[i];
      if (!(deviation <= std::numeric_limits<float>::max())) return HUGE_VALF;
      worst = std::max(worst, deviation);
    }
  }
  return worst;
}

template <int... n>
constexpr Table MakeTable(std::integer_sequence<int, 0, n...>) {
  return {{nullptr, &QuaternionBatch<n>...}, {nullptr, &MatrixBatch<n>...}, &Deviations};
}

const Table* GetTable() {
  static constexpr Table kTable = MakeTable(Orders<kMaxOrder>());
  return &kTable;
}

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(rotate);
