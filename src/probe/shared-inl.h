// SPDX-License-Identifier: MIT
// Formats of means, ratios that the channels share, and colours: blending and encoding.
#if defined(GAUNT_PROBE_SHARED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_SHARED_INL_H_
#undef GAUNT_PROBE_SHARED_INL_H_
#else
#define GAUNT_PROBE_SHARED_INL_H_
#endif

#include "probe/means-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// (R + 2 G + B) / 4, to which neither axis of colour adds anything.
template <class K, class V>
GAUNT_LANES V Luma(const K& k, V r, V g, V b) {
  return Mul(k(0.25), Add(Add(g, g), Add(r, b)));
}

template <class K, class V>
GAUNT_LANES V ReciprocalOrZero(const K& k, V v) {
  return IfThenElseZero(Gt(v, k(0.0)), Div(k(1.0), v));
}

// The ratio that comes closest to those of the channels.
template <class K, class M, class V>
GAUNT_LANES V ClosestRatio(const K& k, const M& means, V r, V g, V b) {
  const V mean_r = means(0), mean_g = means(1), mean_b = means(2);
  const V product = Add(Add(Mul(mean_r, r), Mul(mean_g, g)), Mul(mean_b, b));
  const V squares = Add(Add(Mul(mean_r, mean_r), Mul(mean_g, mean_g)), Mul(mean_b, mean_b));
  return Mul(product, ReciprocalOrZero(k, squares));
}
// Writes a ratio of -1 .. 1, and gives its number.
template <int kBit, int kWidth, class K, class V, class Record>
GAUNT_LANES V PutRatio(const K& k, V ratio, Record& record) {
  constexpr double kLargest = BitField{kBit, kWidth}.Largest();
  const V number = Round(k, Min(Max(Mul(ratio, k(kLargest)), k(-kLargest)), k(kLargest)));
  record.template Put<kBit, kWidth>(k.template Integer<kWidth>(number));
  return number;
}
// What a channel has of a coefficient in relation to a luma, as far as light of that mean can.
template <class K, class V>
GAUNT_LANES V ShareOf(const K& k, V coefficient, double range, V mean, V per_luma, V& clamped) {
  const V share = Mul(NumberOrZero(k, coefficient), k(1.0 / range));
  const V ratio = NumberOrZero(k, Mul(share, per_luma));
  const V lit = IfThenElseZero(Gt(mean, k(0.0)), Abs(ratio));
  clamped = CountIf(k, Gt(lit, Mul(mean, k(1.0 + 0.5 / 127.0))), clamped);
  return Min(Max(ratio, Neg(mean)), mean);
}

template <class F>
struct SharedRatios {
  // Those of the coefficients, and behind them those of orange and green of each but the mean.
  static constexpr size_t kSums =
      kPlanes<F> + (F::kHasColour ? 2 * (F::kOrder * F::kOrder - 1) : 0);
  static constexpr double kRead = 1.0;

  template <bool kNew, class K, class Taps, class Sums>
  static GAUNT_LANES void AddTaps(const K& k, const Taps& taps, size_t size, Sums& sums) {
    using V = typename K::V;
    typename K::template Slots<kMeans * Taps::kMost> means;
    V sum_r = k(0.0), sum_g = sum_r, sum_b = sum_r;
    if constexpr (!kNew) sum_r = sums(0), sum_g = sums(kSize), sum_b = sums(2 * kSize);
    for (size_t t = 0; t < taps.count; ++t) {
      V r, g, b;
      TheMeans::Decode(k, taps.Record(t), taps.Weight(t), r, g, b);
      means(kMeans * t, r);
      means(kMeans * t + 1, g);
      means(kMeans * t + 2, b);
      if constexpr (F::kHasColour) means(kMeans * t + 3, Luma(k, r, g, b));
      sum_r = Add(sum_r, r);
      sum_g = Add(sum_g, g);
      sum_b = Add(sum_b, b);
    }
    sums(0, sum_r);
    sums(kSize, sum_g);
    sums(2 * kSize, sum_b);
    AddFrom<kNew, 1>(k, taps, means, size, sums);
  }

  template <class K, class Sums, class Out>
  static GAUNT_LANES void Finish(const K& k, const Sums& sums, size_t size, const Out& out) {
    for (size_t c = 0; c < kChannels; ++c) out(c * size, sums(c * kSize));
    FinishFrom<1>(k, sums, size, out);
  }

