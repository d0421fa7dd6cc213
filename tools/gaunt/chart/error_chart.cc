// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <map>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {
namespace {

// How methods and targets look.
struct Keys {
  std::vector<std::string> targets, methods, baselines, colours;

  explicit Keys(const std::vector<Mark>& marks) {
    std::vector<Mark> kernels, loops;
    for (const Mark& mark : marks) (mark.is_baseline() ? loops : kernels).push_back(mark);
    targets = Distinct(kernels, &Mark::target);
    methods = Distinct(kernels, &Mark::method);
    baselines = Distinct(loops, &Mark::method);
    colours = Colours(targets.size());
  }

  MarkStyle Style(const Mark& mark) const {
    if (mark.is_baseline()) return {IndexOf(baselines, mark.method), true, kGrey, 1.0};
    return {IndexOf(methods, mark.method), false, colours[IndexOf(targets, mark.target)], 1.0};
  }
};

const PathStyle kFrontStyle = {"#444444", 1.2};
const PathStyle kRoundingStyle = {"#666666", 1.0, Dash::kDotted};
PathStyle LimitStyle(const std::string& colour) { return {colour, 1.0, Dash::kDashed}; }

Legend MakeLegend(const Keys& keys, bool has_rounding) {
  Legend legend;
  legend.Heading("SIMD target");
  for (size_t k = 0; k < keys.targets.size(); ++k) {
    legend.Mark({1, false, keys.colours[k], 1.0}, keys.targets[k]);
  }
  legend.Heading("method");
  for (size_t k = 0; k < keys.methods.size(); ++k) {
    legend.Mark({k, false, kInk, 1.0}, keys.methods[k]);
  }
  for (size_t k = 0; k < keys.baselines.size(); ++k) {
    legend.Mark({k, true, kGrey, 1.0}, keys.baselines[k]);
  }
  legend.Heading("lines");
  legend.Line(kFrontStyle, "Pareto front");
  legend.Line(LimitStyle(kInk), "limit of a target");
  if (has_rounding) legend.Line(kRoundingStyle, "rounding alone");
  return legend;
}

// From the panel's top down to the first point, and right from the last.
std::vector<Point> Steps(const std::vector<Point>& front, const Axis& x, const Axis& y) {
  std::vector<Point> steps;
  double height = y.to();
  for (const Point& point : front) {
    steps.push_back({point.x, height});
    steps.push_back(point);
    height = point.y;
  }
  steps.push_back({x.to(), height});
  return steps;
}

void DrawPanel(const std::vector<Mark>& marks, const Keys& keys, Panel& panel) {
  Layer& layer = panel.layer;
  std::map<std::string, double> limits;
  std::vector<double> rounding;
  std::vector<Point> points;
  for (const Mark& mark : marks) {
    points.push_back({mark.ns, *mark.error});
    if (mark.limit) {
      const auto [limit, is_new] = limits.try_emplace(mark.target, *mark.limit);
      limit->second = std::min(limit->second, *mark.limit);
    }
    if (mark.rounding && *mark.rounding > 0.0) rounding.push_back(*mark.rounding);
  }
  for (const auto& [target, limit] : limits) {
    layer.Path({{limit, panel.y.from()}, {limit, panel.y.to()}},
               LimitStyle(keys.colours[IndexOf(keys.targets, target)]));
  }
  if (!rounding.empty()) {
    const double least = *std::min_element(rounding.begin(), rounding.end());
    layer.Path({{panel.x.from(), least}, {panel.x.to(), least}}, kRoundingStyle);
  }
  layer.Path(Steps(ParetoFront(points), panel.x, panel.y), kFrontStyle);
  // The best target last, over the others.
  for (size_t k = marks.size(); k-- > 0;) layer.Marks({points[k]}, keys.Style(marks[k]));
}

}  // namespace

Figure ErrorChart(const std::string& family, const std::string& conditions,
                  const std::vector<Mark>& marks) {
  const Keys keys(marks);
  std::vector<double> times, errors;
  bool has_rounding = false;
  for (const Mark& mark : marks) {
    times.push_back(mark.ns);
    if (mark.limit) times.push_back(*mark.limit);
    errors.push_back(*mark.error);
    if (mark.rounding && *mark.rounding > 0.0) {
      has_rounding = true;
      errors.push_back(*mark.rounding);
    }
  }
  const Axis x(times), y(errors, Axis::Format::kPowers);
  std::vector<int> orders = Distinct(marks, &Mark::order);
  std::sort(orders.begin(), orders.end());
  std::vector<Panel> panels;
  for (const int order : orders) {
    std::vector<Mark> of_order;
    for (const Mark& mark : marks) {
      if (mark.order == order) of_order.push_back(mark);
    }
    panels.push_back({fmt::format("order {}", order), {}, x, y, true, true, {}});
    DrawPanel(of_order, keys, panels.back());
  }
  return SmallMultiples(
      {family + ": time against error", conditions, "ns per item", "largest absolute error"},
      std::move(panels), MakeLegend(keys, has_rounding));
}

}  // namespace gaunt::tool
