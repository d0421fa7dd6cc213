// SPDX-License-Identifier: MIT
#include "format_name.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <iterator>

#include "bad_input.h"
#include "probe/format.h"

namespace gaunt::tool {
namespace {

struct Row {
  uint32_t format;
  const char* name;
};
constexpr Row kRows[] = {{GAUNT_FORMAT_SH3_28, "sh3_28"},
                         {GAUNT_FORMAT_SH2_13, "sh2_13"},
                         {GAUNT_FORMAT_SH3_32, "sh3_32"},
                         {GAUNT_FORMAT_SH5_55, "sh5_55"},
                         {GAUNT_FORMAT_SH3_F16, "sh3_f16"},
                         {GAUNT_FORMAT_SH3_F32, "sh3_f32"},
                         {GAUNT_FORMAT_UNREAL_28, "unreal_28"},
                         {GAUNT_FORMAT_UNITY_L1_16, "unity_l1_16"},
                         {GAUNT_FORMAT_UNITY_L2_32, "unity_l2_32"},
                         {GAUNT_FORMAT_RGB9E5, "rgb9e5"},
                         {GAUNT_FORMAT_R11G11B10F, "r11g11b10f"},
                         {GAUNT_FORMAT_SH3_LUMA_12, "sh3_luma_12"},
                         {GAUNT_FORMAT_SH3_CHROMA_16, "sh3_chroma_16"},
                         {GAUNT_FORMAT_SH3_CHROMA_21, "sh3_chroma_21"},
                         {GAUNT_FORMAT_ZH3_16, "zh3_16"},
                         {GAUNT_FORMAT_ZH3_LUMA_8, "zh3_luma_8"},
                         {GAUNT_FORMAT_GODOT_L1_32, "godot_l1_32"}};
static_assert(std::size(kRows) == probe::kNumFormats, "every format has a name");

constexpr bool InOrder() {
  for (size_t k = 0; k < std::size(kRows); ++k) {
    if (kRows[k].format != k + 1) return false;
  }
  return true;
}
static_assert(InOrder(), "rows are in the order of GAUNT_FORMAT_*");

}  // namespace

const std::vector<std::string>& FormatNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Row& row : kRows) all.emplace_back(row.name);
    return all;
  }();
  return names;
}

std::string NameOfFormat(uint32_t format) {
  return format >= 1 && format <= std::size(kRows) ? kRows[format - 1].name : "";
}

uint32_t FormatOfName(const std::string& name) {
  for (const Row& row : kRows) {
    if (name == row.name) return row.format;
  }
  throw BadInput(
      fmt::format("'{}' is no format; there are {}", name, fmt::join(FormatNames(), ", ")));
}

gaunt_format_properties PropertiesOfFormat(uint32_t format) {
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  gaunt_format_info(format, &properties);
  return properties;
}

}  // namespace gaunt::tool
