// SPDX-License-Identifier: MIT
// Formats of ZH3: of band 2, only the part that is symmetric about the luminance axis of band 1.
#if defined(GAUNT_PROBE_ZONAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_ZONAL_INL_H_
#undef GAUNT_PROBE_ZONAL_INL_H_
#else
#define GAUNT_PROBE_ZONAL_INL_H_
#endif

#include "light/constants.h"
#include "probe/shared-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// `BandOne` has the means and band 1, whose numbers it reads kRead times too large.
template <class F, class BandOne>
struct Zonal {
  static constexpr size_t kSums = kPlanes<F>;

  template <bool kNew, class K, class Taps, class Sums>
  static GAUNT_LANES void AddTaps(const K& k, const Taps& taps, size_t size, Sums& sums) {
    using V = typename K::V;
    BandOne::template AddTaps<kNew>(k, taps, size, sums);
    if (size <= kBand) return;
    typename K::template Slots<kWidth * Taps::kMost> bands;
    typename K::template Slots<kChannels * Taps::kMost> factors;
    for (size_t t = 0; t < taps.count; ++t) {
      const auto record = taps.Record(t);
      typename K::template Slots<kWidth> band;
      typename K::template Slots<kChannels> means;
      const V scale = Mul(FindBand(k, record, means, band), taps.Weight(t));
      for (size_t m = 0; m < kWidth; ++m) bands(kWidth * t + m, band(m));
      factors(kChannels * t, Mul(Mul(means(0), scale), Number<0>(k, record)));
      factors(kChannels * t + 1, Mul(Mul(means(1), scale), Number<1>(k, record)));
      factors(kChannels * t + 2, Mul(Mul(means(2), scale), Number<2>(k, record)));
    }
    for (size_t c = 0; c < kChannels; ++c) {
      const size_t at = c * kSize + kBand;
      V s0 = k(0.0), s1 = s0, s2 = s0, s3 = s0, s4 = s0;
      if constexpr (!kNew) {
        s0 = sums(at), s1 = sums(at + 1), s2 = sums(at + 2), s3 = sums(at + 3), s4 = sums(at + 4);
      }
      for (size_t t = 0; t < taps.count; ++t) {
        const V factor = factors(kChannels * t + c);
        s0 = MulAdd(factor, bands(kWidth * t), s0);
        s1 = MulAdd(factor, bands(kWidth * t + 1), s1);
        s2 = MulAdd(factor, bands(kWidth * t + 2), s2);
        s3 = MulAdd(factor, bands(kWidth * t + 3), s3);
        s4 = MulAdd(factor, bands(kWidth * t + 4), s4);
      }
      sums(at, s0);
      sums(at + 1, s1);
      sums(at + 2, s2);
      sums(at + 3, s3);
      sums(at + 4, s4);
    }
  }

  template <class K, class Sums, class Out>
  static GAUNT_LANES void Finish(const K& k, const Sums& sums, size_t size, const Out& out) {
    for (size_t c = 0; c < kChannels; ++c) {
      out(c * size, sums(c * kSize));
      for (size_t i = 1; i < size; ++i) {
        const double range = i < kBand ? Bound(1) / BandOne::kRead : kAxialRange;
        out(c * size + i, Mul(k(range / kLargest), sums(c * kSize + i)));
      }
    }
  }

  template <class K, class In, class Record, class V = typename K::V>
  static GAUNT_LANES V Encode(const K& k, const In& in, Record& record) {
    V clamped = BandOne::Encode(k, in, record);
    typename K::template Slots<kWidth> band;
    typename K::template Slots<kChannels> means;
    const V scale = FindBand(k, record.Read(), means, band);
    if constexpr (F::kSharesRatios) {
      const V per_luma = ReciprocalOrZero(k, Luma(k, means(0), means(1), means(2)));
      for (size_t c = 0; c < kChannels; ++c) means(c, Mul(means(c), per_luma));
      const V r = AlongBand(k, in, 0, band, means(0), per_luma, clamped);
      const V g = AlongBand(k, in, 1, band, means(1), per_luma, clamped);
      const V b = AlongBand(k, in, 2, band, means(2), per_luma, clamped);
      PutAxial<0>(k, Mul(ClosestRatio(k, means, r, g, b), scale), record);
    } else {
      PutAxial<0>(k, Mul(RatioAlongBand(k, in, 0, band, means(0), clamped), scale), record);
      PutAxial<1>(k, Mul(RatioAlongBand(k, in, 1, band, means(1), clamped), scale), record);
      PutAxial<2>(k, Mul(RatioAlongBand(k, in, 2, band, means(2), clamped), scale), record);
    }
    return clamped;
  }

