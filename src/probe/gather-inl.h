// SPDX-License-Identifier: MIT
// The gather driver: decodes and blends packed records. Objects go by groups of 8 in two phases,
// first every tap's weighted means in lanes over objects, then the ratios of each tap in lanes over
// the ratios, so that the misses of many taps overlap. Rows of ratios become planes once per tile.
#if defined(GAUNT_PROBE_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_GATHER_INL_H_
#undef GAUNT_PROBE_GATHER_INL_H_
#else
#define GAUNT_PROBE_GATHER_INL_H_
#endif

#include <algorithm>
#include <cstring>

#include "probe/probe-inl.h"
#include "probe/probe.h"
#include "simd/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

inline constexpr size_t kGroup = 8;          // objects
inline constexpr size_t kTapChunk = 8;       // taps held at a time
inline constexpr size_t kTile = 4 * kGroup;  // objects
inline constexpr size_t kRow = Sh3::kChannels * Sh3::kRatios;

// What stands in for a record that contributes nothing.
inline constexpr uint8_t kNoRecord[Sh3::kBytes] = {};

// Where taps come from: record and weight of tap t of item i.
struct EachRecord {
  PackedProbes packed;
  GAUNT_LANES const uint8_t* operator()(size_t i, size_t, float& weight) const {
    weight = 1.0f;
    return packed.data + i * packed.stride;
  }
};
struct TapRecord {
  Taps taps;
  PackedProbes packed;
  GAUNT_LANES const uint8_t* operator()(size_t i, size_t t, float& weight) const {
    const size_t tap = i * taps.count + t;
    const size_t index = taps.indices[tap];
    const bool valid = index < packed.count;
    weight = valid ? taps.weights[tap] : 0.0f;
    return valid ? packed.data + index * packed.stride : kNoRecord;
  }
};

// Taps of a group of objects, and what phase one makes of them: [tap][object].
struct GroupTaps {
  const uint8_t* records[kTapChunk][kGroup];
  HWY_ALIGN uint32_t words[kTapChunk][kGroup];
  HWY_ALIGN float weights[kTapChunk][kGroup];
  HWY_ALIGN float means[kTapChunk][Sh3::kChannels][kGroup];
};

// Phase two for one object; kTaps 0 stands for a number known at run time.
template <size_t kTaps>
GAUNT_LANES void SumRatios(const GroupTaps& group, size_t object, size_t taps, bool first,
                           float* row) {
  const RecordLanes k;
  using V = RecordLanes::V;
  for (size_t i = 0; i < Sh3::kRatios; i += hn::Lanes(RecordLanes::D())) {
    V r = k.Zero(), g = k.Zero(), b = k.Zero();
    if (!first) {
      r = k.Load(row + i);
      g = k.Load(row + Sh3::kRatios + i);
      b = k.Load(row + 2 * Sh3::kRatios + i);
    }
    for (size_t t = 0; t < (kTaps == 0 ? taps : kTaps); ++t) {
      const auto& means = group.means[t];
      AddRatios(k, group.records[t][object] + Sh3::kRatiosOffset + i, k.Splat(means[0][object]),
                k.Splat(means[1][object]), k.Splat(means[2][object]), r, g, b);
    }
    k.Store(r, row + i);
    k.Store(g, row + Sh3::kRatios + i);
    k.Store(b, row + 2 * Sh3::kRatios + i);
  }
}

template <size_t kTaps>
HWY_NOINLINE void SumGroup(const GroupTaps& group, size_t taps, bool first, float* rows) {
  for (size_t object = 0; object < kGroup; ++object) {
    SumRatios<kTaps>(group, object, taps, first, rows + object * kRow);
  }
}

