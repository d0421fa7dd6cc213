// SPDX-License-Identifier: MIT
// Encoding of probes.
#if defined(GAUNT_PROBE_PROBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_PROBE_INL_H_
#undef GAUNT_PROBE_PROBE_INL_H_
#else
#define GAUNT_PROBE_PROBE_INL_H_
#endif

#include "probe/refine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// Coefficients to the words of records, which may then be refined; and, if wanted, the error of what
// a decoder makes of them.
template <class F, bool kRefines = false>
struct Encode {
  template <class K, class In, class Out, class... Report>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& words,
                              const Report&... report) const {
    RecordOut<F::kBytes, K> record(k);
    [[maybe_unused]] const auto clamped = FormatKernels<F>::Encode(k, in, record);
    if constexpr (kRefines) RefineRecord<F>(k, in, record);
    record.Write(words);
    (WriteReport<F>(k, in, record.Read(), clamped, report), ...);
  }
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_PROBE_INL_H_
