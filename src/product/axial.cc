// SPDX-License-Identifier: MIT
#include "product/axial.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/axial.cc"
#include <hwy/foreach_target.h>

#include "product/axial-inl.h"
#include "product/axis-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::axial::HWY_NAMESPACE {

constexpr size_t Planes(int order) { return static_cast<size_t>(NumCoefficients(order)); }
inline constexpr size_t kMaxPlanes = Planes(kMaxOrder);
// About z, and about axes, which rotation limits.
inline constexpr size_t kMaxOutPlanes = Planes(kMaxOutOrder);
inline constexpr size_t kMaxTurnedPlanes = Planes(rotate::kMaxOrder);
// Of all channels.
template <int n>
inline constexpr size_t kAllPlanes = kMaxChannels* Planes(n);

// Zonal functions about z, which vary: their planes, and the kernels that multiply by them.
class ZonalFactor {
 public:
  ZonalFactor(const Orders& orders, const simd::InView& view) : orders_(orders), view_(view) {}
  int in_order() const { return orders_.b; }
  int out_order() const { return orders_.out; }
  bool IsUnrolled() const { return IsSquare() && orders_.a <= kMaxUnrolledOrder; }

  // run(kernel, side) with all channels of order n, or with channel c of any order.
  template <int n, class Run>
  void Unrolled(size_t channels, const Run& run) const {
    run(MultiplyByZonal<n>{channels}, In<kMaxChannels * n>(view_, channels * n));
  }
  template <class Run>
  void Any(size_t c, const Run& run) const {
    const size_t bands = static_cast<size_t>(orders_.a);
    In<kMaxOrder> zonal(view_.FromPlane(c * bands), bands);
    RunOrder<1>(zonal, run);
  }

 private:
  bool IsSquare() const { return orders_.a == orders_.b && orders_.a == orders_.out; }

  // The kernel of zonal functions of the order, which is n or more.
  template <int n, class Run>
  void RunOrder(In<kMaxOrder>& zonal, const Run& run) const {
    if constexpr (n < kMaxOrder) {
      if (orders_.a > n) return RunOrder<n + 1>(zonal, run);
    }
    RunKernel<n>(zonal, run);
  }
  // Apart, so that the stack has the tiles of one order only.
  template <int n, class Run>
  HWY_NOINLINE void RunKernel(In<kMaxOrder>& zonal, const Run& run) const {
    if constexpr (n > kMaxUnrolledOrder && n <= kMaxZonalOrder) {
      if (IsSquare()) return run(MultiplyByZonal<n>{1}, zonal);
    }
    run(MultiplyByZonalAny<n>{orders_.b, orders_.out}, zonal);
  }

  const Orders& orders_;
  const simd::InView& view_;
};

// Functions that do not.
template <class Matrix>
class FixedFactor {
 public:
  explicit FixedFactor(int order) : order_(order) {}
  int in_order() const { return order_; }
  int out_order() const { return order_; }
  bool IsUnrolled() const { return order_ <= kMaxUnrolledOrder; }

  template <int n, class Run>
  void Unrolled(size_t channels, const Run& run) const {
    run(MultiplyByFixed<Matrix, n>{channels});
  }
  template <class Run>
  void Any(size_t, const Run& run) const {
    run(MultiplyByFixedAny<Matrix>{order_});
  }

 private:
  int order_;
};

// About z.
template <class Factor>
struct AboutZ {
  const Factor& factor;
  size_t count;

  template <int n>
  HWY_NOINLINE void Unrolled(size_t channels, const simd::InView& in,
                             const simd::OutView& out) const {
    factor.template Unrolled<n>(channels, [&](const auto& kernel, auto&&... zonal) {
      ForEachBatch(count, kernel, zonal..., In<kAllPlanes<n>>(in, channels * Planes(n)),
                   Out<kAllPlanes<n>>(out, channels * Planes(n)));
    });
  }

  HWY_NOINLINE void Any(size_t c, const simd::InView& in, const simd::OutView& out) const {
    const size_t in_planes = Planes(factor.in_order()), out_planes = Planes(factor.out_order());
    factor.Any(c, [&](const auto& kernel, auto&&... zonal) {
      ForEachBatch(count, kernel, zonal..., In<kMaxPlanes>(in, in_planes),
                   Out<kMaxOutPlanes>(out, out_planes));
    });
  }
};

GAUNT_LANES InCursor AsRead(const OutCursor& cursor) {
  return {cursor.data, cursor.plane_stride, cursor.step, cursor.jump, cursor.groups, cursor.left};
}

