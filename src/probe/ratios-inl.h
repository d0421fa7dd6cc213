// SPDX-License-Identifier: MIT
// Formats of means and ratios: blending and encoding.
#if defined(GAUNT_PROBE_RATIOS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_RATIOS_INL_H_
#undef GAUNT_PROBE_RATIOS_INL_H_
#else
#define GAUNT_PROBE_RATIOS_INL_H_
#endif

#include <iterator>
#include <utility>

#include "probe/means-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// The number of a code, which is kScale v + kZero, and its bits. What is read is kRead times that.
template <Code kCode>
struct Coding;
template <>
struct Coding<Code::kSnorm8> {
  static constexpr double kScale = 127.0, kZero = 0.0, kRead = 0x1p24;
  static constexpr int kWidth = 8;
  template <int kBit, class K, class Record>
  static GAUNT_LANES auto Get(const K& k, const Record& record) {
    return record.template SignedByte<kBit>(k);
  }
  template <class K, class V = typename K::V>
  static GAUNT_LANES V Bits(const K& k, V v) {
    return k.template Integer<kWidth>(Round(k, v));
  }
};
// Read less 128, so that next to nothing cancels.
template <>
struct Coding<Code::kUnorm8> {
  static constexpr double kScale = 127.5, kZero = -0.5, kRead = 0x1p24;
  static constexpr int kWidth = 8;
  template <int kBit, class K, class Record>
  static GAUNT_LANES auto Get(const K& k, const Record& record) {
    return record.template ByteLess128<kBit>(k);
  }
  template <class K, class V = typename K::V>
  static GAUNT_LANES V Bits(const K& k, V v) {
    return k.template Integer<kWidth>(Round(k, Add(v, k(127.5))));
  }
};
template <>
struct Coding<Code::kHalf> {
  static constexpr double kScale = 0.5, kZero = 0.5, kRead = 1.0;
  static constexpr int kWidth = 16;
  template <int kBit, class K, class Record>
  static GAUNT_LANES auto Get(const K& k, const Record& record) {
    return Mul(record.template TinyHalf<kBit>(k), k(kPerTiny));
  }
  template <class K, class V = typename K::V>
  static GAUNT_LANES V Bits(const K& k, V v) {
    return k.HalfBits(Add(v, k(kZero)));
  }
};

template <class F>
struct Ratios {
  static constexpr size_t kSums = kPlanes<F>;
  static constexpr double kRead = Coding<F::CodeOf(0, 1)>::kRead;

  // To sums or, if they are new, in place of them, records of each lane times their weights: of the
  // first `size` coefficients at least. The bounds come in only in Finish(), once for all.
  template <bool kNew, class K, class Taps, class Sums>
  static GAUNT_LANES void AddTaps(const K& k, const Taps& taps, size_t size, Sums& sums) {
    using V = typename K::V;
    typename K::template Slots<kChannels * Taps::kMost> means;
    V sum_r = k(0.0), sum_g = sum_r, sum_b = sum_r;
    if constexpr (!kNew) sum_r = sums(0), sum_g = sums(kSize), sum_b = sums(2 * kSize);
    for (size_t t = 0; t < taps.count; ++t) {
      V r, g, b;
      TheMeans::Decode(k, taps.Record(t), taps.Weight(t), r, g, b);
      means(kChannels * t, r);
      means(kChannels * t + 1, g);
      means(kChannels * t + 2, b);
      sum_r = Add(sum_r, r);
      sum_g = Add(sum_g, g);
      sum_b = Add(sum_b, b);
    }
    sums(0, sum_r);
    sums(kSize, sum_g);
    sums(2 * kSize, sum_b);
    AddChannel<kNew, 0, 1>(k, taps, means, size, sums);
    AddChannel<kNew, 1, 1>(k, taps, means, size, sums);
    AddChannel<kNew, 2, 1>(k, taps, means, size, sums);
  }

  // Their first `size` coefficients.
  template <class K, class Sums, class Out>
  static GAUNT_LANES void Finish(const K& k, const Sums& sums, size_t size, const Out& out) {
    FinishChannel<0>(k, sums, size, out);
    FinishChannel<1>(k, sums, size, out);
    FinishChannel<2>(k, sums, size, out);
  }

  // Coefficients to a record. Gives how many of them the range cut off.
  template <class K, class In, class Record, class V = typename K::V>
  static GAUNT_LANES V Encode(const K& k, const In& in, Record& record) {
    V clamped = k(0.0);
    V r = Mean<0>(k, in, clamped), g = Mean<1>(k, in, clamped), b = Mean<2>(k, in, clamped);
    TheMeans::Encode(k, record, r, g, b);
    PutOpaque(k, record, std::make_index_sequence<std::size(F::kOpaqueBits)>());
    EncodeChannel<0, 1>(k, PerMean(k, r), in, record, clamped);
    EncodeChannel<1, 1>(k, PerMean(k, g), in, record, clamped);
    EncodeChannel<2, 1>(k, PerMean(k, b), in, record, clamped);
    return clamped;
  }

  // The number of a ratio.
  template <size_t c, size_t i, class K, class Record>
  static GAUNT_LANES auto Number(const K& k, const Record& record) {
    return Coding<F::CodeOf(c, i)>::template Get<F::BitOf(c, i)>(k, record);
  }