// Phase one for a group: weighted means of each tap, and their sum.
inline HWY_NOINLINE void SumMeans(GroupTaps& group, size_t taps, bool first,
                                  float* const means[3]) {
  const RecordLanes k;
  using V = RecordLanes::V;
  for (size_t o = 0; o < kGroup; o += hn::Lanes(RecordLanes::D())) {
    V sum_r = k.Zero(), sum_g = k.Zero(), sum_b = k.Zero();
    if (!first) {
      sum_r = k.Load(means[0] + o);
      sum_g = k.Load(means[1] + o);
      sum_b = k.Load(means[2] + o);
    }
    for (size_t t = 0; t < taps; ++t) {
      V r, g, b;
      WeightedMeans(k, k.LoadWord(group.words[t] + o), k.Load(group.weights[t] + o), r, g, b);
      k.Store(r, group.means[t][0] + o);
      k.Store(g, group.means[t][1] + o);
      k.Store(b, group.means[t][2] + o);
      sum_r = Add(sum_r, r);
      sum_g = Add(sum_g, g);
      sum_b = Add(sum_b, b);
    }
    k.Store(sum_r, means[0] + o);
    k.Store(sum_g, means[1] + o);
    k.Store(sum_b, means[2] + o);
  }
}

template <class Source>
HWY_NOINLINE void FetchTaps(const Source& source, size_t first_item, size_t items, size_t first_tap,
                            size_t taps, GroupTaps& group) {
  for (size_t o = 0; o < kGroup; ++o) {
    for (size_t t = 0; t < taps; ++t) {
      float weight = 0.0f;
      const uint8_t* record = o < items ? source(first_item + o, first_tap + t, weight) : kNoRecord;
      group.records[t][o] = record;
      group.weights[t][o] = weight;
      std::memcpy(&group.words[t][o], record, sizeof(uint32_t));
    }
  }
}

#if !HWY_HAVE_SCALABLE && HWY_TARGET != HWY_SCALAR

// Rows of 8 floats per object to [tap][object].
GAUNT_LANES void TransposeTaps(const float* rows, float* out) {
  using D = RecordLanes::D;
  constexpr size_t kLanes = hn::MaxLanes(D());
  constexpr ptrdiff_t kRowBytes = kTapChunk * sizeof(float);
  for (size_t o = 0; o < kGroup; o += kLanes) {
    for (size_t t = 0; t < kTapChunk; t += 4) {
      LoadBlock<4>(D(), reinterpret_cast<const unsigned char*>(rows + o * kTapChunk + t), kRowBytes,
                   out + t * kGroup + o, kGroup);
    }
  }
}

// The usual case, eight taps of eight objects that all have records. False if one does not.
HWY_NOINLINE bool FetchEightTaps(const TapRecord& source, size_t first_item, GroupTaps& group) {
  const uint32_t* const indices = source.taps.indices + first_item * kTapChunk;
  uint32_t largest = 0;
  for (size_t k = 0; k < kGroup * kTapChunk; ++k) largest = HWY_MAX(largest, indices[k]);
  if (largest >= source.packed.count) return false;
  HWY_ALIGN float words[kGroup * kTapChunk];
  for (size_t o = 0; o < kGroup; ++o) {
    for (size_t t = 0; t < kTapChunk; ++t) {
      const uint8_t* record =
          source.packed.data + size_t{indices[o * kTapChunk + t]} * source.packed.stride;
      group.records[t][o] = record;
      std::memcpy(words + o * kTapChunk + t, record, sizeof(float));
    }
  }
  TransposeTaps(words, reinterpret_cast<float*>(group.words[0]));
  TransposeTaps(source.taps.weights + first_item * kTapChunk, group.weights[0]);
  return true;
}
GAUNT_LANES bool FetchEightTaps(const EachRecord&, size_t, GroupTaps&) { return false; }

