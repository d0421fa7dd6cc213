// SPDX-License-Identifier: MIT
// Kernels of packed probes: which one each format has, and how they are encoded.
#if defined(GAUNT_PROBE_PROBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_PROBE_INL_H_
#undef GAUNT_PROBE_PROBE_INL_H_
#else
#define GAUNT_PROBE_PROBE_INL_H_
#endif

#include "probe/floats-inl.h"
#include "probe/ratios-inl.h"
#include "probe/zonal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

template <class F>
struct KernelsOf {
  using Format = Ratios<F>;
};
template <>
struct KernelsOf<LumaAt12> {
  using Format = SharedRatios<LumaAt12>;
};
template <>
struct KernelsOf<ChromaAt16> {
  using Format = SharedRatios<ChromaAt16>;
};
template <>
struct KernelsOf<ChromaAt21> {
  using Format = SharedRatios<ChromaAt21>;
};
template <>
struct KernelsOf<Zh3At16> {
  using Format = Zonal<Zh3At16, Ratios<Zh3At16>>;
};
template <>
struct KernelsOf<Zh3LumaAt8> {
  using Format = Zonal<Zh3LumaAt8, SharedRatios<Zh3LumaAt8>>;
};
template <>
struct KernelsOf<HalfAt54> {
  using Format = Floats<HalfAt54>;
};
template <>
struct KernelsOf<FloatAt108> {
  using Format = Floats<FloatAt108>;
};
template <class F>
using FormatKernels = typename KernelsOf<F>::Format;

// The record that has just been put together, as the only tap.
template <class K, class Fields>
struct OneTap {
  static constexpr size_t kMost = 1;
  static constexpr size_t count = 1;
  const K& k;
  const Fields& fields;
  GAUNT_LANES const Fields& Record(size_t) const { return fields; }
  GAUNT_LANES auto Weight(size_t) const { return k(1.0); }
};

// Coefficients to the words of records; and, if wanted, the error of what a decoder makes of them.
template <class F, bool kReport>
struct Encode {
  template <class K, class In, class Out, class... Report>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& words,
                              const Report&... report) const {
    RecordOut<F::kBytes, K> record(k);
    const auto clamped = FormatKernels<F>::Encode(k, in, record);
    record.Write(words);
    if constexpr (kReport) WriteReport(k, in, record.Read(), clamped, report...);
  }

 private:
  static constexpr int n = F::kOrder;
  static constexpr size_t kSize = NumCoefficients(n);

  template <class K, class In, class Record, class V, class Report>
  static GAUNT_LANES void WriteReport(const K& k, const In& in, const Record& record, V clamped,
                                      const Report& report) {
    typename K::template Slots<FormatKernels<F>::kSums> sums;
    typename K::template Slots<kPlanes<F>> decoded;
    const OneTap<K, Record> tap = {k, record};
    FormatKernels<F>::template AddTaps<true>(k, tap, kSize, sums);
    FormatKernels<F>::Finish(k, sums, kSize, SlotsOut<decltype(decoded)>{decoded});
    V energy = k(0.0), worst = k(0.0);
    for (size_t c = 0; c < kChannels; ++c) {
      V largest = k(0.0);
      for (int l = 0; l < n; ++l) {
        const double factor = evaluate::CosineBand(l);
        if (factor == 0.0) continue;  // E has no such band, even if it is infinite
        V band = k(0.0);
        for (int i = NumCoefficients(l); i < NumCoefficients(l + 1); ++i) {
          const size_t p = c * kSize + static_cast<size_t>(i);
          const V error = Sub(NumberOrZero(k, in(p)), decoded(p));
          band = MulAdd(error, error, band);
        }
        energy = MulAdd(k(factor * factor), band, energy);
        largest = MulAdd(k(Peak(l)), Sqrt(band), largest);
      }
      worst = Max(worst, largest);
    }
    report(0, Sqrt(Mul(k(1.0 / (4.0 * kPi * kChannels)), energy)));
    report(1, worst);
    report(2, clamped);
  }

  // The largest E/pi of a band of unit norm.
  static constexpr double Peak(int l) {
    const double factor = evaluate::CosineBand(l);
    return (factor < 0.0 ? -factor : factor) * ConstexprSqrt((2.0 * l + 1.0) / (4.0 * kPi));
  }

  template <class S>
  struct SlotsOut {
    S& slots;
    template <class V>
    GAUNT_LANES void operator()(size_t p, V v) const {
      slots(p, v);
    }
  };
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_PROBE_INL_H_
