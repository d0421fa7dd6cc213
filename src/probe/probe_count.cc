// SPDX-License-Identifier: MIT
// Operations of the probe kernels, by running them on counting lanes.
#include "probe/probe-inl.h"
#include "simd/count.h"

namespace gaunt::probe {

void AppendOperations(OperationRows& rows);

namespace {

// Twin of RecordLanes: what makes floats of words, and words of floats, counts as nothing.
struct CountRecordLanes : CountLanes {
  template <int, int>
  Counted Unsigned(Counted) const {
    return {};
  }
  template <int, int>
  Counted Signed(Counted) const {
    return {};
  }
  template <int>
  Counted SignedByte(Counted) const {
    return {};
  }
  template <int>
  Counted TinyHalf(Counted) const {
    return {};
  }
  template <int, int>
  Counted TinyFloat(Counted) const {
    return {};
  }
  template <int, int>
  Counted Power(Counted) const {
    return {};
  }
  Counted FlipSigns(Counted) const { return {}; }
  Counted PowerOfTwo(Counted) const { return {}; }
  template <int>
  Counted Exponent(Counted) const {
    return {};
  }
  template <int>
  Counted Integer(Counted) const {
    return {};
  }
  template <int>
  Counted SmallFloatBits(Counted v) const {
    return Add(v, v);
  }
  Counted HalfBits(Counted v) const { return SmallFloatBits<10>(v); }
  Counted AddToField(Counted, int, int, int32_t, int32_t, int32_t) const { return {}; }
  template <int>
  Counted Left(Counted) const {
    return {};
  }
  Counted Or(Counted, Counted) const { return {}; }
};

template <class F>
struct CountTaps {
  static constexpr size_t kMost = 8;
  size_t count;
  auto Record(size_t) const {
    return HWY_NAMESPACE::RecordIn<HWY_NAMESPACE::LoadedWords<F::kBytes>, CountPlanes>{{}};
  }
  Counted Weight(size_t) const { return {}; }
};

template <class F, bool kDecodes>
Operations CountBlend(size_t taps) {
  using Kernels = HWY_NAMESPACE::FormatKernels<F>;
  const CountRecordLanes k;
  const size_t size = NumCoefficients(F::kOrder);
  CountRecordLanes::Slots<1> sums;
  CountedOperations() = Operations();
  Kernels::template AddTaps<kDecodes>(k, CountTaps<F>{taps}, size, sums);
  Kernels::Finish(k, sums, size, CountPlanes());
  return CountedOperations();
}

template <class F>
void AppendFormat(OperationRows& rows, const char* name) {
  const std::string order = std::to_string(F::kOrder);
  const auto append = [&](const char* op, const char* variant, const Operations& operations) {
    rows.push_back({op, order, name + std::string(variant), operations});
  };
  append("probe_gather", "_4_taps", CountBlend<F, false>(4));
  append("probe_gather", "_8_taps", CountBlend<F, false>(8));
  append("probe_decode", "", CountBlend<F, true>(1));
  const CountPlanes planes;
  const CountRecordLanes k;
  CountedOperations() = Operations();
  HWY_NAMESPACE::Encode<F>()(k, planes, planes, planes);
  append("probe_encode", "", CountedOperations());
  HWY_NAMESPACE::Report<F>()(k, planes, planes, planes, planes);
  append("probe_encode", "_report", CountedOperations());
  if constexpr (HWY_NAMESPACE::kCanRefine<F>) {
    CountedOperations() = Operations();
    HWY_NAMESPACE::Encode<F>()(k, planes, planes, planes);
    HWY_NAMESPACE::Refine<F>()(k, planes, planes, planes);
    append("probe_encode_refined", "", CountedOperations());
  }
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  AppendFormat<Sh3At28>(rows, "sh3_28");
  AppendFormat<Sh2At13>(rows, "sh2_13");
  AppendFormat<Sh3At32>(rows, "sh3_32");
  AppendFormat<Sh5At55>(rows, "sh5_55");
  AppendFormat<HalfAt54>(rows, "sh3_f16");
  AppendFormat<FloatAt108>(rows, "sh3_f32");
  AppendFormat<UnrealAt28>(rows, "unreal_28");
  AppendFormat<UnityAt16>(rows, "unity_l1_16");
  AppendFormat<UnityAt32>(rows, "unity_l2_32");
  AppendFormat<Rgb9e5At4>(rows, "rgb9e5");
  AppendFormat<R11g11b10At4>(rows, "r11g11b10f");
  AppendFormat<LumaAt12>(rows, "sh3_luma_12");
  AppendFormat<ChromaAt16>(rows, "sh3_chroma_16");
  AppendFormat<ChromaAt21>(rows, "sh3_chroma_21");
  AppendFormat<Zh3At16>(rows, "zh3_16");
  AppendFormat<Zh3LumaAt8>(rows, "zh3_luma_8");
  AppendFormat<GodotAt32>(rows, "godot_l1_32");
}

}  // namespace gaunt::probe
