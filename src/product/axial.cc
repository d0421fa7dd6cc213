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
inline constexpr size_t kAllPlanes = kMaxChannels * Planes(n);

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
    if (!IsSquare() || !RunOwn<kMaxUnrolledOrder + 1>(zonal, run)) {
      run(MultiplyByZonalAny{orders_}, zonal);
    }
  }

 private:
  bool IsSquare() const { return orders_.a == orders_.b && orders_.a == orders_.out; }

  // The kernel of an order from n up, if there is one.
  template <int n, class Run>
  bool RunOwn(In<kMaxOrder>& zonal, const Run& run) const {
    if constexpr (n <= kMaxZonalOrder) {
      if (orders_.a != n) return RunOwn<n + 1>(zonal, run);
      run(MultiplyByZonal<n>{1}, zonal);
      return true;
    } else {
      return false;
    }
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

// The three stages of a product about axes: to_z, multiply, from_z. Functions that are turned are
// kept in tiles; a product that has as many planes replaces them, others are turned where they are
// written.
template <size_t kTurnedPlanes>
class AxisStages {
 public:
  AxisStages(const simd::InView& axes, size_t count, size_t in_planes, size_t out_planes)
      : axes_(axes), count_(count), in_planes_(in_planes), out_planes_(out_planes) {}

  template <class ToZ, class Multiply, class FromZ, class... Zonal>
  HWY_NOINLINE void Run(const ToZ& to_z, const Multiply& multiply, const FromZ& from_z, InSide& in,
                        OutSide& out, Zonal&... zonal) {
    const size_t lanes = hn::Lanes(LaneTag());
    In<3> axes(axes_);
    out.Expect(count_);
    const size_t tiles = std::min(kMaxTiles, kFloats / (kTileItems * in_planes_));
    const size_t most = std::min({tiles * kTileItems, ItemsOf(axes), ItemsOf(in), ItemsOf(out),
                                  ItemsOf(zonal)...});
    for (size_t done = 0, n; done < count_; done += n) {
      const size_t left = count_ - done;
      n = std::min(most, left >= lanes ? left / lanes * lanes : left);
      const size_t groups = (n + lanes - 1) / lanes;
      const InCursor angles = InCursor::Tiles(angles_, kAxisAnglePlanes);
      RunGroups<Lanes>(AnglesOfAxis(), groups, axes.Begin(done, n),
                       OutCursor::Tiles(angles_, kAxisAnglePlanes));
      const OutCursor turned = OutCursor::Tiles(turned_, in_planes_), to = out.Begin(done, n);
      RunGroups<Lanes>(to_z, groups, angles, in.Begin(done, n), turned);
      const OutCursor product = in_planes_ == out_planes_ ? turned : to;
      RunGroups<Lanes>(multiply, groups, zonal.Begin(done, n)..., AsRead(turned), product);
      RunGroups<Lanes>(from_z, groups, angles, AsRead(product), to);
      out.End(done, n);
    }
    out.Finish();
  }

 private:
  static constexpr size_t kMaxTiles = 8;
  static constexpr size_t kFloats = kTurnedPlanes * kTileItems;

  // That a side can have at a time.
  template <class Side>
  static size_t ItemsOf(const Side& side) {
    return side.direct() ? std::numeric_limits<size_t>::max() : side.items();
  }

  const simd::InView& axes_;
  size_t count_;
  size_t in_planes_, out_planes_;
  HWY_ALIGN float angles_[kAxisAnglePlanes * kMaxTiles * kTileItems];
  HWY_ALIGN float turned_[kFloats];
};

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
      In<kAllPlanes<n>> from(in, planes);
      Out<kAllPlanes<n>> to(out, planes);
      AxisStages<kAllPlanes<n>>(axes, count, planes, planes)
          .Run(TurnAxis<n, true, n>{n, channels}, kernel, TurnAxis<n, false, n>{n, channels}, from,
               to, AsSide(zonal)...);
    });
  }

  HWY_NOINLINE void Any(size_t c, const simd::InView& in, const simd::OutView& out) const {
    const int in_order = factor.in_order(), out_order = factor.out_order();
    factor.Any(c, [&](const auto& kernel, auto&&... zonal) {
      In<kMaxPlanes> from(in, Planes(in_order));
      Out<kMaxTurnedPlanes> to(out, Planes(out_order));
      AxisStages<kMaxPlanes>(axes, count, Planes(in_order), Planes(out_order))
          .Run(TurnAxis<kAnyOrder, true, kMaxOrder>{in_order, 1}, kernel,
               TurnAxis<kAnyOrder, false, rotate::kMaxOrder>{out_order, 1}, from, to, AsSide(zonal)...);
    });
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
  static constexpr Table kTable = {&ZonalBatch,         &ZonalAxisBatch,
                                   &FixedBatch<Hemisphere>, &FixedAxisBatch<Hemisphere>,
                                   &FixedBatch<Cosine>, &FixedAxisBatch<Cosine>};
  return &kTable;
}

}  // namespace gaunt::product::axial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::axial);
