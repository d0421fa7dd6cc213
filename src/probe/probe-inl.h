// SPDX-License-Identifier: MIT
// Encoding of probes, and its errors.
#if defined(GAUNT_PROBE_PROBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_PROBE_INL_H_
#undef GAUNT_PROBE_PROBE_INL_H_
#else
#define GAUNT_PROBE_PROBE_INL_H_
#endif

#include "probe/refine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// The three steps of encoding are kernels of their own: each is compiled once for a format.

// Coefficients to the words of records, and how many numbers their ranges cut off.
template <class F>
struct Encode {
  template <class K, class In, class Words, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Words& words,
                              const Out& clamped) const {
    RecordOut<F::kBytes, K> record(k);
    clamped(0, FormatKernels<F>::Encode(k, in, record));
    record.Write(words);
  }
};

template <class F>
struct Refine {
  template <class K, class In, class InWords, class OutWords>
  GAUNT_LANES void operator()(const K& k, const In& in, const InWords& from,
                              const OutWords& to) const {
    RecordOut<F::kBytes, K> record(k);
    record.Load(from);
    RefineRecord<F>(k, in, record);
    record.Write(to);
  }
};

// The error of what a decoder makes of them.
template <class F>
struct Report {
  template <class K, class In, class InWords, class InClamped, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const InWords& words,
                              const InClamped& clamped, const Out& report) const {
    RecordOut<F::kBytes, K> record(k);
    record.Load(words);
    WriteReport<F>(k, in, record.Read(), clamped(0), report);
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_PROBE_INL_H_
