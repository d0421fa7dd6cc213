// SPDX-License-Identifier: MIT
#include "chart/marks.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <hwy/targets.h>

#include <algorithm>
#include <regex>
#include <set>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

std::optional<double> Counter(const ResultRow& row, const std::string& key) {
  const auto found = row.counters.find(key);
  if (found == row.counters.end()) return std::nullopt;
  return found->second;
}

// Highway's order, in which better targets come first.
int Rank(const std::string& target) {
  for (int bit = 0; bit < 63; ++bit) {
    if (target == hwy::TargetName(int64_t{1} << bit)) return bit;
  }
  return 63;
}

}  // namespace

std::optional<MarkName> ParseMarkName(const std::string& name) {
  static const std::regex kName(
      "([a-z0-9]+)/(\\w+)/n([0-9]{1,2})/([a-z]+)/([0-9]{1,9})/([A-Za-z0-9_]+)");
  std::smatch part;
  if (!std::regex_match(name, part, kName)) return std::nullopt;
  return MarkName{part[1], part[2], part[4], part[6], std::stoi(part[3]), std::stoul(part[5])};
}

std::optional<SeriesName> ParseSeriesName(const std::string& name) {
  static const std::regex kName("([a-z0-9]+)/(\\w+)/(\\w+)/[0-9]+");
  std::smatch part;
  if (!std::regex_match(name, part, kName)) return std::nullopt;
  return SeriesName{part[1], part[2], part[3]};
}

bool Selection::Takes(const MarkName& name) const {
  return name.family == family && name.items == items && name.order >= first_order &&
         name.order <= last_order;
}

std::vector<Mark> SelectMarks(const Results& results, const Selection& selection) {
  std::vector<Mark> marks;
  for (const ResultRow& row : results.rows) {
    const std::optional<MarkName> name = ParseMarkName(row.name);
    const std::optional<double> ns = Counter(row, "ns_item");
    if (!name || !selection.Takes(*name) || row.label.empty() || !ns || *ns <= 0.0) continue;
    Mark mark = {row.label,
                 name->order,
                 name->target,
                 *ns,
                 Counter(row, "error"),
                 Counter(row, "error_rounding"),
                 Counter(row, "limit_ns"),
                 std::nullopt,
                 Counter(row, "ns_multiply")};
    const std::optional<double> mul = Counter(row, "mul"), fma = Counter(row, "fma");
    if (mul && fma && *mul + *fma > 0.0) mark.multiplies = *mul + *fma;
    // Scalar loops have neither a limit nor another layout.
    if (!mark.limit) {
      mark.target.clear();
    } else if (name->layout != selection.layout) {
      continue;
    }
    marks.push_back(mark);
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return Rank(a.target) < Rank(b.target); });
  return marks;
}

std::vector<SeriesData> SelectSeries(const Results& results, const std::string& family) {
  std::vector<SeriesData> all;
  const auto entry = [](auto& list, const auto& matches) -> auto& {
    const auto found = std::find_if(list.begin(), list.end(), matches);
    return found != list.end() ? *found : list.emplace_back();
  };
  for (const ResultRow& row : results.rows) {
    const std::optional<SeriesName> name = ParseSeriesName(row.name);
    const std::optional<double> x = Counter(row, "x"), error = Counter(row, "error");
    if (!name || name->family != family || !x || *x <= 0.0 || !error) continue;
    SeriesData& series = entry(all, [&](const SeriesData& s) { return s.name == name->series; });
    series.name = name->series;
    const std::string label = row.label.empty() ? name->line : row.label;
    SeriesLine& line = entry(series.lines, [&](const SeriesLine& l) { return l.label == label; });
    line.label = label;
    line.points.push_back({*x, *error});
  }
  for (SeriesData& series : all) {
    for (SeriesLine& line : series.lines) {
      std::sort(line.points.begin(), line.points.end(),
                [](const Point& a, const Point& b) { return a.x < b.x; });
    }
  }
  return all;
}

void CheckFamily(const std::vector<std::string>& names, const std::string& family,
                 const std::string& source) {
  std::set<std::string> families;
  for (const std::string& name : names) families.insert(name.substr(0, name.find('/')));
  if (families.count(family) > 0) return;
  throw BadInput(
      fmt::format("{} has no benchmarks of the family {}: it has {}", source, family,
                  families.empty() ? "none" : fmt::format("{}", fmt::join(families, ", "))));
}

std::vector<Point> ParetoFront(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point> front;
  for (const Point& point : points) {
    if (front.empty() || point.y < front.back().y) front.push_back(point);
  }
  return front;
}

}  // namespace gaunt::tool
