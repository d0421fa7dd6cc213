// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <map>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {
namespace {

PathStyle RateStyle(const std::string& colour) { return {colour, 1.0, Dash::kDashed}; }

Legend MakeLegend(const std::vector<std::string>& targets) {
  Legend legend;
  legend.Heading("SIMD target");
  for (const std::string& target : targets) legend.Swatch(TargetColour(target), target);
  legend.Heading("lines");
  legend.Line({kInk, 1.4}, "measured, order beside");
  legend.Line(RateStyle(kInk), "at the pipes' rate");
  return legend;
}

}  // namespace

Figure OperationsChart(const std::string& family, const std::string& conditions,
                       const std::vector<Mark>& marks) {
  const std::vector<std::string> targets = Targets(marks);
  std::vector<double> multiplies, times;
  for (const Mark& mark : marks) {
    multiplies.push_back(*mark.multiplies);
    times.push_back(mark.ns);
    times.push_back(mark.ns * 2.0);  // room for labels
    if (mark.ns_multiply) times.push_back(*mark.multiplies * *mark.ns_multiply);
  }
  const Axis x(multiplies), y(times);
  std::vector<Panel> panels;
  for (const std::string& label : Distinct(marks, &Mark::label)) {
    Panel panel = {label, {}, x, y, true, true, {}};
    std::map<double, std::pair<double, int>> tops;  // the slowest and its order, by multiplications
    for (size_t k = targets.size(); k-- > 0;) {
      const std::string colour = TargetColour(targets[k]);
      std::vector<Point> points;
      double rate = 0.0;
      for (const Mark& mark : marks) {
        if (mark.label != label || mark.target != targets[k]) continue;
        points.push_back({*mark.multiplies, mark.ns});
        rate = mark.ns_multiply.value_or(0.0);
        std::pair<double, int>& top = tops[*mark.multiplies];
        top = std::max(top, {mark.ns, mark.order});
      }
      std::sort(points.begin(), points.end(),
                [](const Point& a, const Point& b) { return a.x < b.x; });
      if (rate > 0.0) {
        panel.layer.Path({{x.from(), x.from() * rate}, {x.to(), x.to() * rate}}, RateStyle(colour));
      }
      panel.layer.Path(points, {colour, 1.4});
      panel.layer.Marks(points, {0, false, colour, 0.7});
    }
    for (const auto& [at, top] : tops) {
      panel.layer.Text({at, y.Moved(top.first, 0.055)}, std::to_string(top.second),
                       {kInk, 11, Align::kCentre});
    }
    panels.push_back(std::move(panel));
  }
  return SmallMultiples({family + ": time against operations", conditions,
                         "multiplications and fused multiply-adds per item", "ns per item"},
                        std::move(panels), MakeLegend(targets));
}

}  // namespace gaunt::tool
