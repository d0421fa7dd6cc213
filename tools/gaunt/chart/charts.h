// SPDX-License-Identifier: MIT
// The pictures of a family.
#ifndef GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_
#define GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_

#include <optional>
#include <string>
#include <vector>

#include "chart/figure.h"
#include "chart/marks.h"
#include "simd/count.h"

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

// Multiplications by order that others have published.
struct PublishedCounts {
  std::string label;
  std::vector<std::string> sources;
  std::vector<Point> points;
};
std::optional<PublishedCounts> PublishedOf(const std::string& family);

// Multiplications and fused multiply-adds by order: a line for each variant of a family's main
// operation, and for some of its others. None of a family without such a picture, or whose main
// operation has fewer than two variants over several orders.
std::vector<SeriesLine> SelectGrowth(const OperationRows& rows, const std::string& family);

// Of a power through the points whose x is at least `from`: least squares of the logarithms. None
// of fewer than two.
std::optional<double> GrowthExponent(const std::vector<Point>& points, double from);

// Multiplications against order, with exponents of growth. Of lines that have points.
Figure GrowthChart(const std::string& family, const std::vector<SeriesLine>& lines,
                   const std::optional<PublishedCounts>& published);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_CHARTS_H_
