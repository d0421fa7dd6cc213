// SPDX-License-Identifier: MIT
// The numbers of records: where they are, and how far they go.
#ifndef GAUNT_PROBE_FIELD_H_
#define GAUNT_PROBE_FIELD_H_

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "probe/format.h"

namespace gaunt::probe {

// An integer of a record, in two's complement if `least` is negative.
struct NumberField {
  int bit, width;
  int32_t least, most;
};

struct FieldList {
  NumberField fields[64];
  size_t count;

  constexpr void Add(NumberField field) { fields[count++] = field; }
  constexpr void Add(BitField field) {
    if (field.width == 0) return;
    const auto largest = static_cast<int32_t>(field.Largest());
    Add(NumberField{field.bit, field.width, -largest, largest});
  }
};

constexpr NumberField FieldOf(Code code, int bit) {
  switch (code) {
    case Code::kSnorm8: return {bit, 8, -127, 127};
    case Code::kUnorm8: return {bit, 8, 0, 255};
    default: return {bit, 16, 0, 0x3C00};  // halves of 0 .. 1
  }
}
// Of a mean. Steps of a float's bits are those of its size.
constexpr NumberField FieldOf(Container container, int bit, size_t channel) {
  const int c = static_cast<int>(channel);
  switch (container) {
    case Container::kRgb9e5:
      return {bit + Rgb9e5::kMantissaBits * c, Rgb9e5::kMantissaBits, 0, 511};
    case Container::kHalf3: return {bit + 16 * c, 16, 0, 0x7BFF};
    default:
      return c < 2 ? NumberField{bit + 11 * c, 11, 0, 0x7BF} : NumberField{bit + 22, 10, 0, 0x3DF};
  }
}

// Means first, then ratios.
template <class F>
constexpr FieldList FieldsOf() {
  constexpr size_t kSize = size_t{F::kOrder} * F::kOrder;
  FieldList list = {};
  for (size_t c = 0; c < kChannels; ++c) {
    list.Add(FieldOf(F::kContainer, F::kContainerBit, c));
  }
  for (size_t i = 1; i < kSize; ++i) {
    if (!F::Has(i)) continue;
    if constexpr (std::is_base_of_v<SharedFormat, F>) {
      list.Add(F::Ratio(i));
      list.Add(F::Orange(i));
      list.Add(F::Green(i));
    } else {
      for (size_t c = 0; c < kChannels; ++c) list.Add(FieldOf(F::CodeOf(c, i), F::BitOf(c, i)));
    }
  }
  for (size_t c = 0; c < F::kAxials; ++c) list.Add(F::Axial(c));
  return list;
}

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_FIELD_H_
