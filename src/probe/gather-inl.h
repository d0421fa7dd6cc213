// SPDX-License-Identifier: MIT
// The gather driver: blends packed records, one item per lane. The taps of a group of items become
// words in lanes, some taps at a time, so that the misses of many records overlap.
#if defined(GAUNT_PROBE_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_GATHER_INL_H_
#undef GAUNT_PROBE_GATHER_INL_H_
#else
#define GAUNT_PROBE_GATHER_INL_H_
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>

#include "probe/probe.h"
#include "probe/record-inl.h"
#include "simd/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// What stands in for a record that contributes nothing.
inline constexpr uint8_t kNoRecord[128] = {};

// Words of one record of each lane; records(lane) is where it is.
#if GAUNT_TRANSPOSES

// Four words of a record, of which nothing beyond it is read.
template <size_t kBytes>
GAUNT_LANES hn::Vec<hn::CappedTag<float, 4>> LoadFour(const uint8_t* record, size_t offset) {
  const hn::CappedTag<float, 4> d;
  const auto* from = reinterpret_cast<const float*>(record + offset);
  if constexpr (kBytes >= 16) {
    return hn::LoadU(d, from);
  } else {
    const hn::CappedTag<float, 2> pair;
    const auto* last = reinterpret_cast<const float*>(record + kBytes - 8);
    return hn::Combine(d, hn::LoadU(pair, last), hn::LoadU(pair, from));
  }
}

// The same of records lane, lane + 4 .., each in its block of 128 bits.
template <size_t kBytes, class D, class Records>
GAUNT_LANES hn::Vec<D> LoadBlocksOf(D d, const Records& records, size_t lane, size_t offset) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    return LoadFour<kBytes>(records(lane), offset);
  } else if constexpr (hn::MaxLanes(D()) == 16 && kBytes >= 16) {
    // Blends of what is loaded into all blocks are cheaper than insertions.
    const auto load = [&](size_t from) HWY_ATTR {
      return hn::LoadDup128(d, reinterpret_cast<const float*>(records(from) + offset));
    };
    return hn::ConcatUpperLower(d, hn::OddEvenBlocks(load(lane + 12), load(lane + 8)),
                                hn::OddEvenBlocks(load(lane + 4), load(lane)));
  } else {
    const hn::Half<D> half;
    constexpr size_t kHalf = hn::MaxLanes(D()) / 2;
    return hn::Combine(d, LoadBlocksOf<kBytes>(half, records, lane + kHalf, offset),
                       LoadBlocksOf<kBytes>(half, records, lane, offset));
  }
}

// Four words of a group, transposed.
template <class V>
GAUNT_LANES void StoreWords(V a, V b, V c, V e, float* to) {
  constexpr size_t kStride = hn::MaxLanes(LaneTag());
  const LaneTag d;
  Transpose4(d, a, b, c, e);
  hn::Store(a, d, to);
  hn::Store(b, d, to + kStride);
  hn::Store(c, d, to + 2 * kStride);
  hn::Store(e, d, to + 3 * kStride);
}

template <size_t kBytes, class Records>
GAUNT_LANES void LoadWords(const Records& records, float* words) {
  using Words = LoadedWords<kBytes>;
  constexpr size_t kStride = hn::MaxLanes(LaneTag());
  const LaneTag d;
  if constexpr (kBytes == 4) {
    for (size_t lane = 0; lane < kStride; ++lane) std::memcpy(words + lane, records(lane), 4);
  } else {
    for (int word = 0; word < Words::kCount; word += 8) {
      // Two blocks of words at a time, of records that are found once.
      const int other = word + 4 < Words::kCount ? word + 4 : word;
      const size_t o = Words::Offset(word), p = Words::Offset(other);
      auto a = LoadBlocksOf<kBytes>(d, records, 0, o), f = LoadBlocksOf<kBytes>(d, records, 0, p);
      auto b = LoadBlocksOf<kBytes>(d, records, 1, o), g = LoadBlocksOf<kBytes>(d, records, 1, p);
      auto c = LoadBlocksOf<kBytes>(d, records, 2, o), h = LoadBlocksOf<kBytes>(d, records, 2, p);
      auto e = LoadBlocksOf<kBytes>(d, records, 3, o), i = LoadBlocksOf<kBytes>(d, records, 3, p);
      StoreWords(a, b, c, e, words + static_cast<size_t>(word) * kStride);
      if (other != word) StoreWords(f, g, h, i, words + static_cast<size_t>(other) * kStride);
    }
  }
}

#else

