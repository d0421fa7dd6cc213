// SPDX-License-Identifier: MIT
#include <algorithm>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {

Figure SeriesChart(const std::string& family, const std::string& conditions,
                   const SeriesData& series) {
  constexpr double kLabels = 262, kApart = 17;
  std::vector<double> steps, errors;
  for (const SeriesLine& line : series.lines) {
    for (const Point& point : line.points) {
      steps.push_back(point.x);
      errors.push_back(point.y);
    }
  }
  Figure figure;
  figure.height = 460;
  Panel panel = {"",          {66, 90, figure.width - 66 - kLabels, 320},
                 Axis(steps), Axis(errors, Axis::Format::kPowers),
                 true,        true,
                 {}};
  // Labels beside the ends of their lines, no closer than they are high; from the top.
  const std::vector<std::string> colours = Colours(series.lines.size());
  const auto height = [&](const SeriesLine& line) {
    return panel.place.top + panel.place.height * (1.0 - panel.y.Share(line.points.back().y));
  };
  std::vector<size_t> order(series.lines.size());
  for (size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return height(series.lines[a]) < height(series.lines[b]); });
  double free = 0.0;
  for (const size_t k : order) {
    const SeriesLine& line = series.lines[k];
    const MarkStyle mark = {k, false, colours[k], 1.0};
    panel.layer.Path(line.points, {colours[k], 2.0});
    panel.layer.Marks(line.points, mark);
    const double y = std::max(height(line), free);
    const double x = panel.place.left + panel.place.width + 14;
    figure.page.Marks({{x, y}}, mark);
    figure.page.Text({x + 12, y}, line.label, {});
    free = y + kApart;
  }
  figure.panels.push_back(std::move(panel));
  DrawTitles({family + ": " + series.name, conditions, "steps", "relative error"}, figure);
  return figure;
}

}  // namespace gaunt::tool
