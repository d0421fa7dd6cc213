// SPDX-License-Identifier: MIT
// Powers in lanes, from operations that IEEE 754 defines to the bit: the same bits on every target
// of a class, whatever the version of Highway.
#if defined(GAUNT_SIMD_POWER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_POWER_INL_H_
#undef GAUNT_SIMD_POWER_INL_H_
#else
#define GAUNT_SIMD_POWER_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

// e of v = m 2^e with m from sqrt(1/2) to sqrt(2), of normal positive v.
GAUNT_LANES hn::Vec<LaneTag> Exponent(hn::Vec<LaneTag> v) {
  const hn::RebindToSigned<LaneTag> bits;
  const auto from_least = hn::Sub(hn::BitCast(bits, v), hn::Set(bits, 0x3F3504F3));  // sqrt(1/2)
  return hn::ConvertTo(LaneTag(), hn::ShiftRight<23>(from_least));
}

// v 2^e of a whole number e, where v and the result are normal.
GAUNT_LANES hn::Vec<LaneTag> TimesPowerOfTwo(hn::Vec<LaneTag> v, hn::Vec<LaneTag> e) {
  const hn::RebindToSigned<LaneTag> bits;
  const auto exponent = hn::ShiftLeft<23>(hn::ConvertTo(bits, e));
  return hn::BitCast(LaneTag(), hn::Add(hn::BitCast(bits, v), exponent));
}

// base^exponent for bases from 0 to 1 and exponents from 1 to 4; error below 3e-7.
template <class K, class V>
GAUNT_LANES V Power(const K& k, V base, V exponent) {
  constexpr double kLn2 = 0.69314718055994530942;
  constexpr double kLeast = 0x1p-100;  // below, the power is 0

  // log2 of the base: e + log2 m, with log2 m = 2/ln2 artanh(s), s = (m-1)/(m+1), |s| < 0.172.
  constexpr int kLogTerms = 5;
  constexpr double kLog[kLogTerms] = {2.0 / kLn2, 2.0 / (3.0 * kLn2), 2.0 / (5.0 * kLn2),
                                      2.0 / (7.0 * kLn2), 2.0 / (9.0 * kLn2)};
  const V normal = Max(base, k(kLeast));
  const V e = Exponent(normal);
  const V m = TimesPowerOfTwo(normal, Neg(e));
  const V s = Div(Sub(m, k(1.0)), Add(m, k(1.0)));
  const V s2 = Mul(s, s);
  V series = k(kLog[kLogTerms - 1]);
  for (int i = kLogTerms - 2; i >= 0; --i) series = MulAdd(series, s2, k(kLog[i]));
  const V power = Max(Mul(exponent, MulAdd(series, s, e)), k(-125.0));

  // 2^power: a whole number, and the Taylor series of the rest f, |f| <= 1/2.
  constexpr int kExpTerms = 8;
  constexpr double kExp[kExpTerms] = {1.0,
                                      kLn2,
                                      kLn2 * kLn2 / 2.0,
                                      kLn2 * kLn2 * kLn2 / 6.0,
                                      kLn2 * kLn2 * kLn2 * kLn2 / 24.0,
                                      kLn2 * kLn2 * kLn2 * kLn2 * kLn2 / 120.0,
                                      kLn2 * kLn2 * kLn2 * kLn2 * kLn2 * kLn2 / 720.0,
                                      kLn2 * kLn2 * kLn2 * kLn2 * kLn2 * kLn2 * kLn2 / 5040.0};
  constexpr double kRounder = 0x1.8p23;  // has no room for a fraction
  const V whole = Sub(Add(power, k(kRounder)), k(kRounder));
  const V f = Sub(power, whole);
  V exponential = k(kExp[kExpTerms - 1]);
  for (int i = kExpTerms - 2; i >= 0; --i) exponential = MulAdd(exponential, f, k(kExp[i]));
  return IfThenElseZero(Gt(base, k(kLeast)), TimesPowerOfTwo(exponential, whole));
}

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_POWER_INL_H_
