// SPDX-License-Identifier: MIT
#include "formats/format_chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "chart/page.h"

namespace gaunt::tool {

Figure FormatChart(const std::string& conditions, const std::vector<FormatMark>& marks) {
  constexpr double kLeft = 66, kTop = 90, kHigh = 480, kLegend = 290;
  std::vector<double> bytes, errors;
  std::set<uint32_t> orders;
  std::vector<FormatMark> formats, unpacked;
  for (const FormatMark& mark : marks) {
    errors.push_back(100.0 * mark.rms);
    orders.insert(mark.order);
    (mark.bytes == 0 ? unpacked : formats).push_back(mark);
    if (mark.bytes > 0) bytes.push_back(mark.bytes);
  }
  const std::vector<std::string> colours = Colours(orders.size());
  const auto colour = [&](const FormatMark& mark) {
    return colours[static_cast<size_t>(std::distance(orders.begin(), orders.find(mark.order)))];
  };
  Figure figure;
  figure.height = kHigh + 140;
  Panel panel = {"",
                 {kLeft, kTop, figure.width - kLeft - kLegend, kHigh},
                 Axis(bytes, Axis::Format::kSteps),
                 Axis(errors, Axis::Format::kSteps),
                 true,
                 true,
                 {}};
  Legend legend;
  legend.Heading("coefficients as they are");
  for (const FormatMark& mark : unpacked) {
    const PathStyle path = {colour(mark), 1.2, Dash::kDashed};
    panel.layer.Path({{panel.x.from(), 100.0 * mark.rms}, {panel.x.to(), 100.0 * mark.rms}}, path);
    legend.Line(path, fmt::format("{}: {:.2f} %", mark.name, 100.0 * mark.rms));
  }
  std::vector<Point> points;
  for (const FormatMark& mark : formats) {
    points.push_back({static_cast<double>(mark.bytes), 100.0 * mark.rms});
  }
  const PathStyle front = {"#b8b8b8", 4.5};
  panel.layer.Path(ParetoFront(points), front);
  legend.Heading("");
  legend.Heading("formats, by bytes");
  for (size_t k = 0; k < formats.size(); ++k) {
    const MarkStyle mark = {k, k / kShapes % 2 == 1, colour(formats[k]), 1.1};
    panel.layer.Marks({points[k]}, mark);
    legend.Mark(mark, fmt::format("{:.2f} %: {}", points[k].y, formats[k].name));
  }
  legend.Line(front, "nothing smaller is as close");
  const double left = kLeft + panel.place.width + 14;
  legend.Draw({left, kTop}, figure.width - left, figure.page);
  figure.panels.push_back(std::move(panel));
  DrawTitles({"packed formats: what they lose of irradiance", conditions, "bytes of a probe",
              "RMS error of irradiance, %"},
             figure);
  return figure;
}

}  // namespace gaunt::tool
