// SPDX-License-Identifier: MIT
// Kernels of packed probes. Those of the gather run in lanes over objects (means) and over the
// ratios of one record (everything else); the rest run over items like all kernels.
#if defined(GAUNT_PROBE_PROBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_PROBE_INL_H_
#undef GAUNT_PROBE_PROBE_INL_H_
#else
#define GAUNT_PROBE_PROBE_INL_H_
#endif

#include "evaluate/constants.h"
#include "probe/format.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Lanes over the 8 ratios of a channel, or over 8 objects: at most 8, and a compile-time number.
struct RecordLanes {
  using D = hn::CappedTag<float, HWY_HAVE_SCALABLE ? 4 : 8>;
  using V = hn::Vec<D>;
  using Word = hn::Vec<hn::RebindToUnsigned<D>>;

  GAUNT_LANES V Zero() const { return hn::Zero(D()); }
  GAUNT_LANES V Load(const float* from) const { return hn::Load(D(), from); }
  GAUNT_LANES V Splat(float value) const { return hn::Set(D(), value); }
  GAUNT_LANES void Store(V v, float* to) const { hn::Store(v, D(), to); }

  GAUNT_LANES Word LoadWord(const uint32_t* from) const {
    return hn::Load(hn::RebindToUnsigned<D>(), from);
  }
  GAUNT_LANES V Ratios(const uint8_t* from) const {
    const hn::Rebind<int8_t, D> bytes;
    const hn::RebindToSigned<D> words;
    const auto ratios = hn::LoadU(bytes, reinterpret_cast<const int8_t*>(from));
    return hn::ConvertTo(D(), hn::PromoteTo(words, ratios));
  }
  template <int kChannel>
  GAUNT_LANES V Mantissa(Word word) const {
    const hn::RebindToUnsigned<D> du;
    const auto bits = hn::And(hn::ShiftRight<kChannel * Rgb9e5::kMantissaBits>(word),
                              hn::Set(du, (1u << Rgb9e5::kMantissaBits) - 1));
    return hn::ConvertTo(D(), hn::BitCast(hn::RebindToSigned<D>(), bits));
  }
  // 2^(e - 24), made as the bits of a float.
  GAUNT_LANES V Scale(Word word) const {
    const hn::RebindToUnsigned<D> du;
    const auto exponent = hn::Add(hn::ShiftRight<Rgb9e5::kExponentShift>(word),
                                  hn::Set(du, 127u - Rgb9e5::kExponentBias));
    return hn::BitCast(D(), hn::ShiftLeft<23>(exponent));
  }
};

// Weighted means of one tap of several objects.
template <class K, class Word, class V>
GAUNT_LANES void WeightedMeans(const K& k, Word word, V weight, V& r, V& g, V& b) {
  const V scale = Mul(k.Scale(word), weight);
  r = Mul(k.template Mantissa<0>(word), scale);
  g = Mul(k.template Mantissa<1>(word), scale);
  b = Mul(k.template Mantissa<2>(word), scale);
}

// Adds the ratios of one tap of one object, times the tap's weighted means.
template <class K, class V>
GAUNT_LANES void AddRatios(const K& k, const uint8_t* ratios, V r, V g, V b, V& sum_r, V& sum_g,
                           V& sum_b) {
  sum_r = MulAdd(r, k.Ratios(ratios), sum_r);
  sum_g = MulAdd(g, k.Ratios(ratios + Sh3::kRatios), sum_g);
  sum_b = MulAdd(b, k.Ratios(ratios + 2 * Sh3::kRatios), sum_b);
}

// Sums of weighted means and ratios to coefficients: the bounds come in only here, once per object.
template <int n>
struct FinishGather {
  template <class K, class InR, class InM, class Out>
  GAUNT_LANES void operator()(const K& k, const InR& ratios, const InM& means,
                              const Out& out) const {
    for (size_t c = 0; c < Sh3::kChannels; ++c) {
      const auto f = out.From(c * NumCoefficients(n));
      f(0, means(c));
      Scale<1>(k, ratios.From(c * Sh3::kRatios), f);
    }
  }

