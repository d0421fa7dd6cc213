// SPDX-License-Identifier: MIT
#include <algorithm>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {

Figure SeriesChart(const std::string& family, const std::string& conditions,
                   const SeriesData& series) {
  constexpr double kLabels = 290, kApart = 17;
  std::vector<double> steps, errors;
  for (const SeriesLine& line : series.lines) {
    for (const Point& point : line.points) {
      steps.push_back(point.x);
      errors.push_back(point.y);
    }
  }
  Figure figure;
  const double high = std::max(320.0, kApart * static_cast<double>(series.lines.size()));
  figure.height = high + 140;
  Panel panel = {"",
                 {66, 90, figure.width - 66 - kLabels, high},
                 Axis(steps, Axis::Format::kSteps),
                 Axis(errors, Axis::Format::kPowers),
                 true,
                 true,
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
  std::vector<double> at;
  for (const size_t k : order) {
    at.push_back(std::max(height(series.lines[k]), at.empty() ? 0.0 : at.back() + kApart));
  }
  double floor = panel.place.top + panel.place.height;
  for (size_t i = at.size(); i-- > 0; floor = at[i] - kApart) at[i] = std::min(at[i], floor);
  const double left = panel.place.left + panel.place.width + 14;
  for (size_t i = 0; i < order.size(); ++i) {
    const SeriesLine& line = series.lines[order[i]];
    const MarkStyle mark = {order[i], false, colours[order[i]], 1.0};
    panel.layer.Path(line.points, {mark.colour, 2.0});
    panel.layer.Marks(line.points, mark);
    figure.page.Marks({{left, at[i]}}, mark);
    figure.page.Text({left + 12, at[i]}, Shortened(line.label, figure.width - left - 14, 12), {});
  }
  figure.panels.push_back(std::move(panel));
  DrawTitles({family + ": " + series.title,
              series.conditions.empty() ? conditions : conditions + " · " + series.conditions,
              series.steps, "relative error"},
             figure);
  return figure;
}

}  // namespace gaunt::tool