// A kernel that reads a function, and a side besides or nothing, and writes another.
class Stage {
 public:
  template <class Kernel>
  static Stage Of(const Kernel& kernel) {
    return {&kernel, [](const void* k, size_t groups, const InCursor*, const InCursor& in,
                        const OutCursor& out) {
              RunGroups<Lanes>(*static_cast<const Kernel*>(k), groups, in, out);
            }};
  }
  template <class Kernel>
  static Stage OfTwo(const Kernel& kernel) {
    return {&kernel, [](const void* k, size_t groups, const InCursor* side, const InCursor& in,
                        const OutCursor& out) {
              RunGroups<Lanes>(*static_cast<const Kernel*>(k), groups, *side, in, out);
            }};
  }

  void Run(size_t groups, const InCursor* side, const InCursor& in, const OutCursor& out) const {
    run_(kernel_, groups, side, in, out);
  }

 private:
  using Function = void (*)(const void* kernel, size_t groups, const InCursor* side,
                            const InCursor& in, const OutCursor& out);
  Stage(const void* kernel, Function run) : kernel_(kernel), run_(run) {}

  const void* kernel_;
  Function run_;
};

// A product about axes: turned to z, multiplied, turned back. Functions that are turned are kept in
// tiles; a product that has as many planes replaces them, others are turned where they are written.
struct AxisStages {
  Stage to_z, multiply, from_z;
  size_t in_planes, out_planes;

  // `turned` has room for the planes of that many tiles. Without zonal functions, `zonal` is null.
  HWY_NOINLINE void Run(const simd::InView& axes_view, size_t count, InSide& in, OutSide& out,
                        InSide* zonal, float* turned, size_t tiles) const {
    constexpr size_t kMaxTiles = 8;
    HWY_ALIGN float angles[kAxisAnglePlanes * kMaxTiles * kTileItems];
    const size_t lanes = hn::Lanes(LaneTag());
    In<3> axes(axes_view);
    out.Expect(count);
    const size_t most =
        std::min({std::min(tiles, kMaxTiles) * kTileItems, ItemsOf(axes), ItemsOf(in), ItemsOf(out),
                  zonal != nullptr ? ItemsOf(*zonal) : ItemsOf(in)});
    for (size_t done = 0, n; done < count; done += n) {
      const size_t left = count - done;
      n = std::min(most, left >= lanes ? left / lanes * lanes : left);
      const size_t groups = (n + lanes - 1) / lanes;
      RunGroups<Lanes>(AnglesOfAxis(), groups, axes.Begin(done, n),
                       OutCursor::Tiles(angles, kAxisAnglePlanes));
      const InCursor angle = InCursor::Tiles(angles, kAxisAnglePlanes);
      const OutCursor middle = OutCursor::Tiles(turned, in_planes), to = out.Begin(done, n);
      const OutCursor product = in_planes == out_planes ? middle : to;
      to_z.Run(groups, &angle, in.Begin(done, n), middle);
      const InCursor factor = zonal != nullptr ? zonal->Begin(done, n) : angle;
      multiply.Run(groups, &factor, AsRead(middle), product);
      from_z.Run(groups, &angle, AsRead(product), to);
      out.End(done, n);
    }
    out.Finish();
  }

 private:
  // That a side can have at a time.
  template <class Side>
  static size_t ItemsOf(const Side& side) {
    return side.direct() ? std::numeric_limits<size_t>::max() : side.items();
  }
};

inline InSide* SideOf() { return nullptr; }
inline InSide* SideOf(InSide& zonal) { return &zonal; }
template <class Kernel, class... Zonal>
Stage MultiplyStage(const Kernel& kernel, const Zonal&...) {
  if constexpr (sizeof...(Zonal) == 0) {
    return Stage::Of(kernel);
  } else {
    return Stage::OfTwo(kernel);
  }
}

// About an axis of each item.
template <class Factor>
struct AboutAxes {
  const Factor& factor;
  size_t count;
  const simd::InView& axes;

  template <int n>
  HWY_NOINLINE void Unrolled(size_t channels, const simd::InView& in,
                             const simd::OutView& out) const {
    const size_t planes = channels * Planes(n);
    factor.template Unrolled<n>(channels, [&](const auto& kernel, auto&&... zonal) {
      Run<kAllPlanes<n>, kAllPlanes<n>>(TurnAxis<n, true, n>{n, channels}, kernel,
                                        TurnAxis<n, false, n>{n, channels}, planes, planes, in, out,
                                        zonal...);
    });
  }