// What FinishGather<3> does, of a group whose output is in place: straight from the rows.
inline HWY_NOINLINE void WriteGroup(const float* rows, const float* const means[3],
                                    unsigned char* out, ptrdiff_t plane_stride) {
  using D = RecordLanes::D;
  const D d;
  constexpr ptrdiff_t kRowBytes = kRow * sizeof(float);
  for (size_t o = 0; o < kGroup; o += hn::MaxLanes(D())) {
    const auto plane = [=](size_t p) HWY_ATTR {
      return reinterpret_cast<float*>(out + static_cast<ptrdiff_t>(p) * plane_stride) + o;
    };
    for (size_t c = 0; c < Sh3::kChannels; ++c) {
      hn::StoreU(hn::Load(d, means[c] + o), d, plane(9 * c));
      for (size_t i = 0; i < Sh3::kRatios; i += 4) {
        const auto* row =
            reinterpret_cast<const unsigned char*>(rows + o * kRow + c * Sh3::kRatios + i);
        const float* factors = kSh3Factors.decode + i;
        auto a = LoadBlocks<4>(d, row, kRowBytes);
        auto b = LoadBlocks<4>(d, row + kRowBytes, kRowBytes);
        auto e = LoadBlocks<4>(d, row + 2 * kRowBytes, kRowBytes);
        auto f = LoadBlocks<4>(d, row + 3 * kRowBytes, kRowBytes);
        Transpose4(d, a, b, e, f);
        hn::StoreU(Mul(hn::Set(d, factors[0]), a), d, plane(9 * c + i + 1));
        hn::StoreU(Mul(hn::Set(d, factors[1]), b), d, plane(9 * c + i + 2));
        hn::StoreU(Mul(hn::Set(d, factors[2]), e), d, plane(9 * c + i + 3));
        hn::StoreU(Mul(hn::Set(d, factors[3]), f), d, plane(9 * c + i + 4));
      }
    }
  }
}

#else

template <class Source>
bool FetchEightTaps(const Source&, size_t, GroupTaps&) {
  return false;
}
inline void WriteGroup(const float*, const float* const*, unsigned char*, ptrdiff_t) {}

#endif

// Rows of ratios and planes of means of up to kGroup objects from first_item.
template <class Source>
GAUNT_LANES void GatherGroup(const Source& source, size_t first_item, size_t items, size_t taps,
                             float* rows, float* const means[3]) {
  for (size_t t = 0; t < taps; t += kTapChunk) {
    const size_t chunk = std::min(kTapChunk, taps - t);
    GroupTaps group;
    if (taps != kTapChunk || items != kGroup || !FetchEightTaps(source, first_item, group)) {
      FetchTaps(source, first_item, items, t, chunk, group);
    }
    SumMeans(group, chunk, t == 0, means);
    switch (chunk) {
      case 1: SumGroup<1>(group, 1, t == 0, rows); break;
      case 4: SumGroup<4>(group, 4, t == 0, rows); break;
      case 8: SumGroup<8>(group, 8, t == 0, rows); break;
      default: SumGroup<0>(group, chunk, t == 0, rows); break;
    }
  }
}

// out of item i = sum over its taps of weight times decoded record, bands below n only.
template <int n, class Source>
void GatherRecords(size_t count, size_t taps, const Source& source, const simd::OutView& out) {
  HWY_ALIGN float rows[kTile * kRow];
  HWY_ALIGN float means[Sh3::kChannels * kTile];
  constexpr size_t kPlanes = Sh3::kChannels * NumCoefficients(n);
  constexpr bool kTransposes = !HWY_HAVE_SCALABLE && HWY_TARGET != HWY_SCALAR;
  size_t done = 0;
  if (kTransposes && n == 3 && out.item_stride == sizeof(float) && out.tile_items % kGroup == 0) {
    float* const group_means[3] = {means, means + kGroup, means + 2 * kGroup};
    for (; done + kGroup <= count; done += kGroup) {
      GatherGroup(source, done, kGroup, taps, rows, group_means);
      WriteGroup(rows, group_means, out.Item(done), out.plane_stride);
    }
  }
  for (; done < count; done += kTile) {
    const size_t tile = std::min(kTile, count - done);
    for (size_t o = 0; o < tile; o += kGroup) {
      float* const group_means[3] = {means + o, means + kTile + o, means + 2 * kTile + o};
      GatherGroup(source, done + o, std::min(kGroup, tile - o), taps, rows + o * kRow, group_means);
    }
    ForEachBatch(tile, FinishGather<n>(), In<kRow>(simd::InterleavedIn(rows, kRow)),
                 In<Sh3::kChannels>(simd::PlanarIn(means, kTile)),
                 Out<kPlanes>(out, kPlanes, done));
  }
}

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_GATHER_INL_H_
