// SPDX-License-Identifier: MIT
// The batch driver: runs a kernel over every item of a batch, in any layout. Whole groups of lanes
// that lie contiguous in memory are used in place; foreign layouts and the tail go through a stack
// tile and the same code of the kernel.
#if defined(GAUNT_SIMD_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_BATCH_INL_H_
#undef GAUNT_SIMD_BATCH_INL_H_
#else
#define GAUNT_SIMD_BATCH_INL_H_
#endif

#include <hwy/cache_control.h>

#include <algorithm>

#include "simd/lanes-inl.h"
#include "simd/tile-inl.h"
#include "simd/view.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

// Walks over groups of lanes: `step` bytes to the next one, and `jump` more after each `groups`.
template <class Planes, typename Byte>
struct Cursor {
  Byte* data;
  ptrdiff_t plane_stride;
  ptrdiff_t step;
  ptrdiff_t jump;
  size_t groups;
  size_t left;

  Cursor(Byte* d, ptrdiff_t plane, ptrdiff_t s, ptrdiff_t j, size_t g, size_t l)
      : data(d), plane_stride(plane), step(s), jump(j), groups(g), left(l) {}
  // Field by field: as a block it would be read back wider than it was written, which is slow.
  GAUNT_LANES Cursor(const Cursor& o)
      : data(o.data),
        plane_stride(o.plane_stride),
        step(o.step),
        jump(o.jump),
        groups(o.groups),
        left(o.left) {}

  static Cursor At(const simd::BasicView<Byte>& view, size_t first) {
    const size_t lanes = hn::Lanes(LaneTag());
    const ptrdiff_t step = static_cast<ptrdiff_t>(lanes * sizeof(float));
    if (view.tile_items == 0) return {view.Item(first), view.plane_stride, step, 0, 0, 0};
    const size_t groups = view.tile_items / lanes;
    return {view.Item(first),
            view.plane_stride,
            step,
            view.tile_stride - static_cast<ptrdiff_t>(groups) * step,
            groups,
            first == 0 ? groups : groups - first % view.tile_items / lanes};
  }

  static Cursor Tiles(float* tile, size_t planes) {
    const size_t groups = kTileItems / hn::Lanes(LaneTag());
    return {reinterpret_cast<Byte*>(tile),
            kTileStride,
            kTileStride / static_cast<ptrdiff_t>(groups),
            kTileStride * (static_cast<ptrdiff_t>(planes) - 1),
            groups,
            groups};
  }

  // The same group for ever, which is what a broadcast needs.
  static Cursor Still(float* tile) {
    return {reinterpret_cast<Byte*>(tile), kTileStride, 0, 0, 0, 0};
  }

  GAUNT_LANES Planes Here() const { return {data, plane_stride}; }
  GAUNT_LANES void Next() {
    data += step;
    if (--left == 0) {  // never, from 0 up, without tiles
      data += jump;
      left = groups;
    }
  }
};

using InCursor = Cursor<PlanesIn, const unsigned char>;
using OutCursor = Cursor<PlanesOut, unsigned char>;

// Tiles that are converted at a time, where they fit on the stack.
constexpr size_t NumTiles(size_t planes) {
  constexpr size_t kBudget = 5120;
  return std::clamp<size_t>(kBudget / (planes * kTileStride), 1, 8);
}

// Outputs from this size up are streamed past the caches where they can be. Measured: up to the size
// of the last-level cache (32 MiB there) ordinary stores are faster, beyond it they take twice the
// time, since every line is read before it is written.
constexpr bool WorthStreaming(size_t count, size_t planes) {
  constexpr size_t kBytes = size_t{32} << 20;
  return count * planes >= kBytes / sizeof(float);
}

// Where a kernel wants its planes: wherever they lie; close together, if it reads them again and
// again, which planes far apart would keep out of the first cache; or apart, in tiles of its own, if
// it writes before it has read all, or reads what it has written.
enum class Place { kAnywhere, kNearby, kApart };
inline constexpr ptrdiff_t kNearbyStride = 4 * kTileStride;

// One view of a batch, and the stack tiles that stand in for it where it cannot be used in place.
template <class Cursor, class View>
class Side {
 public:
  bool direct() const { return direct_; }
  size_t items() const { return items_; }

 protected:
  Side(const View& view, size_t planes, size_t first, Place place, float* tile, size_t items)
      : view_(view),
        planes_(planes),
        first_(first),
        shape_(ShapeOf(view, planes)),
        direct_(IsContiguous(view, hn::Lanes(LaneTag())) && Suits(view.plane_stride, place)),
        tile_(tile),
        items_(items) {}

