// SPDX-License-Identifier: MIT
// Which kernels each format has.
#if defined(GAUNT_PROBE_FORMATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_FORMATS_INL_H_
#undef GAUNT_PROBE_FORMATS_INL_H_
#else
#define GAUNT_PROBE_FORMATS_INL_H_
#endif

#include "probe/floats-inl.h"
#include "probe/ratios-inl.h"
#include "probe/shared-inl.h"
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

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_FORMATS_INL_H_
