// SPDX-License-Identifier: MIT
// The means of R, G and B in their containers.
#if defined(GAUNT_PROBE_MEANS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_MEANS_INL_H_
#undef GAUNT_PROBE_MEANS_INL_H_
#else
#define GAUNT_PROBE_MEANS_INL_H_
#endif

#include "probe/record-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// Of NaN, 0, so that nothing later is NaN.
template <class K, class V = typename K::V>
GAUNT_LANES V NumberOrZero(const K& k, V v) {
  return IfThenElseZero(Gt(Abs(v), k(-1.0)), v);
}
// To the nearest integer, ties to even, for |v| < 2^22.
template <class K, class V = typename K::V>
GAUNT_LANES V Round(const K& k, V v) {
  const V magic = k(0x1.8p23);
  return Sub(Add(v, magic), magic);
}
// In 0 .. most; NaN becomes 0.
template <class K, class V = typename K::V>
GAUNT_LANES V PositivePart(const K& k, V v, double most) {
  return Min(IfThenElseZero(Gt(v, k(0.0)), v), k(most));
}

// One more where the mask is set.
template <class K, class Mask, class V>
GAUNT_LANES V CountIf(const K& k, Mask mask, V count) {
  return Add(count, IfThenElseZero(mask, k(1.0)));
}
// What a container can hold of a mean; counts those that it cuts off.
template <class K, class V>
GAUNT_LANES V LimitMean(const K& k, V mean, double most, V& clamped) {
  clamped = CountIf(k, Lt(mean, k(0.0)), clamped);
  clamped = CountIf(k, Gt(mean, k(most)), clamped);
  return PositivePart(k, mean, most);
}

// Decode() gives the means times a number. Encode(), of means in 0 .. the largest, gives what a
// decoder makes of them.
template <Container kContainer, int kBit>
struct Means;

template <int kBit>
struct Means<Container::kRgb9e5, kBit> {
  static constexpr double Largest(size_t) { return Rgb9e5::kLargest; }

  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Decode(const K& k, const Record& record, V times, V& r, V& g, V& b) {
    const V scale =
        Mul(record.template Power<kBit + Rgb9e5::kExponentShift, Rgb9e5::kExponentBias>(k), times);
    r = Mul(record.template Unsigned<kBit, kBits>(k), scale);
    g = Mul(record.template Unsigned<kBit + kBits, kBits>(k), scale);
    b = Mul(record.template Unsigned<kBit + 2 * kBits, kBits>(k), scale);
  }

  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Encode(const K& k, Record& record, V& r, V& g, V& b) {
    const V largest = Max(Max(r, g), b);
    // The unit of the mantissas; twice that if the largest would round to 2^9.
    const V least = k(Rgb9e5::kSmallest);
    const V tight = Max(Mul(k.PowerOfTwo(Max(largest, least)), k(0x1p-8)), least);
    const V full = k(511.5);
    const V unit = IfThenElse(Lt(Div(largest, tight), full), tight, Add(tight, tight));
    const V per_unit = Div(k(1.0), unit);
    record.template Put<kBit + Rgb9e5::kExponentShift, 5>(
        k.template Exponent<Rgb9e5::kExponentBias>(unit));
    r = Quantise<kBit>(k, record, r, per_unit, unit);
    g = Quantise<kBit + kBits>(k, record, g, per_unit, unit);
    b = Quantise<kBit + 2 * kBits>(k, record, b, per_unit, unit);
  }

 private:
  static constexpr int kBits = Rgb9e5::kMantissaBits;

  template <int kFieldBit, class K, class Record, class V = typename K::V>
  static GAUNT_LANES V Quantise(const K& k, Record& record, V mean, V per_unit, V unit) {
    const V mantissa = Round(k, Mul(mean, per_unit));
    record.template Put<kFieldBit, kBits>(k.template Integer<kBits>(mantissa));
    return Mul(mantissa, unit);
  }
};

template <int kBit>
struct Means<Container::kHalf3, kBit> {
  static constexpr double Largest(size_t) { return SmallFloat<10>::kLargest; }

  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Decode(const K& k, const Record& record, V times, V& r, V& g, V& b) {
    r = Mul(Mul(record.template TinyHalf<kBit>(k), k(kPerTiny)), times);
    g = Mul(Mul(record.template TinyHalf<kBit + 16>(k), k(kPerTiny)), times);
    b = Mul(Mul(record.template TinyHalf<kBit + 32>(k), k(kPerTiny)), times);
  }
  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Encode(const K& k, Record& record, V& r, V& g, V& b) {
    record.template Put<kBit, 16>(k.HalfBits(r));
    record.template Put<kBit + 16, 16>(k.HalfBits(g));
    record.template Put<kBit + 32, 16>(k.HalfBits(b));
    Decode(k, record.Read(), k(1.0), r, g, b);
  }
};

template <int kBit>
struct Means<Container::kR11g11b10, kBit> {
  static constexpr double Largest(size_t channel) {
    return channel == 2 ? SmallFloat<5>::kLargest : SmallFloat<6>::kLargest;
  }

  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Decode(const K& k, const Record& record, V times, V& r, V& g, V& b) {
    r = Mul(Mul(record.template TinyFloat<kBit, 6>(k), k(kPerTiny)), times);
    g = Mul(Mul(record.template TinyFloat<kBit + 11, 6>(k), k(kPerTiny)), times);
    b = Mul(Mul(record.template TinyFloat<kBit + 22, 5>(k), k(kPerTiny)), times);
  }
  template <class K, class Record, class V = typename K::V>
  static GAUNT_LANES void Encode(const K& k, Record& record, V& r, V& g, V& b) {
    record.template Put<kBit, 11>(k.template SmallFloatBits<6>(r));
    record.template Put<kBit + 11, 11>(k.template SmallFloatBits<6>(g));
    record.template Put<kBit + 22, 10>(k.template SmallFloatBits<5>(b));
    Decode(k, record.Read(), k(1.0), r, g, b);
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_MEANS_INL_H_