 private:
  using TheMeans = Means<F::kContainer, F::kContainerBit>;
  static constexpr size_t kSize = NumCoefficients(F::kOrder);

  // A half float of 1.
  template <class K, class Record, size_t... place>
  static GAUNT_LANES void PutOpaque(const K& k, Record& record, std::index_sequence<place...>) {
    if constexpr (F::kOpaqueBits[0] >= 0) {
      (record.template Put<F::kOpaqueBits[place], 16>(k.HalfBits(k(1.0))), ...);
    }
    (void)k, (void)record;
  }

  // How many ratios there are from i on, up to four.
  static constexpr size_t CountFrom(size_t i) {
    size_t n = 0;
    while (n < 4 && i + n < kSize && F::Has(i + n)) ++n;
    return n;
  }

  // Four ratios at a time: more would not stay in registers.
  template <bool kNew, size_t c, size_t i, class K, class Taps, class M, class Sums>
  static GAUNT_LANES void AddChannel(const K& k, const Taps& taps, const M& means, size_t size,
                                     Sums& sums) {
    if constexpr (i < kSize && F::Has(i)) {
      using V = typename K::V;
      constexpr size_t at = c * kSize, left = CountFrom(i);
      if (i >= size) return;
      V s0 = k(0.0), s1 = s0, s2 = s0, s3 = s0;
      if constexpr (!kNew) s0 = sums(at + i);
      if constexpr (!kNew && left > 1) s1 = sums(at + i + 1);
      if constexpr (!kNew && left > 2) s2 = sums(at + i + 2);
      if constexpr (!kNew && left > 3) s3 = sums(at + i + 3);
      for (size_t t = 0; t < taps.count; ++t) {
        const V mean = means(kChannels * t + c);
        const auto record = taps.Record(t);
        s0 = MulAdd(mean, Number<c, i>(k, record), s0);
        if constexpr (left > 1) s1 = MulAdd(mean, Number<c, i + 1>(k, record), s1);
        if constexpr (left > 2) s2 = MulAdd(mean, Number<c, i + 2>(k, record), s2);
        if constexpr (left > 3) s3 = MulAdd(mean, Number<c, i + 3>(k, record), s3);
      }
      sums(at + i, s0);
      if constexpr (left > 1) sums(at + i + 1, s1);
      if constexpr (left > 2) sums(at + i + 2, s2);
      if constexpr (left > 3) sums(at + i + 3, s3);
      AddChannel<kNew, c, i + left>(k, taps, means, size, sums);
    } else if constexpr (i < kSize) {
      AddChannel<kNew, c, i + 1>(k, taps, means, size, sums);
    }
  }

  template <size_t c, size_t i = 0, class K, class Sums, class Out>
  static GAUNT_LANES void FinishChannel(const K& k, const Sums& sums, size_t size, const Out& out) {
    if constexpr (i < kSize) {
      if (i >= size) return;
      constexpr size_t at = c * kSize;
      if constexpr (i == 0) {
        out(c * size, F::kMeanFactor == 1.0 ? sums(at) : Mul(k(F::kMeanFactor), sums(at)));
      } else if constexpr (!F::Has(i)) {
        out(c * size + i, k(0.0));
      } else {
        using C = Coding<F::CodeOf(c, i)>;
        constexpr double kFactor = F::kMeanFactor * F::Range(i) / (C::kRead * C::kScale);
        auto sum = sums(at + i);
        if constexpr (C::kZero != 0.0) sum = NegMulAdd(k(C::kRead * C::kZero), sums(at), sum);
        out(c * size + i, Mul(k(kFactor), sum));
      }
      FinishChannel<c, i + 1>(k, sums, size, out);
    }
  }

  template <size_t c, class K, class In, class V>
  static GAUNT_LANES V Mean(const K& k, const In& in, V& clamped) {
    V mean = in(c * kSize);
    if constexpr (F::kMeanFactor != 1.0) mean = Mul(mean, k(1.0 / F::kMeanFactor));
    return LimitMean(k, mean, TheMeans::Largest(c), clamped);
  }
  template <class K, class V>
  static GAUNT_LANES V PerMean(const K& k, V mean) {
    return IfThenElseZero(Gt(mean, k(0.0)), Div(k(1.0 / F::kMeanFactor), mean));
  }

  template <size_t c, size_t i, class K, class In, class Record, class V>
  static GAUNT_LANES void EncodeChannel(const K& k, V per_mean, const In& in, Record& record,
                                        V& clamped) {
    if constexpr (i < kSize) {
      if constexpr (F::Has(i)) {
        using C = Coding<F::CodeOf(c, i)>;
        constexpr double kPerRange = C::kScale / F::Range(i);
        // In this order nothing overflows that a mean in the container's range permits.
        const V share = Mul(NumberOrZero(k, in(c * kSize + i)), k(kPerRange));
        const V ratio = NumberOrZero(k, Mul(share, per_mean));
        clamped = CountIf(k, Gt(Abs(ratio), k(C::kScale + 0.5)), clamped);
        const V v = Min(Max(ratio, k(-C::kScale)), k(C::kScale));
        record.template Put<F::BitOf(c, i), C::kWidth>(C::Bits(k, v));
      }
      EncodeChannel<c, i + 1>(k, per_mean, in, record, clamped);
    }
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_RATIOS_INL_H_