 private:
  template <int i, class K, class InR, class Out>
  static GAUNT_LANES void Scale(const K& k, const InR& ratios, const Out& f) {
    if constexpr (i < NumCoefficients(n)) {
      constexpr double kFactor = kSh3Factors.decode[i - 1];
      f(i, Mul(k(kFactor), ratios(i - 1)));
      Scale<i + 1>(k, ratios, f);
    }
  }
};

// Lanes that also know how encoded fields are made.
struct EncodeLanes : Lanes {
  // 2^floor(log2(v)) of a normal v > 0.
  GAUNT_LANES V PowerOfTwo(V v) const {
    const hn::RebindToUnsigned<LaneTag> du;
    return hn::BitCast(LaneTag(), hn::And(hn::BitCast(du, v), hn::Set(du, 0x7F800000u)));
  }
  // An integer below 2^22 as the bits of a word.
  GAUNT_LANES V Integer(V v) const {
    return hn::BitCast(LaneTag(), hn::ConvertTo(hn::RebindToSigned<LaneTag>(), v));
  }
  GAUNT_LANES V Rgb9e5Word(V r, V g, V b, V unit) const {
    const hn::RebindToUnsigned<LaneTag> du;
    const auto field = [&](V v) {
      return hn::BitCast(du, hn::ConvertTo(hn::RebindToSigned<LaneTag>(), v));
    };
    const auto exponent = hn::Sub(hn::ShiftRight<23>(hn::BitCast(du, unit)),
                                  hn::Set(du, 127u - Rgb9e5::kExponentBias));
    const auto rg = hn::Or(field(r), hn::ShiftLeft<Rgb9e5::kMantissaBits>(field(g)));
    const auto be = hn::Or(hn::ShiftLeft<2 * Rgb9e5::kMantissaBits>(field(b)),
                           hn::ShiftLeft<Rgb9e5::kExponentShift>(exponent));
    return hn::BitCast(LaneTag(), hn::Or(rg, be));
  }
};