 private:
  static constexpr size_t kSize = NumCoefficients(F::kOrder);
  static constexpr size_t kBand = 4, kWidth = 5;  // where band 2 begins, and its coefficients
  static constexpr double kLargest = F::Axial(0).Largest();

  template <size_t c, class K, class Record>
  static GAUNT_LANES auto Number(const K& k, const Record& record) {
    return record.template Signed<F::Axial(c).bit, F::Axial(c).width>(k);
  }
  template <size_t c, class K, class V, class Record>
  static GAUNT_LANES void PutAxial(const K& k, V ratio, Record& record) {
    PutRatio<F::Axial(c).bit, F::Axial(c).width>(k, ratio, record);
  }

  // The means, and the zonal function of band 2 times a number, which is one over the result; 0 if
  // there is no axis. In multiplications and additions of their own: encoded bytes are the same on
  // every target.
  template <class K, class Record, class MeansOut, class BandOut>
  static GAUNT_LANES auto FindBand(const K& k, const Record& record, MeansOut& means,
                                   BandOut& band) {
    using V = typename K::V;
    V r, g, b;
    Means<F::kContainer, F::kContainerBit>::Decode(k, record, k(1.0), r, g, b);
    means(0, r);
    means(1, g);
    means(2, b);
    V y, z, x;  // the axis is (-x, -y, z); products of two have the signs of the basis
    if constexpr (F::kSharesRatios) {
      y = BandOne::template Number<0, 1>(k, record);
      z = BandOne::template Number<0, 2>(k, record);
      x = BandOne::template Number<0, 3>(k, record);
    } else {
      r = Mul(r, k(light::kLuminance[0]));
      g = Mul(g, k(light::kLuminance[1]));
      b = Mul(b, k(light::kLuminance[2]));
      y = SumOfChannels<1>(k, record, r, g, b);
      z = SumOfChannels<2>(k, record, r, g, b);
      x = SumOfChannels<3>(k, record, r, g, b);
    }
    const V x2 = Mul(x, x), y2 = Mul(y, y), z2 = Mul(z, z);
    const V flat = Add(x2, y2), root_x = Mul(k(ConstexprSqrt(3.0)), x);
    const V root_y = Mul(k(ConstexprSqrt(3.0)), y);
    band(0, Mul(root_x, y));
    band(1, Mul(root_y, z));
    band(2, Sub(z2, Mul(k(0.5), flat)));
    band(3, Mul(root_x, z));
    band(4, Mul(k(0.5 * ConstexprSqrt(3.0)), Sub(x2, y2)));
    return ReciprocalOrZero(k, Add(flat, z2));
  }
  template <size_t i, class K, class Record, class V>
  static GAUNT_LANES V SumOfChannels(const K& k, const Record& record, V r, V g, V b) {
    const V red = Mul(r, BandOne::template Number<0, i>(k, record));
    const V green = Mul(g, BandOne::template Number<1, i>(k, record));
    const V blue = Mul(b, BandOne::template Number<2, i>(k, record));
    return Add(Add(red, green), blue);
  }

  // Band 2 of a channel, in relation to `per`, along that of the axis.
  template <class K, class In, class Band, class V>
  static GAUNT_LANES V AlongBand(const K& k, const In& in, size_t c, const Band& band, V most,
                                 V per, V& clamped) {
    V sum = k(0.0);
    for (size_t m = 0; m < kWidth; ++m) {
      const V share = ShareOf(k, in(c * kSize + kBand + m), kAxialRange, most, per, clamped);
      sum = Add(sum, Mul(share, band(m)));
    }
    return sum;
  }
  template <class K, class In, class Band, class V>
  static GAUNT_LANES V RatioAlongBand(const K& k, const In& in, size_t c, const Band& band, V mean,
                                      V& clamped) {
    const V one = IfThenElseZero(Gt(mean, k(0.0)), k(1.0));
    return AlongBand(k, in, c, band, one, ReciprocalOrZero(k, mean), clamped);
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_ZONAL_INL_H_