template <size_t kBytes, class Records>
GAUNT_LANES void LoadWords(const Records& records, float* words) {
  using Words = LoadedWords<kBytes>;
  constexpr size_t kStride = hn::MaxLanes(LaneTag());
  for (size_t lane = 0; lane < hn::Lanes(LaneTag()); ++lane) {
    for (int word = 0; word < Words::kCount; ++word) {
      std::memcpy(words + static_cast<size_t>(word) * kStride + lane,
                  records(lane) + Words::Offset(word), 4);
    }
  }
}

#endif

// Records of volumes from this size up are fetched before they are needed, by so many. Measured: from
// a last-level cache or memory that takes 3 to 10 % of the time off, elsewhere it costs up to as much.
inline constexpr size_t kLargeVolume = size_t{4} << 20;
inline constexpr size_t kRecordsAhead = 256;

// Items that their records are fetched ahead by; 0: none are.
inline size_t ItemsAhead(const Taps& taps, const PackedProbes& packed) {
  const size_t lanes = hn::Lanes(LaneTag());
  if (packed.count < kLargeVolume / packed.stride) return 0;
  return kRecordsAhead / taps.count / lanes * lanes;
}

// Where taps come from: record and weight of tap t of item i. FetchAhead() is called once for each
// group of items.
struct EachRecord {
  static constexpr bool kOneTap = true;
  PackedProbes packed;
  GAUNT_LANES void FetchAhead(size_t, size_t) const {}
  GAUNT_LANES const uint8_t* operator()(size_t i, size_t, float& weight) const {
    weight = 1.0f;
    return packed.data + i * packed.stride;
  }
};
struct TapRecord {
  static constexpr bool kOneTap = false;
  Taps taps;
  PackedProbes packed;
  size_t ahead;
  GAUNT_LANES void FetchAhead(size_t item, size_t bytes) const {
    if (ahead != 0) FetchGroup(item + ahead, bytes);
  }
  GAUNT_LANES const uint8_t* operator()(size_t i, size_t t, float& weight) const {
    const size_t tap = i * taps.count + t;
    const size_t index = taps.indices[tap];
    const bool valid = index < packed.count;
    weight = valid ? taps.weights[tap] : 0.0f;
    return valid ? packed.data + index * packed.stride : kNoRecord;
  }

 private:
  HWY_NOINLINE void FetchGroup(size_t first, size_t bytes) const {
    const size_t end = std::min(first + hn::Lanes(LaneTag()), taps.items) * taps.count;
    for (size_t tap = first * taps.count; tap < end; ++tap) {
      const size_t index = taps.indices[tap];
      if (index >= packed.count) continue;
      const uint8_t* const record = packed.data + index * packed.stride;
      hwy::Prefetch(record);
      hwy::Prefetch(record + bytes - 1);
    }
  }
};

// Some taps of a group of items, as the formats read them.
template <size_t kBytes>
class GroupTaps {
 public:
  using Words = LoadedWords<kBytes>;
  static constexpr size_t kStride = hn::MaxLanes(LaneTag());
  // At a time: as many as take some kilobytes.
  static constexpr size_t kMost = Words::kCount <= 8 ? 8 : 4;

  size_t count;

  GAUNT_LANES auto Record(size_t tap) const {
    const PlanesIn planes = {
        reinterpret_cast<const unsigned char*>(words_ + tap * Words::kCount * kStride),
        kStride * sizeof(float)};
    return RecordIn<Words, PlanesIn>{planes};
  }
  GAUNT_LANES hn::Vec<LaneTag> Weight(size_t tap) const {
    return hn::Load(LaneTag(), weights_ + tap * kStride);
  }

  // Taps first_tap .. first_tap + count of up to as many items as there are lanes.
  template <class Source>
  GAUNT_LANES void Fetch(const Source& source, size_t item, size_t items, size_t first_tap) {
    const bool whole = items >= hn::Lanes(LaneTag());
    if (whole && FetchValid(source, item, first_tap)) return;
    FetchAny(source, item, items, first_tap);
  }

 private:
  template <class Source>
  HWY_NOINLINE void FetchAny(const Source& source, size_t item, size_t items, size_t first_tap) {
    const uint8_t* records[kMost][kStride];
    for (size_t lane = 0; lane < hn::Lanes(LaneTag()); ++lane) {
      const size_t at = item + std::min(lane, items - 1);
      for (size_t t = 0; t < count; ++t) {
        records[t][lane] = source(at, first_tap + t, weights_[t * kStride + lane]);
      }
    }
    for (size_t t = 0; t < count; ++t) {
      LoadWords<kBytes>([&](size_t lane) { return records[t][lane]; },
                        words_ + t * Words::kCount * kStride);
    }
  }