  static bool Suits(ptrdiff_t stride, Place place) {
    return place == Place::kAnywhere ||
           (place == Place::kNearby && stride <= kNearbyStride && stride >= -kNearbyStride);
  }

  // Whole groups are used where they lie; a tail never is.
  bool InPlace(size_t n) const { return direct_ && n % hn::Lanes(LaneTag()) == 0; }

  View view_;
  size_t planes_;
  size_t first_;
  RowShape shape_;
  bool direct_;
  float* tile_;
  size_t items_;  // that the tiles hold
};

class InSide : public Side<InCursor, simd::InView> {
 public:
  HWY_NOINLINE InCursor Begin(size_t first, size_t n) {
    if (splat_) return InCursor::Still(tile_);
    if (InPlace(n)) return InCursor::At(view_, first_ + first);
    LoadTiles(view_, shape_, first_ + first, n, planes_, tile_);
    return InCursor::Tiles(tile_, planes_);
  }
  void Expect(size_t) {}
  void End(size_t, size_t) {}
  void Finish() {}

 protected:
  HWY_NOINLINE InSide(const simd::InView& view, size_t planes, size_t first, Place place,
                      float* tile, size_t items)
      : Side(view, planes, first, place, tile, items), splat_(view.IsBroadcast()) {
    if (!splat_) return;
    LoadTiles(view, RowShape::kOther, 0, 1, planes, tile);
    direct_ = true;
  }

 private:
  bool splat_;
};

class OutSide : public Side<OutCursor, simd::OutView> {
 public:
  void Expect(size_t count) {
    streams_ = WorthStreaming(count, planes_) && CanStream(view_, first_, planes_);
    if (streams_) direct_ = false;
  }
  HWY_NOINLINE OutCursor Begin(size_t first, size_t n) {
    return InPlace(n) ? OutCursor::At(view_, first_ + first) : OutCursor::Tiles(tile_, planes_);
  }
  HWY_NOINLINE void End(size_t first, size_t n) {
    if (InPlace(n)) return;
    const size_t whole = streams_ ? n / kTileItems * kTileItems : 0;
    if (whole != 0) StreamTiles(tile_, view_, shape_, first_ + first, whole, planes_);
    StoreTiles(InTiles(tile_, planes_, whole), view_, shape_, first_ + first + whole, n - whole,
               planes_);
  }
  void Finish() {
    if (streams_) hwy::FlushStream();
  }

 protected:
  HWY_NOINLINE OutSide(const simd::OutView& view, size_t planes, size_t first, Place place,
                       float* tile, size_t items)
      : Side(view, planes, first, place, tile, items) {}

 private:
  bool streams_ = false;  // past the caches
};

// Storage of a side whose items have at most kPlanes planes; the batch begins at item `first`, a
// multiple of the lanes where whole groups follow.
template <size_t kPlanes>
struct TileStorage {
  static constexpr size_t kItems = NumTiles(kPlanes) * kTileItems;
  HWY_ALIGN float tile[kItems * kPlanes];
};

template <size_t kPlanes>
class In : private TileStorage<kPlanes>, public InSide {
 public:
  explicit In(const simd::InView& view, size_t planes = kPlanes, size_t first = 0,
              Place place = Place::kAnywhere)
      : InSide(view, planes, first, place, this->tile, TileStorage<kPlanes>::kItems) {}
};

template <size_t kPlanes>
class Out : private TileStorage<kPlanes>, public OutSide {
 public:
  explicit Out(const simd::OutView& view, size_t planes = kPlanes, size_t first = 0,
               Place place = Place::kAnywhere)
      : OutSide(view, planes, first, place, this->tile, TileStorage<kPlanes>::kItems) {}
};

template <class K, class Kernel, class... Cursors>
GAUNT_LANES void Loop(const Kernel kernel, size_t groups, Cursors... cursors) {
  const K k;
  for (; groups != 0; --groups) {
    kernel(k, cursors.Here()...);
    (cursors.Next(), ...);
  }
}

// The one place where a kernel is instantiated. Out of line, with every cursor a local value: the
// compiler knows that no store of the kernel changes them.
template <class K, class Kernel, class... Cursors>
HWY_NOINLINE void RunGroups(const Kernel& kernel, size_t groups, const Cursors&... cursors) {
  Loop<K, Kernel, Cursors...>(kernel, groups, cursors...);
}

