// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "chart/charts.h"
#include "chart/page.h"

namespace gaunt::tool {
namespace {

constexpr int kFirstOrder = 2, kLastOrder = 10;
constexpr int kFirstFitted = 4;  // below it, what grows slowest is much of the count

// What a family's picture has beside every variant of the operation of its name.
struct Family {
  std::string name;
  std::vector<std::pair<std::string, std::string>> beside;  // operations and their variants
  std::optional<PublishedCounts> published;
};

const std::vector<Family>& Families() {
  static const std::vector<Family> families = {
      {"product",
       {{"product_square", "fast"}, {"product_prepared", "fast"}, {"product_zonal", "mono"}},
       PublishedCounts{
           "factored products",
           {"Snyder, MSR-TR-2006-53, as printed", "order 7: README of sjb3d/sh_product"},
           {{2, 20}, {3, 120}, {4, 399}, {5, 1135}, {6, 2527}, {7, 5351}}}}};
  return families;
}

// Of a plain number; mixed orders have none.
std::optional<int> PlainOrder(const std::string& text) {
  int order = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, order);
  if (error != std::errc() || stop != end) return std::nullopt;
  return order;
}

std::string WithExponent(const std::string& label, const std::vector<Point>& points) {
  const std::optional<double> exponent = GrowthExponent(points, kFirstFitted);
  return exponent ? fmt::format("{}: n^{:.1f}", label, *exponent) : label;
}

}  // namespace

std::optional<PublishedCounts> PublishedOf(const std::string& family) {
  for (const Family& known : Families()) {
    if (known.name == family) return known.published;
  }
  return std::nullopt;
}

std::vector<SeriesLine> SelectGrowth(const OperationRows& rows, const std::string& family) {
  const auto known =
      std::find_if(Families().begin(), Families().end(),
                   [&](const Family& candidate) { return candidate.name == family; });
  if (known == Families().end()) return {};
  std::vector<std::pair<std::string, std::string>> wanted;
  for (const OperationRow& row : rows) {
    const std::pair<std::string, std::string> variant = {row.op, row.variant};
    if (row.op == family && IndexOf(wanted, variant) == wanted.size()) wanted.push_back(variant);
  }
  wanted.insert(wanted.end(), known->beside.begin(), known->beside.end());
  std::vector<SeriesLine> lines;
  size_t variants = 0;  // of the operation of the family's name
  for (const auto& [op, variant] : wanted) {
    SeriesLine line = {op + ", " + variant, {}};
    for (const OperationRow& row : rows) {
      if (row.op != op || row.variant != variant) continue;
      const std::optional<int> order = PlainOrder(row.order);
      if (!order || *order < kFirstOrder || *order > kLastOrder) continue;
      line.points.push_back(
          {static_cast<double>(*order), static_cast<double>(row.operations.Multiplies())});
    }
    if (line.points.size() < 2) continue;
    std::sort(line.points.begin(), line.points.end(),
              [](const Point& a, const Point& b) { return a.x < b.x; });
    if (op == family) ++variants;
    lines.push_back(std::move(line));
  }
  return variants < 2 ? std::vector<SeriesLine>() : lines;
}

std::optional<double> GrowthExponent(const std::vector<Point>& points, double from) {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& point : points) {
    if (point.x < from) continue;
    const double log_x = std::log(point.x), log_y = std::log(point.y);
    count += 1.0;
    x += log_x;
    y += log_y;
    xx += log_x * log_x;
    xy += log_x * log_y;
  }
  const double spread = count * xx - x * x;
  if (count < 2.0 || !(spread > 0.0)) return std::nullopt;
  return (count * xy - x * y) / spread;
}

Figure GrowthChart(const std::string& family, const std::vector<SeriesLine>& lines,
                   const std::optional<PublishedCounts>& published) {
  constexpr double kLegend = 282, kHigh = 460, kLeft = 66, kTop = 90;
  // A broad line under the others, and rings over their marks.
  const PathStyle published_path = {"#b8b8b8", 4.5};
  const MarkStyle published_mark = {0, true, kInk, 1.5};
  std::vector<double> orders, counts;
  const auto add = [&](const std::vector<Point>& points) {
    for (const Point& point : points) {
      orders.push_back(point.x);
      counts.push_back(point.y);
    }
  };
  for (const SeriesLine& line : lines) add(line.points);
  if (published) add(published->points);

  Figure figure;
  figure.height = kHigh + 140;
  Panel panel = {"",
                 {kLeft, kTop, figure.width - kLeft - kLegend, kHigh},
                 Axis(orders, Axis::Format::kDigits),
                 Axis(counts, Axis::Format::kSteps),
                 true,
                 true,
                 {}};
  Legend legend;
  if (published) {
    panel.layer.Path(published->points, published_path);
    legend.Heading("the line to beat");
    legend.Line(published_path, published_mark, WithExponent(published->label, published->points));
    for (const std::string& source : published->sources) legend.Heading(source);
    legend.Heading("");
  }
  legend.Heading(fmt::format("counted (exponents: of orders from {})", kFirstFitted));
  // Highest first, at the last order that all of them have.
  std::vector<SeriesLine> sorted = lines;
  double shared = kLastOrder;
  for (const SeriesLine& line : lines) shared = std::min(shared, line.points.back().x);
  const auto height = [&](const SeriesLine& line) {
    return std::find_if(line.points.begin(), line.points.end(),
                        [&](const Point& point) { return point.x >= shared; })
        ->y;
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const SeriesLine& a, const SeriesLine& b) { return height(a) > height(b); });
  const std::vector<std::string> colours = Colours(sorted.size());
  for (size_t k = 0; k < sorted.size(); ++k) {
    const PathStyle path = {colours[k], 1.8};
    const MarkStyle mark = {k, false, colours[k], 0.9};
    panel.layer.Path(sorted[k].points, path);
    panel.layer.Marks(sorted[k].points, mark);
    legend.Line(path, mark, WithExponent(sorted[k].label, sorted[k].points));
  }
  if (published) panel.layer.Marks(published->points, published_mark);
  const double left = kLeft + panel.place.width + 14;
  legend.Draw({left, kTop}, figure.width - left, figure.page);
  figure.panels.push_back(std::move(panel));
  DrawTitles({family + ": multiplications against order",
              "multiplications and fused multiply-adds of one item, counted by running the kernels",
              "order n", "multiplications and fused multiply-adds"},
             figure);
  return figure;
}

}  // namespace gaunt::tool