// Coefficients to the fields of a record: plane 0 the word of the means, planes 1..24 the ratios as
// integers; and, if wanted, the error of what a decoder will make of them.
template <bool kReport>
struct EncodeSh3 {
  template <class K, class In, class Out, class... Report>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& fields,
                              const Report&... report) const {
    using V = typename K::V;
    const V r = Mean(k, in(0)), g = Mean(k, in(9)), b = Mean(k, in(18));
    const V largest = Max(Max(r, g), b);
    // The unit of the mantissas; twice that if the largest would round to 2^9.
    const V least = k(Rgb9e5::kSmallest);
    const V tight = Max(Mul(k.PowerOfTwo(Max(largest, least)), k(0x1p-8)), least);
    const V full = k(511.5);
    const V unit = IfThenElse(Lt(Div(largest, tight), full), tight, Add(tight, tight));
    const V per_unit = Div(k(1.0), unit);
    const V mr = Round(k, Mul(r, per_unit)), mg = Round(k, Mul(g, per_unit)),
            mb = Round(k, Mul(b, per_unit));
    fields(0, k.Rgb9e5Word(mr, mg, mb, unit));
    typename K::template Slots<4> sums;  // squared error, largest error, clamped, this channel's
    for (size_t s = 0; s < 3; ++s) sums(s, k(0.0));
    EncodeChannel(k, 0, Mul(mr, unit), in, fields, sums);
    EncodeChannel(k, 1, Mul(mg, unit), in, fields, sums);
    EncodeChannel(k, 2, Mul(mb, unit), in, fields, sums);
    if constexpr (kReport) WriteReport(k, sums, report...);
  }

 private:
  // Zero for NaN and for what is not positive.
  template <class K, class V>
  static GAUNT_LANES V Mean(const K& k, V v) {
    return Min(IfThenElseZero(Gt(v, k(0.0)), v), k(Rgb9e5::kLargest));
  }
  // To the nearest integer, ties to even, for |v| < 2^22.
  template <class K, class V>
  static GAUNT_LANES V Round(const K& k, V v) {
    const V magic = k(0x1.8p23);
    return Sub(Add(v, magic), magic);
  }
  template <class K, class V>
  static GAUNT_LANES V NumberOrZero(const K& k, V v) {
    return IfThenElseZero(Gt(Abs(v), k(-1.0)), v);
  }

  template <class K, class V, class In, class Out, class Slots>
  static GAUNT_LANES void EncodeChannel(const K& k, size_t c, V mean, const In& in,
                                        const Out& fields, Slots& sums) {
    const V per_mean = IfThenElseZero(Gt(mean, k(0.0)), Div(k(Sh3::kQuantum), mean));
    const V top = k(Sh3::kQuantum);
    const V bottom = k(-Sh3::kQuantum);
    V energy = k(0.0), worst = k(0.0);
    if constexpr (kReport) {
      const V wanted = NumberOrZero(k, in(9 * c));
      const V error = Sub(wanted, mean);
      energy = Mul(error, error);
      worst = Mul(k(kPeak[0]), Abs(error));
      CountIf(k, Gt(wanted, k(Rgb9e5::kLargest)), sums);
      CountIf(k, Lt(wanted, k(0.0)), sums);
    }
    for (size_t l = 1, i = 1; l <= 2; ++l) {
      V band = k(0.0);
      for (; i < (l + 1) * (l + 1); ++i) {
        const V wanted = NumberOrZero(k, in(9 * c + i));
        const V share = Mul(wanted, k(static_cast<double>(kSh3Factors.encode[i - 1])));
        const V ratio = NumberOrZero(k, Mul(share, per_mean));
        const V q = Round(k, Min(Max(ratio, bottom), top));
        fields(Sh3::kRatios * c + i, k.Integer(q));
        if constexpr (kReport) {
          const V step = k(static_cast<double>(kSh3Factors.decode[i - 1]));
          const V error = NegMulAdd(Mul(q, mean), step, wanted);
          band = MulAdd(error, error, band);
          CountIf(k, Gt(Abs(ratio), k(Sh3::kQuantum + 0.5)), sums);
        }
      }
      if constexpr (kReport) {
        energy = MulAdd(k(kEnergy[l]), band, energy);
        worst = MulAdd(k(kPeak[l]), Sqrt(band), worst);
      }
    }
    if constexpr (kReport) {
      sums(0, Add(sums(0), energy));
      sums(1, Max(sums(1), worst));
    }
  }

  template <class K, class Mask, class Slots>
  static GAUNT_LANES void CountIf(const K& k, Mask mask, Slots& sums) {
    sums(2, Add(sums(2), IfThenElseZero(mask, k(1.0))));
  }

  // Per band: the square of A_l / pi, and the largest E/pi of a band of unit norm,
  // (A_l / pi) sqrt((2l+1) / (4 pi)).
  static constexpr double Peak(int l) {
    return evaluate::CosineBand(l) * ConstexprSqrt((2.0 * l + 1.0) / (4.0 * kPi));
  }
  static constexpr double kEnergy[3] = {1.0, evaluate::CosineBand(1) * evaluate::CosineBand(1),
                                        evaluate::CosineBand(2) * evaluate::CosineBand(2)};
  static constexpr double kPeak[3] = {Peak(0), Peak(1), Peak(2)};

  template <class K, class Slots, class Report>
  static GAUNT_LANES void WriteReport(const K& k, const Slots& sums, const Report& report) {
    report(0, Sqrt(Mul(k(1.0 / (4.0 * kPi * Sh3::kChannels)), sums(0))));
    report(1, sums(1));
    report(2, sums(2));
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_PROBE_INL_H_