// Once per kernel, whatever the sizes of the sides' tiles.
template <class K, class Kernel, class... Sides>
HWY_NOINLINE void RunBatch(size_t count, const Kernel& kernel, Sides&... sides) {
  const size_t lanes = hn::Lanes(LaneTag());
  (sides.Expect(count), ...);
  const size_t most = (sides.direct() && ...) ? count : std::min({sides.items()...});
  for (size_t done = 0, n; done < count; done += n) {
    // Whole groups, then the tail: a side that is used in place must see whole groups.
    const size_t left = count - done;
    n = std::min(most, left >= lanes ? left / lanes * lanes : left);
    RunGroups<K>(kernel, (n + lanes - 1) / lanes, sides.Begin(done, n)...);
    (sides.End(done, n), ...);
  }
  (sides.Finish(), ...);
}

inline InSide& AsSide(InSide& side) { return side; }
inline OutSide& AsSide(OutSide& side) { return side; }

// Runs kernel(k, planes...) over `count` items; each side is an In or an Out. The kernel reads all
// of its inputs of one channel before it writes that channel, so outputs may be inputs in place.
template <class K = Lanes, class Kernel, class... Sides>
void ForEachBatch(size_t count, const Kernel& kernel, Sides&&... sides) {
  RunBatch<K>(count, kernel, AsSide(sides)...);
}

// Items whose first stage is kept until the second.
inline constexpr size_t kStagedItems = 8 * kTileItems;

template <size_t kMiddle, class First, class Second, class... Sides>
HWY_NOINLINE void RunStaged(size_t count, const First& first, const Second& second, InSide& input,
                            Sides&... sides) {
  HWY_ALIGN float middle[kMiddle * kStagedItems];
  const size_t lanes = hn::Lanes(LaneTag());
  (sides.Expect(count), ...);
  const size_t most = std::min(
      {kStagedItems, input.direct() ? kStagedItems : input.items(),
       (sides.direct() ? kStagedItems : sides.items())...});
  for (size_t done = 0, n; done < count; done += n) {
    const size_t left = count - done;
    n = std::min(most, left >= lanes ? left / lanes * lanes : left);
    const size_t groups = (n + lanes - 1) / lanes;
    RunGroups<Lanes>(first, groups, input.Begin(done, n), OutCursor::Tiles(middle, kMiddle));
    RunGroups<Lanes>(second, groups, InCursor::Tiles(middle, kMiddle), sides.Begin(done, n)...);
    (sides.End(done, n), ...);
  }
  (sides.Finish(), ...);
}

// Two kernels one after the other: first(k, input, middle), then second(k, middle, planes...). A
// chain of operations that wait for each other, such as roots and divisions, runs side by side for
// several groups of lanes where it has a short loop of its own.
template <size_t kMiddle, class First, class Input, class Second, class... Sides>
void ForEachStaged(size_t count, const First& first, Input&& input, const Second& second,
                   Sides&&... sides) {
  RunStaged<kMiddle>(count, first, second, AsSide(input), AsSide(sides)...);
}

#if GAUNT_WIDE_TRANSPOSES

template <size_t kIn, size_t kOut, class Kernel>
HWY_NOINLINE void RunPacked(const Kernel kernel, size_t groups, const float* HWY_RESTRICT in,
                            float* HWY_RESTRICT out) {
  HWY_ALIGN float in_tile[kIn * kTileItems];
  HWY_ALIGN float out_tile[kOut * kTileItems];
  const Lanes k;
  for (; groups != 0; --groups) {
    LoadPackedGroup<kIn>(in, in_tile);
    kernel(k, TileIn(in_tile), TileOut(out_tile));
    StorePackedGroup<kOut>(out_tile, out);
    in += kIn * hn::MaxLanes(LaneTag());
    out += kOut * hn::MaxLanes(LaneTag());
  }
}

// Packed rows of one input to packed rows of one output that is not in place, group by group: the
// transpositions of one group overlap with the kernel of the next. A tail is done with the items
// before it, once more. False, doing nothing, where this does not apply.
template <size_t kIn, size_t kOut, class Kernel>
bool ForEachPacked(size_t count, const Kernel& kernel, const simd::InView& in,
                   const simd::OutView& out) {
  const size_t lanes = hn::MaxLanes(LaneTag());
  if (count < lanes || !IsPacked(in, kIn) || !IsPacked(out, kOut) || WorthStreaming(count, kOut)) {
    return false;
  }
  const auto run = [&](size_t first, size_t groups) {
    RunPacked<kIn, kOut>(kernel, groups, reinterpret_cast<const float*>(in.data) + first * kIn,
                         reinterpret_cast<float*>(out.data) + first * kOut);
  };
  run(0, count / lanes);
  if (count % lanes != 0) run(count - lanes, 1);
  return true;
}

#else

template <size_t, size_t, class Kernel>
bool ForEachPacked(size_t, const Kernel&, const simd::InView&, const simd::OutView&) {
  return false;
}

#endif

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_BATCH_INL_H_
