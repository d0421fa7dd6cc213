// SPDX-License-Identifier: MIT
#include "chart/marks.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

// Of what a logarithmic axis can show: nothing else is a time or an error.
std::optional<double> Counter(const ResultRow& row, const std::string& key) {
  const auto found = row.counters.find(key);
  if (found == row.counters.end() || !(found->second >= 1e-30 && found->second <= 1e30)) {
    return std::nullopt;
  }
  return found->second;
}

std::vector<std::string> Split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) c == at ? void(parts.emplace_back()) : parts.back().push_back(c);
  return parts;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLower(char c) { return c >= 'a' && c <= 'z'; }
bool IsFamily(char c) { return IsLower(c) || IsDigit(c); }
bool IsWord(char c) { return IsFamily(c) || (c >= 'A' && c <= 'Z') || c == '_'; }

bool IsAll(const std::string& text, bool (*is)(char)) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is);
}
bool IsNumber(const std::string& text, size_t digits) {
  return text.size() <= digits && IsAll(text, IsDigit);
}

// "first: rest"; a text without it is both.
std::pair<std::string, std::string> SplitLabel(const std::string& text) {
  const size_t colon = text.find(": ");
  if (colon == std::string::npos) return {text, text};
  return {text.substr(0, colon), text.substr(colon + 2)};
}

}  // namespace

std::optional<MarkName> ParseMarkName(const std::string& name) {
  const std::vector<std::string> part = Split(name, '/');
  if (part.size() != 6 || !IsAll(part[0], IsFamily) || !IsAll(part[1], IsWord) || part[2].empty() ||
      part[2][0] != 'n' || !IsNumber(part[2].substr(1), 2) || !IsAll(part[3], IsLower) ||
      !IsNumber(part[4], 9) || !IsAll(part[5], IsWord)) {
    return std::nullopt;
  }
  return MarkName{
      part[0], part[1], part[3], part[5], std::stoi(part[2].substr(1)), std::stoul(part[4])};
}

std::optional<SeriesName> ParseSeriesName(const std::string& name) {
  const std::vector<std::string> part = Split(name, '/');
  if (part.size() != 4 || !IsAll(part[0], IsFamily) || !IsAll(part[1], IsWord) ||
      !IsAll(part[2], IsWord) || !IsAll(part[3], IsDigit)) {
    return std::nullopt;
  }
  return SeriesName{part[0], part[1], part[2]};
}

bool Selection::Takes(const MarkName& name) const {
  return name.family == family && name.items == items && name.order >= first_order &&
         name.order <= last_order && (name.is_baseline() || name.layout == layout);
}

void CheckSelection(const std::vector<MarkName>& kernels, const Selection& selection) {
  std::map<std::string, std::set<size_t>> sizes;
  std::set<int> orders;
  for (const MarkName& name : kernels) {
    if (selection.Takes(name)) return;
    sizes[name.layout].insert(name.items);
    orders.insert(name.order);
  }
  if (kernels.empty()) return;
  std::vector<std::string> there;
  for (const auto& [layout, items] : sizes) {
    there.push_back(fmt::format("{} with {} items", layout, fmt::join(items, ", ")));
  }
  throw BadInput(
      fmt::format("no kernel of {} is {} with {} items and of orders {} to {}: there are {}, of "
                  "orders {} to {}",
                  selection.family, selection.layout, selection.items, selection.first_order,
                  selection.last_order, fmt::join(there, "; "), *orders.begin(), *orders.rbegin()));
}

std::vector<Mark> SelectMarks(const Results& results, const Selection& selection) {
  std::vector<Mark> marks;
  std::vector<MarkName> kernels;
  for (const ResultRow& row : results.rows) {
    const std::optional<MarkName> name = ParseMarkName(row.name);
    if (!name || name->family != selection.family || row.label.empty()) continue;
    if (!name->is_baseline()) kernels.push_back(*name);
    const std::optional<double> ns = Counter(row, "ns_item");
    if (!selection.Takes(*name) || !ns) continue;
    const auto [job, method] = SplitLabel(row.label);
    Mark mark = {row.label,
                 job,
                 method,
                 name->order,
                 name->is_baseline() ? "" : name->target,
                 *ns,
                 Counter(row, "error"),
                 Counter(row, "error_rounding"),
                 Counter(row, "limit_ns"),
                 std::nullopt,
                 Counter(row, "ns_multiply")};
    const double multiplies = Counter(row, "mul").value_or(0) + Counter(row, "fma").value_or(0);
    if (multiplies > 0.0 && !name->is_baseline()) mark.multiplies = multiplies;
    marks.push_back(mark);
  }
  CheckSelection(kernels, selection);
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
    if (a.is_baseline() != b.is_baseline()) return b.is_baseline();
    if (a.target != b.target) return TargetBefore(a.target, b.target);
    return std::tie(a.label, a.order, a.ns) < std::tie(b.label, b.order, b.ns);
  });
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
    if (!name || name->family != family || !x || !error) continue;
    SeriesData& series = entry(all, [&](const SeriesData& s) { return s.name == name->series; });
    series.name = name->series;
    const std::string label = row.label.empty() ? name->line : row.label;
    SeriesLine& line = entry(series.lines, [&](const SeriesLine& l) { return l.label == label; });
    line.label = label;
    line.points.push_back({*x, *error});
  }
  for (SeriesData& series : all) {
    const auto described = results.descriptions.find(family + "/" + series.name);
    series.title = series.name;
    const auto steps = results.steps.find(family + "/" + series.name);
    series.steps = steps != results.steps.end() ? steps->second : "steps";
    if (described != results.descriptions.end()) {
      std::tie(series.title, series.conditions) = SplitLabel(described->second);
    }
    std::sort(series.lines.begin(), series.lines.end(),
              [](const SeriesLine& a, const SeriesLine& b) { return a.label < b.label; });
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