  HWY_NOINLINE void Any(size_t c, const simd::InView& in, const simd::OutView& out) const {
    const int in_order = factor.in_order(), out_order = factor.out_order();
    factor.Any(c, [&](const auto& kernel, auto&&... zonal) {
      Run<kMaxPlanes, kMaxTurnedPlanes>(TurnAxis<kAnyOrder, true, kMaxOrder>{in_order, 1}, kernel,
                                        TurnAxis<kAnyOrder, false, rotate::kMaxOrder>{out_order, 1},
                                        Planes(in_order), Planes(out_order), in, out, zonal...);
    });
  }

 private:
  template <size_t kInPlanes, size_t kOutPlanes, class ToZ, class Kernel, class FromZ,
            class... Zonal>
  void Run(const ToZ& to_z, const Kernel& kernel, const FromZ& from_z, size_t in_planes,
           size_t out_planes, const simd::InView& in, const simd::OutView& out,
           Zonal&... zonal) const {
    HWY_ALIGN float turned[kInPlanes * kTileItems];
    In<kInPlanes> from(in, in_planes);
    Out<kOutPlanes> to(out, out_planes);
    const AxisStages stages = {Stage::OfTwo(to_z), MultiplyStage(kernel, zonal...),
                               Stage::OfTwo(from_z), in_planes, out_planes};
    stages.Run(axes, count, from, to, SideOf(zonal...), turned, kInPlanes / in_planes);
  }
};

// Orders that are unrolled: all channels at once.
template <class Batch, int... n>
void RunUnrolled(const Batch& batch, int order, size_t channels, const simd::InView& in,
                 const simd::OutView& out, std::integer_sequence<int, n...>) {
  using Function = void (Batch::*)(size_t, const simd::InView&, const simd::OutView&) const;
  static constexpr std::array<Function, sizeof...(n)> kFunctions = {
      &Batch::template Unrolled<n + 1>...};
  (batch.*kFunctions[static_cast<size_t>(order - 1)])(channels, in, out);
}

// Others share a kernel, channel by channel.
template <class Batch>
void RunOrders(const Batch& batch, size_t channels, const simd::InView& in,
               const simd::OutView& out) {
  const auto& factor = batch.factor;
  if (factor.IsUnrolled()) {
    return RunUnrolled(batch, factor.in_order(), channels, in, out,
                       std::make_integer_sequence<int, kMaxUnrolledOrder>());
  }
  for (size_t c = 0; c < channels; ++c) {
    batch.Any(c, in.FromPlane(c * Planes(factor.in_order())),
              out.FromPlane(c * Planes(factor.out_order())));
  }
}

void ZonalBatch(const Orders& orders, size_t channels, size_t count, const simd::InView& zonal,
                const simd::InView& b, const simd::OutView& out) {
  const ZonalFactor factor(orders, zonal);
  RunOrders(AboutZ<ZonalFactor>{factor, count}, channels, b, out);
}

void ZonalAxisBatch(const Orders& orders, size_t channels, size_t count, const simd::InView& zonal,
                    const simd::InView& axes, const simd::InView& b, const simd::OutView& out) {
  const ZonalFactor factor(orders, zonal);
  RunOrders(AboutAxes<ZonalFactor>{factor, count, axes}, channels, b, out);
}

template <class Matrix>
void FixedBatch(int order, size_t channels, size_t count, const simd::InView& in,
                const simd::OutView& out) {
  const FixedFactor<Matrix> factor(order);
  RunOrders(AboutZ<FixedFactor<Matrix>>{factor, count}, channels, in, out);
}

template <class Matrix>
void FixedAxisBatch(int order, size_t channels, size_t count, const simd::InView& axes,
                    const simd::InView& in, const simd::OutView& out) {
  const FixedFactor<Matrix> factor(order);
  RunOrders(AboutAxes<FixedFactor<Matrix>>{factor, count, axes}, channels, in, out);
}

const Table* GetTable() {
  static constexpr Table kTable = {&ZonalBatch,
                                   &ZonalAxisBatch,
                                   &FixedBatch<Hemisphere>,
                                   &FixedAxisBatch<Hemisphere>,
                                   &FixedBatch<Cosine>,
                                   &FixedAxisBatch<Cosine>};
  return &kTable;
}

}  // namespace gaunt::product::axial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::axial);
