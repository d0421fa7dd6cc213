// SPDX-License-Identifier: MIT
#include "format_name.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <iterator>

#include "bad_input.h"
#include "format_table.h"
#include "probe/format.h"

namespace gaunt::tool {
namespace {

static_assert(std::size(kFormatNames) == probe::kNumFormats, "every format has a name");

constexpr bool InOrder() {
  for (size_t k = 0; k < std::size(kFormatNames); ++k) {
    if (kFormatNames[k].format != k + 1) return false;
  }
  return true;
}
static_assert(InOrder(), "rows are in the order of GAUNT_FORMAT_*");

}  // namespace

const std::vector<std::string>& FormatNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const FormatName& row : kFormatNames) all.emplace_back(row.name);
    return all;
  }();
  return names;
}

std::string NameOfFormat(uint32_t format) {
  return format >= 1 && format <= std::size(kFormatNames) ? kFormatNames[format - 1].name : "";
}

uint32_t FormatOfName(const std::string& name) {
  for (const FormatName& row : kFormatNames) {
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
