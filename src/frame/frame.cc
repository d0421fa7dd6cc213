// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include <algorithm>

#include "light/constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/frame.cc"
#include <hwy/foreach_target.h>

#include "frame/frame-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::frame::HWY_NAMESPACE {

// Objects that go through all steps together: what they take stays in the first cache.
constexpr size_t kItems = 64;
static_assert(kItems % kTileItems == 0, "");

template <size_t kCount>
struct Tiles {
  HWY_ALIGN float tile[kCount * kItems];
};

simd::OutView TileView(float* tile, size_t planes) {
  return {reinterpret_cast<unsigned char*>(tile), sizeof(float), kTileStride,
          static_cast<ptrdiff_t>(planes) * kTileStride, kTileItems};
}

simd::InView Reading(const simd::OutView& view) {
  return {view.data, view.item_stride, view.plane_stride, view.tile_stride, view.tile_items};
}

// The blended probes of each object, as an input.
class GatherSide : private Tiles<kPlanes> {
 public:
  explicit GatherSide(const Job& job) : job_(job) {
    std::fill(tile, tile + kPlanes * kItems, 0.0f);
  }
  bool direct() const { return false; }
  size_t items() const { return kItems; }
  void Expect(size_t) {}
  void End(size_t, size_t) {}
  void Finish() {}

  HWY_NOINLINE InCursor Begin(size_t first, size_t n) {
    probe::Taps taps = job_.taps;
    taps.indices += first * taps.count;
    taps.weights += first * taps.count;
    taps.items -= first;
    if (job_.order == kOrder) {
      job_.gather(kOrder, n, taps, job_.packed, TileView(tile, kPlanes));
    } else {
      GatherFew(n, taps);
    }
    return InCursor::Tiles(tile, kPlanes);
  }

 private:
  // Fewer coefficients, each of which goes to its place; those that are missing stay 0.
  HWY_NOINLINE void GatherFew(size_t n, const probe::Taps& taps) {
    constexpr size_t kFew = probe::kChannels * (kOrder - 1) * (kOrder - 1);
    Tiles<kFew> few;
    const size_t size = job_.order * job_.order, planes = probe::kChannels * size;
    job_.gather(job_.order, n, taps, job_.packed, TileView(few.tile, planes));
    for (size_t i = 0; i < n; i += kTileItems) {
      const float* const from = InTiles(few.tile, planes, i);
      float* const to = InTiles(tile, kPlanes, i);
      for (size_t c = 0; c < probe::kChannels; ++c) {
        std::copy(from + c * size * kTileItems, from + (c + 1) * size * kTileItems,
                  to + c * kOrder * kOrder * kTileItems);
      }
    }
  }

  const Job& job_;
};
GatherSide& AsSide(GatherSide& side) { return side; }

// A side of kPlanes planes that may be absent: then nobody uses what it stands for.
template <class Side, class Cursor, class View, size_t kSidePlanes>
class Optional : private Tiles<kSidePlanes>, public Side {
 public:
  explicit Optional(const View* view)
      : Side(view != nullptr ? *view : View{nullptr, sizeof(float), kTileStride, 0, kTileItems},
             kSidePlanes, 0, Place::kAnywhere, this->tile, kItems),
        present_(view != nullptr) {}
  bool direct() const { return !present_ || Side::direct(); }
  void Expect(size_t count) {
    if (present_) Side::Expect(count);
  }
  Cursor Begin(size_t first, size_t n) {
    return present_ ? Side::Begin(first, n) : Cursor::Still(this->tile);
  }
  void End(size_t first, size_t n) {
    if (present_) Side::End(first, n);
  }
  void Finish() {
    if (present_) Side::Finish();
  }

 private:
  bool present_;
};
template <class Side, class Cursor, class View, size_t kSidePlanes>
Optional<Side, Cursor, View, kSidePlanes>& AsSide(Optional<Side, Cursor, View, kSidePlanes>& side) {
  return side;
}
template <size_t kSidePlanes>
using OptionalIn = Optional<InSide, InCursor, simd::InView, kSidePlanes>;
template <size_t kSidePlanes>
using OptionalOut = Optional<OutSide, OutCursor, simd::OutView, kSidePlanes>;

// Directions, colours and ambient lights, in tiles. Fields that follow each other in one record are
// stored as one row.
class LightSide : private Tiles<kLightPlanes> {
 public:
  explicit LightSide(const Job& job) {
    const simd::OutView* const fields[] = {job.directions, job.colours, job.ambient};
    if (Adjacent(job.directions, job.colours) && Adjacent(job.colours, job.ambient)) {
      Add(*job.directions, 0, kLightPlanes);
      return;
    }
    for (size_t f = 0; f < 3; ++f) {
      if (fields[f] != nullptr) Add(*fields[f], 3 * f, 3);
    }
  }
  bool direct() const { return false; }
  size_t items() const { return kItems; }
  void Expect(size_t) {}
  OutCursor Begin(size_t, size_t) { return OutCursor::Tiles(tile, kLightPlanes); }
  HWY_NOINLINE void End(size_t first, size_t n) {
    for (size_t i = 0; i < n; i += kTileItems) {
      const float* const from = InTiles(tile, kLightPlanes, i);
      for (size_t f = 0; f < used_; ++f) {
        StoreTiles(from + fields_[f].plane * kTileItems, fields_[f].view, fields_[f].shape,
                   first + i, std::min(kTileItems, n - i), fields_[f].planes);
      }
    }
  }
  void Finish() {}

 private:
  struct Field {
    simd::OutView view;
    RowShape shape;
    size_t plane, planes;
  };

  static bool Adjacent(const simd::OutView* a, const simd::OutView* b) {
    return a != nullptr && b != nullptr && a->FromPlane(3).data == b->data &&
           a->item_stride == b->item_stride && a->plane_stride == b->plane_stride &&
           a->tile_stride == b->tile_stride && a->tile_items == b->tile_items;
  }
  void Add(const simd::OutView& view, size_t plane, size_t planes) {
    fields_[used_++] = {view, ShapeOf(view, planes), plane, planes};
  }

  Field fields_[3];
  size_t used_ = 0;
};
LightSide& AsSide(LightSide& side) { return side; }

void LightBatch(size_t count, const Job& job) {
  Light kernel = {};
  kernel.lerps = job.history != nullptr;
  kernel.rotates = job.quaternions != nullptr;
  kernel.keeps_radiance = job.radiance != nullptr;
  kernel.extracts = job.colours != nullptr || job.ambient != nullptr;
  kernel.finds_direction = kernel.extracts || job.directions != nullptr;
  kernel.packs = job.constants != nullptr;
  std::copy(light::kLuminance, light::kLuminance + probe::kChannels, kernel.weights);
  simd::InView before = {};
  if (kernel.lerps) before = Reading(*job.history);
  ForEachBatch(count, kernel, GatherSide(job),
               OptionalIn<kPlanes>(kernel.lerps ? &before : nullptr), OptionalIn<1>(job.alpha),
               OptionalIn<4>(job.quaternions), OptionalOut<kPlanes>(job.history),
               OptionalOut<kPlanes>(job.radiance), LightSide(job),
               OptionalOut<kConstantPlanes>(job.constants));
}

const Table* GetTable() {
  static constexpr Table kTable = {&LightBatch};
  return &kTable;
}

}  // namespace gaunt::frame::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(frame);
