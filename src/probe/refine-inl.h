// SPDX-License-Identifier: MIT
// Refinement of encoded records: their numbers are changed one by one, where that brings the
// irradiance closer to that of the light.
#if defined(GAUNT_PROBE_REFINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_REFINE_INL_H_
#undef GAUNT_PROBE_REFINE_INL_H_
#else
#define GAUNT_PROBE_REFINE_INL_H_
#endif

#include "probe/field.h"
#include "probe/report-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

// Of floats, no others are closer.
template <class F>
inline constexpr bool kCanRefine = true;
template <>
inline constexpr bool kCanRefine<HalfAt54> = false;
template <>
inline constexpr bool kCanRefine<FloatAt108> = false;

// What is added to each number, one after the other: first far, since those of ZH3 turn its axis.
inline constexpr int kRefineSteps[] = {8, -8, 4, -4, 2, -2, 1, -1, 1, -1};

template <class F, class K, class In, class Record>
HWY_NOINLINE void RefineRecord(const K& k, const In& in, Record& record) {
  using V = typename K::V;
  static constexpr FieldList kFields = FieldsOf<F>();
  typename K::template Slots<kPlanes<F>> decoded;
  DecodeRecord<F>(k, record.Read(), decoded);
  const V per_size = Div(k(1.0), SizeOfLight<F>(k, in));
  V energy = ErrorEnergy<F>(k, in, decoded, per_size);
  for (const int step : kRefineSteps) {
    for (size_t f = 0; f < kFields.count; ++f) {
      const NumberField& field = kFields.fields[f];
      const auto word = static_cast<size_t>(field.bit / 32);
      const V old = record.Word(word);
      const V changed =
          k.AddToField(old, field.bit % 32, field.width, field.least, field.most, step);
      record.SetWord(word, changed);
      DecodeRecord<F>(k, record.Read(), decoded);
      const V other = ErrorEnergy<F>(k, in, decoded, per_size);
      const auto better = Lt(other, energy);
      energy = IfThenElse(better, other, energy);
      record.SetWord(word, IfThenElse(better, changed, old));
    }
  }
}

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_REFINE_INL_H_
