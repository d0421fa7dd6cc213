// SPDX-License-Identifier: MIT
// The error of irradiance that a record has.
#if defined(GAUNT_PROBE_REPORT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_REPORT_INL_H_
#undef GAUNT_PROBE_REPORT_INL_H_
#else
#define GAUNT_PROBE_REPORT_INL_H_
#endif

#include "probe/formats-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// A record that is put together, as the only tap.
template <class K, class Fields>
struct OneTap {
  static constexpr size_t kMost = 1;
  static constexpr size_t count = 1;
  const K& k;
  const Fields& fields;
  GAUNT_LANES const Fields& Record(size_t) const { return fields; }
  GAUNT_LANES auto Weight(size_t) const { return k(1.0); }
};

template <class Slots>
struct SlotsOut {
  Slots& slots;
  template <class V>
  GAUNT_LANES void operator()(size_t p, V v) const {
    slots(p, v);
  }
};

// What a decoder makes of a record.
template <class F, class K, class Record, class Decoded>
HWY_NOINLINE void DecodeRecord(const K& k, const Record& record, Decoded& decoded) {
  constexpr size_t kSize = NumCoefficients(F::kOrder);
  typename K::template Slots<FormatKernels<F>::kSums> sums;
  const OneTap<K, Record> tap = {k, record};
  FormatKernels<F>::template AddTaps<true>(k, tap, kSize, sums);
  FormatKernels<F>::Finish(k, sums, kSize, SlotsOut<Decoded>{decoded});
}

// A power of two of about the size of the light, by which errors are divided before they are squared:
// squares of floats reach neither 1e30 nor 1e-23. Infinite light has infinite errors.
template <class F, class K, class In>
GAUNT_LANES auto SizeOfLight(const K& k, const In& in) {
  auto largest = k(0x1p-100);
  for (size_t p = 0; p < kPlanes<F>; ++p) largest = Max(largest, Abs(NumberOrZero(k, in(p))));
  return k.PowerOfTwo(Min(largest, k(0x1p120)));
}

// The square of the error of a channel's band, in relation to a size; NaNs stand for 0.
template <class F, class K, class In, class Decoded, class V>
GAUNT_LANES V BandError(const K& k, const In& in, const Decoded& decoded, V per_size, size_t c,
                        int l) {
  V band = k(0.0);
  for (int i = NumCoefficients(l); i < NumCoefficients(l + 1); ++i) {
    const size_t p = c * NumCoefficients(F::kOrder) + static_cast<size_t>(i);
    const V error = Mul(Sub(NumberOrZero(k, in(p)), decoded(p)), per_size);
    band = MulAdd(error, error, band);
  }
  return band;
}

// The integral over the sphere of the squared error of E/pi, of all channels.
template <class F, class K, class In, class Decoded, class V>
GAUNT_LANES V ErrorEnergy(const K& k, const In& in, const Decoded& decoded, V per_size) {
  V energy = k(0.0);
  for (size_t c = 0; c < kChannels; ++c) {
    for (int l = 0; l < static_cast<int>(F::kOrder); ++l) {
      const double factor = evaluate::CosineBand(l);
      if (factor == 0.0) continue;  // E has no such band, even if it is infinite
      energy = MulAdd(k(factor * factor), BandError<F>(k, in, decoded, per_size, c, l), energy);
    }
  }
  return energy;
}

// The most that E/pi of one channel can be wrong by.
template <class F, class K, class In, class Decoded, class V>
GAUNT_LANES V LargestError(const K& k, const In& in, const Decoded& decoded, V per_size) {
  V worst = k(0.0);
  for (size_t c = 0; c < kChannels; ++c) {
    V largest = k(0.0);
    for (int l = 0; l < static_cast<int>(F::kOrder); ++l) {
      const double factor = evaluate::CosineBand(l);
      if (factor == 0.0) continue;
      // The largest E/pi of a band of unit norm.
      const double peak =
          (factor < 0.0 ? -factor : factor) * ConstexprSqrt((2.0 * l + 1.0) / (4.0 * kPi));
      largest = MulAdd(k(peak), Sqrt(BandError<F>(k, in, decoded, per_size, c, l)), largest);
    }
    worst = Max(worst, largest);
  }
  return worst;
}

template <class F, class K, class In, class Record, class V, class Out>
GAUNT_LANES void WriteReport(const K& k, const In& in, const Record& record, V clamped,
                             const Out& report) {
  typename K::template Slots<kPlanes<F>> decoded;
  DecodeRecord<F>(k, record, decoded);
  const V size = SizeOfLight<F>(k, in), per_size = Div(k(1.0), size);
  const V energy = ErrorEnergy<F>(k, in, decoded, per_size);
  report(0, Mul(size, Sqrt(Mul(k(1.0 / (4.0 * kPi * kChannels)), energy))));
  report(1, Mul(size, LargestError<F>(k, in, decoded, per_size)));
  report(2, clamped);
}

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_REPORT_INL_H_
