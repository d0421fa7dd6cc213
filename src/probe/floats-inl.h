// SPDX-License-Identifier: MIT
// Formats of coefficients as they are: blending and encoding.
#if defined(GAUNT_PROBE_FLOATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_FLOATS_INL_H_
#undef GAUNT_PROBE_FLOATS_INL_H_
#else
#define GAUNT_PROBE_FLOATS_INL_H_
#endif

#include "probe/means-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

template <class F>
struct Floats {
  static constexpr size_t kSums = kPlanes<F>;

  template <bool kNew, class K, class Taps, class Sums>
  static GAUNT_LANES void AddTaps(const K& k, const Taps& taps, size_t size, Sums& sums) {
    typename K::template Slots<Taps::kMost> weights;
    for (size_t t = 0; t < taps.count; ++t) weights(t, Mul(taps.Weight(t), k(kInWeight)));
    AddFrom<kNew, 0>(k, taps, weights, size, sums);
  }
  template <class K, class Sums, class Out>
  static GAUNT_LANES void Finish(const K& k, const Sums& sums, size_t size, const Out& out) {
    for (size_t c = 0; c < kChannels; ++c) {
      for (size_t i = 0; i < size; ++i) {
        out(c * size + i, Mul(k(kPerTiny / kInWeight), sums(c * kSize + i)));
      }
    }
  }

  // What is not finite in the format is cut off; NaN becomes 0.
  template <class K, class In, class Record, class V = typename K::V>
  static GAUNT_LANES V Encode(const K& k, const In& in, Record& record) {
    V clamped = k(0.0);
    EncodeFrom<0>(k, in, record, clamped);
    return clamped;
  }

 private:
  static constexpr double kLargest = F::kBits == 16 ? SmallFloat<10>::kLargest : 0x1.fffffep127;

  static constexpr size_t kSize = NumCoefficients(F::kOrder);
  // Half floats are read tiny. What makes them what they are goes into the weights, once for all, as
  // far as these may be large.
  static constexpr double kPerTiny = F::kBits == 16 ? HWY_NAMESPACE::kPerTiny : 1.0;
  static constexpr double kInWeight = F::kBits == 16 ? 0x1p92 : 1.0;

  static constexpr int BitOf(size_t p) { return F::kBits * static_cast<int>(p); }
  template <int kBit, class K, class Record>
  static GAUNT_LANES auto Number(const K& k, const Record& record) {
    if constexpr (F::kBits == 16) {
      return record.template TinyHalf<kBit>(k);
    } else {
      return record.template Float<kBit>(k);
    }
  }

  // Four numbers at a time, which wait for each other less than one.
  template <bool kNew, size_t p, class K, class Taps, class Weights, class Sums>
  static GAUNT_LANES void AddFrom(const K& k, const Taps& taps, const Weights& weights, size_t size,
                                  Sums& sums) {
    if constexpr (p < kPlanes<F>) {
      using V = typename K::V;
      constexpr size_t left = kPlanes<F> - p;
      constexpr size_t kFirst =
          (p + (left > 3 ? 3 : left - 1)) / kSize == p / kSize ? p % kSize : 0;
      if (kFirst < size) {
        V s0 = k(0.0), s1 = s0, s2 = s0, s3 = s0;
        if constexpr (!kNew) s0 = sums(p);
        if constexpr (!kNew && left > 1) s1 = sums(p + 1);
        if constexpr (!kNew && left > 2) s2 = sums(p + 2);
        if constexpr (!kNew && left > 3) s3 = sums(p + 3);
        for (size_t t = 0; t < taps.count; ++t) {
          const V weight = weights(t);
          const auto record = taps.Record(t);
          s0 = MulAdd(weight, Number<BitOf(p)>(k, record), s0);
          if constexpr (left > 1) s1 = MulAdd(weight, Number<BitOf(p + 1)>(k, record), s1);
          if constexpr (left > 2) s2 = MulAdd(weight, Number<BitOf(p + 2)>(k, record), s2);
          if constexpr (left > 3) s3 = MulAdd(weight, Number<BitOf(p + 3)>(k, record), s3);
        }
        sums(p, s0);
        if constexpr (left > 1) sums(p + 1, s1);
        if constexpr (left > 2) sums(p + 2, s2);
        if constexpr (left > 3) sums(p + 3, s3);
      }
      AddFrom<kNew, p + (left > 3 ? 4 : left)>(k, taps, weights, size, sums);
    }
  }

  template <size_t p, class K, class In, class Record, class V>
  static GAUNT_LANES void EncodeFrom(const K& k, const In& in, Record& record, V& clamped) {
    if constexpr (p < kPlanes<F>) {
      const V wanted = NumberOrZero(k, in(p));
      clamped = Add(clamped, IfThenElseZero(Gt(Abs(wanted), k(kLargest)), k(1.0)));
      const V v = Min(Max(wanted, k(-kLargest)), k(kLargest));
      if constexpr (F::kBits == 16) {
        record.template Put<BitOf(p), 16>(k.HalfBits(v));
      } else {
        record.template Put<BitOf(p), 32>(v);
      }
      EncodeFrom<p + 1>(k, in, record, clamped);
    }
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_FLOATS_INL_H_
