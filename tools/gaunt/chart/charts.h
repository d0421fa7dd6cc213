// SPDX-License-Identifier: MIT
// The pictures of a family.
#ifndef GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_
#define GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_

#include <string>
#include <vector>

#include "chart/figure.h"
#include "chart/marks.h"

namespace gaunt::tool {

// Time against error, a panel for each order. Of marks that have an error.
Figure ErrorChart(const std::string& family, const std::string& conditions,
                  const std::vector<Mark>& marks);

// Time against multiplications, a panel for each method. Of marks that have them.
Figure OperationsChart(const std::string& family, const std::string& conditions,
                       const std::vector<Mark>& marks);

// Error against steps.
Figure SeriesChart(const std::string& family, const std::string& conditions,
                   const SeriesData& series);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_
