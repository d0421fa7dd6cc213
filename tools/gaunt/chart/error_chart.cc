// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {
namespace {

constexpr Dash kFrontDashes[] = {Dash::kSolid, Dash::kDashed, Dash::kDashedDotted};
const PathStyle kRoundingStyle = {"#666666", 1.0, Dash::kDotted};

// What is compared with one another.
struct Job {
  std::string name;
  std::vector<std::string> kernels, loops;  // methods
  size_t first_shape;
  PathStyle front;
};

std::vector<Job> FindJobs(const std::vector<Mark>& marks) {
  std::vector<Job> jobs;
  size_t shape = 0;
  for (const std::string& name : Distinct(marks, &Mark::job)) {
    std::vector<Mark> kernels, loops;
    for (const Mark& mark : marks) {
      if (mark.job == name) (mark.is_baseline() ? loops : kernels).push_back(mark);
    }
    const Dash dash = kFrontDashes[jobs.size() % std::size(kFrontDashes)];
    jobs.push_back({name,
                    Distinct(kernels, &Mark::method),
                    Distinct(loops, &Mark::method),
                    shape,
                    {"#444444", 1.2, dash}});
    // Scalar loops are the hollow shapes of their job.
    shape += std::max(jobs.back().kernels.size(), jobs.back().loops.size());
  }
  return jobs;
}

MarkStyle KernelStyle(const Job& job, const std::string& method, const std::string& colour) {
  return {job.first_shape + IndexOf(job.kernels, method), false, colour, 1.0};
}
MarkStyle LoopStyle(const Job& job, const std::string& method) {
  return {job.first_shape + IndexOf(job.loops, method), true, kGrey, 1.0};
}

Legend MakeLegend(const std::vector<Mark>& marks, const std::vector<Job>& jobs) {
  Legend legend;
  const std::vector<std::string> targets = Targets(marks);
  if (!targets.empty()) legend.Heading("SIMD target");
  for (const std::string& target : targets) legend.Swatch(TargetColour(target), target);
  for (const Job& job : jobs) {
    legend.Heading(job.name);
    for (const std::string& method : job.kernels) {
      legend.Mark(KernelStyle(job, method, kInk), method);
    }
    for (const std::string& method : job.loops) legend.Mark(LoopStyle(job, method), method);
    if (!job.kernels.empty()) legend.Line(job.front, "Pareto front");
  }
  const auto any = [&](std::optional<double> Mark::*member) {
    return std::any_of(marks.begin(), marks.end(),
                       [&](const Mark& mark) { return !mark.is_baseline() && mark.*member; });
  };
  if (any(&Mark::limit) || any(&Mark::rounding)) legend.Heading("bounds");
  if (any(&Mark::limit)) legend.Whisker(kInk, "to the machine's limit");
  if (any(&Mark::rounding)) legend.Line(kRoundingStyle, "rounding alone");
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

// The later of marks that coincide are smaller, so that all of them show.
double Size(const std::vector<Point>& before, const Point& point, const Panel& panel) {
  constexpr double kWidth = 200, kHeight = 250, kClose = 4;  // about, in pixels
  double size = 1.0;
  for (const Point& other : before) {
    const double x = kWidth * (panel.x.Share(point.x) - panel.x.Share(other.x));
    const double y = kHeight * (panel.y.Share(point.y) - panel.y.Share(other.y));
    if (std::hypot(x, y) < kClose) size = std::max(0.35, 0.65 * size);
  }
  return size;
}

void DrawPanel(const std::vector<Mark>& marks, const std::vector<Job>& jobs, Panel& panel) {
  Layer& layer = panel.layer;
  std::optional<double> rounding;
  for (const Mark& mark : marks) {
    if (mark.rounding) rounding = std::min(rounding.value_or(*mark.rounding), *mark.rounding);
  }
  if (rounding) {
    layer.Path({{panel.x.from(), *rounding}, {panel.x.to(), *rounding}}, kRoundingStyle);
  }
  for (const Job& job : jobs) {
    std::vector<Point> points;
    bool has_kernel = false;
    for (const Mark& mark : marks) {
      if (mark.job != job.name) continue;
      points.push_back({mark.ns, *mark.error});
      has_kernel |= !mark.is_baseline();
    }
    if (has_kernel) layer.Path(Steps(ParetoFront(points), panel.x, panel.y), job.front);
  }
  for (const Mark& mark : marks) {
    if (mark.is_baseline() || !mark.limit) continue;
    const PathStyle style = {TargetColour(mark.target), kWhiskerWidth};
    const double y = *mark.error;
    layer.Path({{*mark.limit, y}, {mark.ns, y}}, style);
    layer.Path({{*mark.limit, panel.y.Moved(y, -0.018)}, {*mark.limit, panel.y.Moved(y, 0.018)}},
               style);
  }
  // The best target last, over the others.
  std::vector<Point> drawn;
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const Job& job = *std::find_if(jobs.begin(), jobs.end(), [&](const Job& candidate) {
      return candidate.name == mark->job;
    });
    MarkStyle style = mark->is_baseline()
                          ? LoopStyle(job, mark->method)
                          : KernelStyle(job, mark->method, TargetColour(mark->target));
    const Point point = {mark->ns, *mark->error};
    style.size = Size(drawn, point, panel);
    layer.Marks({point}, style);
    drawn.push_back(point);
  }
}

}  // namespace

Figure ErrorChart(const std::string& family, const std::string& conditions,
                  const std::vector<Mark>& marks) {
  const std::vector<Job> jobs = FindJobs(marks);
  std::vector<double> times, errors;
  for (const Mark& mark : marks) {
    times.push_back(mark.ns);
    if (mark.limit) times.push_back(*mark.limit);
    errors.push_back(*mark.error);
    if (mark.rounding) errors.push_back(*mark.rounding);
  }
  const Axis x(times), y(errors, Axis::Format::kPowers);
  std::vector<Panel> panels;
  for (const int order : Distinct(marks, &Mark::order)) {
    std::vector<Mark> of_order;
    for (const Mark& mark : marks) {
      if (mark.order == order) of_order.push_back(mark);
    }
    panels.push_back({fmt::format("order {}", order), {}, x, y, true, true, {}});
    DrawPanel(of_order, jobs, panels.back());
  }
  return SmallMultiples(
      {family + ": time against error", conditions, "ns per item", "largest absolute error"},
      std::move(panels), MakeLegend(marks, jobs));
}

}  // namespace gaunt::tool
