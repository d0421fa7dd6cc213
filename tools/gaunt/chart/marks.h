// SPDX-License-Identifier: MIT
// What a family's rows say, ready to be drawn.
#ifndef GAUNT_TOOLS_GAUNT_CHART_MARKS_H_
#define GAUNT_TOOLS_GAUNT_CHART_MARKS_H_

#include <optional>
#include <string>
#include <vector>

#include "chart/results.h"
#include "chart/targets.h"

namespace gaunt::tool {

// family/op/n<order>/<layout>/<items>/<target or baseline>
struct MarkName {
  std::string family, op, layout, target;
  int order;
  size_t items;

  bool is_baseline() const { return !IsTarget(target); }
};
std::optional<MarkName> ParseMarkName(const std::string& name);

// family/<series>/<line>/<steps>
struct SeriesName {
  std::string family, series, line;
};
std::optional<SeriesName> ParseSeriesName(const std::string& name);

// The timings to draw.
struct Selection {
  std::string family;
  std::string layout = "tiled";
  size_t items = 1024;
  int first_order = 2, last_order = 8;

  // Kernels in the layout; scalar loops have only one.
  bool Takes(const MarkName& name) const;
};

// A method at an order on a target, or a scalar loop.
struct Mark {
  std::string label;   // "job: method", or its only method alone
  std::string job;     // marks of a job can be compared
  std::string method;  // in words
  int order;
  std::string target;  // empty: a baseline
  double ns;           // per item
  std::optional<double> error;
  std::optional<double> rounding;     // error of rounding alone
  std::optional<double> limit;        // ns, of the machine
  std::optional<double> multiplies;   // multiplications and fused multiply-adds
  std::optional<double> ns_multiply;  // at the rate of the machine's pipes

  bool is_baseline() const { return target.empty(); }
};

// Those of the selection that have a method's name: kernels in the layout, and the scalar loops.
// Best targets first, then by label and order. Throws BadInput if the family has kernels, but none
// of the selection.
std::vector<Mark> SelectMarks(const Results& results, const Selection& selection);

struct Point {
  double x, y;
};

struct SeriesLine {
  std::string label;
  std::vector<Point> points;
};
struct SeriesData {
  std::string name;
  std::vector<SeriesLine> lines;  // by label
  std::string title, conditions;  // in words
  std::string steps = "steps";    // what they are
};
std::vector<SeriesData> SelectSeries(const Results& results, const std::string& family);

// Throws BadInput if no benchmark of `source` is of the family.
void CheckFamily(const std::vector<std::string>& names, const std::string& family,
                 const std::string& source);

// Throws BadInput with the layouts and sizes that there are, if none of the kernels is selected.
void CheckSelection(const std::vector<MarkName>& kernels, const Selection& selection);

// The points than which none is better in both, by rising x.
std::vector<Point> ParetoFront(std::vector<Point> points);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_MARKS_H_
