// SPDX-License-Identifier: MIT
// What packed formats lose against what they take.
#ifndef GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_CHART_H_
#define GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_CHART_H_

#include <cstdint>
#include <string>
#include <vector>

#include "chart/figure.h"

namespace gaunt::tool {

// A format, or the coefficients of an order as they are, which take no bytes here.
struct FormatMark {
  std::string name;
  uint32_t bytes;
  uint32_t order;
  double rms;  // mean, relative
};

// Error against bytes, in logarithms.
Figure FormatChart(const std::string& conditions, const std::vector<FormatMark>& marks);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FORMATS_FORMAT_CHART_H_