  template <class K, class In, class Record, class V = typename K::V>
  static GAUNT_LANES V Encode(const K& k, const In& in, Record& record) {
    V clamped = k(0.0);
    V r = LimitMean(k, in(0), TheMeans::Largest(0), clamped);
    V g = LimitMean(k, in(kSize), TheMeans::Largest(1), clamped);
    V b = LimitMean(k, in(2 * kSize), TheMeans::Largest(2), clamped);
    TheMeans::Encode(k, record, r, g, b);
    const V per_luma = ReciprocalOrZero(k, Luma(k, r, g, b));
    typename K::template Slots<kChannels> means;
    means(0, Mul(r, per_luma));
    means(1, Mul(g, per_luma));
    means(2, Mul(b, per_luma));
    EncodeFrom<1>(k, in, means, per_luma, record, clamped);
    return clamped;
  }

  // The number of a ratio; of any channel.
  template <size_t, size_t i, class K, class Record>
  static GAUNT_LANES auto Number(const K& k, const Record& record) {
    return record.template Signed<F::Ratio(i).bit, F::Ratio(i).width>(k);
  }

 private:
  using TheMeans = Means<F::kContainer, F::kContainerBit>;
  static constexpr size_t kSize = NumCoefficients(F::kOrder);
  static constexpr size_t kMeans = F::kHasColour ? 4 : 3;
  static constexpr size_t OrangeSum(size_t i) { return kPlanes<F> + 2 * (i - 1); }

  template <int kBit, int kWidth, class K, class Record>
  static GAUNT_LANES auto Square(const K& k, const Record& record) {
    const auto number = record.template Signed<kBit, kWidth>(k);
    return Mul(number, Abs(number));
  }

  // A record's share of a coefficient: of red, green and blue, and of the colours o and h.
  template <size_t i, class K, class Record, class M, class V>
  static GAUNT_LANES void AddRecord(const K& k, const Record& record, const M& means, size_t at,
                                    V& r, V& g, V& b, V& o, V& h) {
    constexpr BitField kOrange = F::Orange(i), kGreen = F::Green(i);
    const V ratio = Number<0, i>(k, record);
    r = MulAdd(means(at), ratio, r);
    g = MulAdd(means(at + 1), ratio, g);
    b = MulAdd(means(at + 2), ratio, b);
    if constexpr (kOrange.width > 0) {
      o = MulAdd(means(at + 3), Square<kOrange.bit, kOrange.width>(k, record), o);
    }
    if constexpr (kGreen.width > 0) {
      h = MulAdd(means(at + 3), Square<kGreen.bit, kGreen.width>(k, record), h);
    }
  }
  template <size_t i, class Sums, class V>
  static GAUNT_LANES void LoadSums(const Sums& sums, V& r, V& g, V& b, V& o, V& h) {
    r = sums(i), g = sums(kSize + i), b = sums(2 * kSize + i);
    if constexpr (F::Orange(i).width > 0) o = sums(OrangeSum(i));
    if constexpr (F::Green(i).width > 0) h = sums(OrangeSum(i) + 1);
  }
  template <size_t i, class Sums, class V>
  static GAUNT_LANES void StoreSums(Sums& sums, V r, V g, V b, V o, V h) {
    sums(i, r);
    sums(kSize + i, g);
    sums(2 * kSize + i, b);
    if constexpr (F::Orange(i).width > 0) sums(OrangeSum(i), o);
    if constexpr (F::Green(i).width > 0) sums(OrangeSum(i) + 1, h);
  }

  // Two coefficients at a time, so that one's sums are not waited for.
  template <bool kNew, size_t i, class K, class Taps, class M, class Sums>
  static GAUNT_LANES void AddFrom(const K& k, const Taps& taps, const M& means, size_t size,
                                  Sums& sums) {
    if constexpr (i < kSize && F::Has(i)) {
      using V = typename K::V;
      constexpr bool kTwo = i + 1 < kSize && F::Has(i + 1);
      constexpr size_t j = kTwo ? i + 1 : i;
      if (i >= size) return;
      V r = k(0.0), g = r, b = r, o = r, h = r, other_r = r, other_g = r, other_b = r, other_o = r,
        other_h = r;
      if constexpr (!kNew) LoadSums<i>(sums, r, g, b, o, h);
      if constexpr (!kNew && kTwo) LoadSums<j>(sums, other_r, other_g, other_b, other_o, other_h);
      for (size_t t = 0; t < taps.count; ++t) {
        const auto record = taps.Record(t);
        AddRecord<i>(k, record, means, kMeans * t, r, g, b, o, h);
        if constexpr (kTwo) {
          AddRecord<j>(k, record, means, kMeans * t, other_r, other_g, other_b, other_o, other_h);
        }
      }
      StoreSums<i>(sums, r, g, b, o, h);
      if constexpr (kTwo) StoreSums<j>(sums, other_r, other_g, other_b, other_o, other_h);
      AddFrom<kNew, j + 1>(k, taps, means, size, sums);
    }
  }

