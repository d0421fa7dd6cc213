// SPDX-License-Identifier: MIT
// Kernels that apply the rows of a conversion.
#if defined(GAUNT_CONVERT_CONVERT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_CONVERT_CONVERT_INL_H_
#undef GAUNT_CONVERT_CONVERT_INL_H_
#else
#define GAUNT_CONVERT_CONVERT_INL_H_
#endif

#include "convert/plan.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::convert::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Planes that only move and change sign.
struct MoveRow {
  template <class K, class In, class Out>
  static GAUNT_LANES void Run(const K&, const Plan& plan, int row, const In& in, const Out& out) {
    const auto value = in(plan.source[row]);
    out(static_cast<size_t>(row), plan.factor[row] < 0.0 ? Neg(value) : value);
  }
};

// Sums of planes times factors, in double precision: they round once, to the result.
struct SumRow {
  template <class K, class In, class Out>
  static GAUNT_LANES void Run(const K& k, const Plan& plan, int row, const In& in, const Out& out) {
    const int begin = plan.begin[row];
    k.WideSum(in, plan.source + begin, plan.factor + begin, plan.begin[row + 1] - begin,
              row == 0 ? plan.constant : 0.0, out, static_cast<size_t>(row));
  }
};

// Some bands of each channel, whose planes begin `stride` apart. A band is read in full before it
// is written, from a copy where it must be, so that it can be converted in place.
template <class Row>
struct Bands {
  const Plan* plan;
  size_t channels;
  size_t stride;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    typename K::template Slots<Plan::kMaxRows> copy;
    for (size_t c = 0; c < channels; ++c) {
      const In channel = in.From(c * stride);
      const Out result = out.From(c * stride);
      int row = 0;
      for (int l = plan->first_band; l < plan->end_band; ++l) {
        const In band = channel.From(static_cast<size_t>(row));
        const int end = row + 2 * l + 1;
        if (plan->staged) {
          for (int p = 0; p <= 2 * l; ++p) {
            copy(static_cast<size_t>(p), band(static_cast<size_t>(p)));
          }
          for (; row < end; ++row) Row::Run(k, *plan, row, copy.Planes(), result);
        } else {
          for (; row < end; ++row) Row::Run(k, *plan, row, band, result);
        }
      }
    }
  }
};

}  // namespace gaunt::convert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_CONVERT_CONVERT_INL_H_