  // The usual case, whole groups of items all of whose records exist. False if one does not.
  HWY_NOINLINE bool FetchValid(const TapRecord& source, size_t item, size_t first_tap) {
#if GAUNT_TRANSPOSES
    if (count == kMost) {
      const size_t taps = source.taps.count;
      const uint32_t* const indices = source.taps.indices + item * taps + first_tap;
      const float* const weights = source.taps.weights + item * taps + first_tap;
      uint32_t largest = 0;
      for (size_t lane = 0; lane < kStride; ++lane) {
        for (size_t t = 0; t < kMost; ++t) largest = std::max(largest, indices[lane * taps + t]);
      }
      // Signed, because some compilers take detours to widen integers that are not.
      constexpr size_t kMostSigned = size_t{1} << 31;
      if (largest >= std::min(source.packed.count, kMostSigned)) return false;
      const auto index = [=](size_t lane, size_t t) {
        return static_cast<ptrdiff_t>(static_cast<int32_t>(indices[lane * taps + t]));
      };
      for (size_t t = 0; t < kMost; t += 4) {
        LoadBlock<4>(LaneTag(), reinterpret_cast<const unsigned char*>(weights + t),
                     static_cast<ptrdiff_t>(taps * sizeof(float)), weights_ + t * kStride, kStride);
      }
      const uint8_t* const data = source.packed.data;
      const auto stride = static_cast<ptrdiff_t>(source.packed.stride);
      for (size_t t = 0; t < kMost; ++t) {
        LoadWords<kBytes>([=](size_t lane) { return data + index(lane, t) * stride; },
                          words_ + t * Words::kCount * kStride);
      }
      return true;
    }
#endif
    (void)source, (void)item, (void)first_tap;
    return false;
  }
  HWY_NOINLINE bool FetchValid(const EachRecord& source, size_t item, size_t) {
    hn::Store(hn::Set(LaneTag(), 1.0f), LaneTag(), weights_);
    const uint8_t* const data = source.packed.data + item * source.packed.stride;
    const size_t stride = source.packed.stride;
    if (kBytes == sizeof(float) && stride == kBytes) {  // words already
      hn::Store(hn::LoadU(LaneTag(), reinterpret_cast<const float*>(data)), LaneTag(), words_);
    } else {
      LoadWords<kBytes>([=](size_t lane) { return data + lane * stride; }, words_);
    }
    return true;
  }

  HWY_ALIGN float weights_[kMost * kStride];
  HWY_ALIGN float words_[kMost * Words::kCount * kStride];
};

// The items of a group of lanes, as an input of kernels.
template <class Source>
struct ItemCursor {
  const Source* source;
  size_t item, end;

  GAUNT_LANES const ItemCursor& Here() const { return *this; }
  GAUNT_LANES void Next() { item += hn::Lanes(LaneTag()); }
};

template <class Source>
class ItemSide {
 public:
  explicit ItemSide(const Source& source) : source_(source) {}
  bool direct() const { return true; }
  size_t items() const { return SIZE_MAX; }
  ItemCursor<Source> Begin(size_t first, size_t n) const { return {&source_, first, first + n}; }
  void Expect(size_t) {}
  void End(size_t, size_t) {}
  void Finish() {}

 private:
  Source source_;
};
template <class Source>
ItemSide<Source>& AsSide(ItemSide<Source>& side) {
  return side;
}

// The first `size` coefficients of sums of weighted records.
template <class Format, class F>
struct Blend {
  static_assert(F::kBytes <= sizeof(kNoRecord), "no record has to be as long as any");

  size_t taps;
  size_t size;

  template <class K, class Source, class Out>
  GAUNT_LANES void operator()(const K& k, const ItemCursor<Source>& items, const Out& out) const {
    typename K::template Slots<Format::kSums> sums;
    GroupTaps<F::kBytes> group;
    items.source->FetchAhead(items.item, F::kBytes);
    const auto fetch = [&](size_t tap) HWY_ATTR {
      group.count = std::min(group.kMost, taps - tap);
      group.Fetch(*items.source, items.item, items.end - items.item, tap);
    };
    if constexpr (Source::kOneTap) {
      constexpr size_t kSize = NumCoefficients(F::kOrder);
      fetch(0);
      Format::template AddTaps<true>(k, group, kSize, sums);
      Format::Finish(k, sums, kSize, out);
    } else {
      for (size_t p = 0; p < Format::kSums; ++p) sums(p, k(0.0));
      for (size_t t = 0; t < taps; t += group.kMost) {
        fetch(t);
        Format::template AddTaps<false>(k, group, size, sums);
      }
      Format::Finish(k, sums, size, out);
    }
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_GATHER_INL_H_