  template <size_t i, class K, class Sums, class Out>
  static GAUNT_LANES void FinishFrom(const K& k, const Sums& sums, size_t size, const Out& out) {
    if constexpr (i < kSize && F::Has(i)) {
      using V = typename K::V;
      if (i >= size) return;
      constexpr double kFactor = F::Range(i) / F::Ratio(i).Largest();
      V r = Mul(k(kFactor), sums(i)), g = Mul(k(kFactor), sums(kSize + i));
      V b = Mul(k(kFactor), sums(2 * kSize + i));
      if constexpr (F::Orange(i).width > 0) {
        constexpr double kColour = SquareFactor(i, F::Orange(i));
        const V orange = sums(OrangeSum(i));
        r = MulAdd(k(kColour), orange, r);
        b = NegMulAdd(k(kColour), orange, b);
      }
      if constexpr (F::Green(i).width > 0) {
        constexpr double kColour = SquareFactor(i, F::Green(i));
        const V green = sums(OrangeSum(i) + 1);
        r = NegMulAdd(k(kColour), green, r);
        g = MulAdd(k(kColour), green, g);
        b = NegMulAdd(k(kColour), green, b);
      }
      out(i, r);
      out(size + i, g);
      out(2 * size + i, b);
      FinishFrom<i + 1>(k, sums, size, out);
    }
  }
  static constexpr double SquareFactor(size_t i, BitField field) {
    return F::Range(i) * F::ColourRange(i) / (field.Largest() * field.Largest());
  }

  // In multiplications and additions of their own, so that bytes are the same on every target.
  template <size_t i, class K, class In, class M, class Record, class V>
  static GAUNT_LANES void EncodeFrom(const K& k, const In& in, const M& means, V per_luma,
                                     Record& record, V& clamped) {
    if constexpr (i < kSize && F::Has(i)) {
      constexpr BitField kRatio = F::Ratio(i), kOrange = F::Orange(i), kGreen = F::Green(i);
      const V mean_r = means(0), mean_g = means(1), mean_b = means(2);
      V r = ShareOf(k, in(i), F::Range(i), mean_r, per_luma, clamped);
      V g = ShareOf(k, in(kSize + i), F::Range(i), mean_g, per_luma, clamped);
      V b = ShareOf(k, in(2 * kSize + i), F::Range(i), mean_b, per_luma, clamped);
      V ratio;
      if constexpr (kGreen.width > 0) {
        ratio = Luma(k, r, g, b);
      } else if constexpr (kOrange.width > 0) {
        // The closest, where orange takes what it can.
        const V pair = Add(mean_r, mean_b), twice = Add(mean_g, mean_g);
        const V squares = Add(Mul(pair, pair), Mul(twice, mean_g));
        const V product = Add(Mul(pair, Add(r, b)), Mul(twice, g));
        ratio = Mul(product, ReciprocalOrZero(k, squares));
      } else {
        ratio = ClosestRatio(k, means, r, g, b);
      }
      const V number = PutRatio<kRatio.bit, kRatio.width>(k, ratio, record);
      if constexpr (kOrange.width > 0) {
        const V decoded = Mul(number, k(1.0 / kRatio.Largest()));
        r = Sub(r, Mul(mean_r, decoded));
        g = Sub(g, Mul(mean_g, decoded));
        b = Sub(b, Mul(mean_b, decoded));
        EncodeSquare<i, kOrange.bit, kOrange.width>(k, Mul(k(0.5), Sub(r, b)), record, clamped);
      }
      if constexpr (kGreen.width > 0) {
        const V green = Mul(k(0.25), Sub(Add(g, g), Add(r, b)));
        EncodeSquare<i, kGreen.bit, kGreen.width>(k, green, record, clamped);
      }
      EncodeFrom<i + 1>(k, in, means, per_luma, record, clamped);
    }
  }

  // The nearest q |q|: q^2 is nearest from q^2 - q + 1/2 to q^2 + q + 1/2.
  template <size_t i, int kBit, int kWidth, class K, class V, class Record>
  static GAUNT_LANES void EncodeSquare(const K& k, V colour, Record& record, V& clamped) {
    constexpr double kLargest = BitField{kBit, kWidth}.Largest();
    constexpr double kMost = kLargest * kLargest;
    const V square = Mul(Abs(colour), k(kMost / F::ColourRange(i)));
    clamped = CountIf(k, Gt(square, k(kMost + kLargest + 0.5)), clamped);
    const V root = Sqrt(Max(Sub(Min(square, k(kMost)), k(0.25)), k(0.0)));
    const V number = Round(k, root);
    const V negative = IfThenElse(Lt(colour, k(0.0)), Neg(number), number);
    record.template Put<kBit, kWidth>(k.template Integer<kWidth>(negative));
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_SHARED_INL_H_
