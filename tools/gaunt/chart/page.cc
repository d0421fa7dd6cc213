// SPDX-License-Identifier: MIT
#include "chart/page.h"

#include <cmath>

namespace gaunt::tool {
namespace {

constexpr double kEdge = 14, kLeft = 66, kRight = 14, kTop = 104, kBottom = 46;
constexpr double kGapX = 14, kGapY = 42;
constexpr double kLegend = 200, kLine = 16;  // of a legend

// As many columns as leave few places empty.
size_t Columns(size_t places) {
  if (places <= 4) return places;
  const auto empty = [&](size_t columns) { return (columns - places % columns) % columns; };
  return empty(3) < empty(4) ? 3 : 4;
}

}  // namespace

std::vector<std::string> Targets(const std::vector<Mark>& marks) {
  std::vector<std::string> targets = Distinct(marks, &Mark::target);
  targets.erase(std::remove(targets.begin(), targets.end(), ""), targets.end());
  std::sort(targets.begin(), targets.end(), TargetBefore);
  return targets;
}

void Legend::Heading(const std::string& text) {
  entries_.push_back({Kind::kHeading, text, MarkStyle(), PathStyle()});
}
void Legend::Mark(const MarkStyle& style, const std::string& text) {
  entries_.push_back({Kind::kMark, text, style, PathStyle()});
}
void Legend::Line(const PathStyle& style, const std::string& text) {
  entries_.push_back({Kind::kLine, text, MarkStyle(), style});
}
void Legend::Line(const PathStyle& style, const MarkStyle& mark, const std::string& text) {
  entries_.push_back({Kind::kMarkedLine, text, mark, style});
}
void Legend::Swatch(const std::string& colour, const std::string& text) {
  entries_.push_back({Kind::kSwatch, text, {1, false, colour, 0.9}, PathStyle()});
}
void Legend::Whisker(const std::string& colour, const std::string& text) {
  entries_.push_back({Kind::kWhisker, text, {0, false, colour, 1.0}, {colour, kWhiskerWidth}});
}

double Legend::height() const { return kLine * static_cast<double>(entries_.size()); }

void Legend::Draw(Point corner, double width, Layer& page) const {
  constexpr double kText = 32;
  double y = corner.y + 0.5 * kLine;
  for (const Entry& entry : entries_) {
    const bool heading = entry.kind == Kind::kHeading;
    const double left = heading ? corner.x : corner.x + kText;
    page.Text({left, y}, Shortened(entry.text, corner.x + width - left, 11),
              {heading ? kGrey : kInk, 11});
    std::vector<Point> bar;
    switch (entry.kind) {
      case Kind::kHeading: break;
      case Kind::kMark: page.Marks({{corner.x + 12, y}}, entry.mark); break;
      case Kind::kLine: page.Path({{corner.x, y}, {corner.x + 24, y}}, entry.line); break;
      case Kind::kMarkedLine:
        // From the middle: its beginning is ragged where it is thick.
        page.Path({{corner.x + 12, y}, {corner.x, y}, {corner.x + 24, y}}, entry.line);
        page.Marks({{corner.x + 12, y}}, entry.mark);
        break;
      case Kind::kSwatch:  // squares that make a bar: thick lines end raggedly
        for (const double x : {5.0, 8.0, 11.0, 14.0, 17.0, 20.0}) bar.push_back({corner.x + x, y});
        page.Marks(bar, entry.mark);
        break;
      case Kind::kWhisker:
        page.Path({{corner.x + 2, y}, {corner.x + 20, y}}, entry.line);
        page.Path({{corner.x + 2, y - 4}, {corner.x + 2, y + 4}}, entry.line);
        page.Marks({{corner.x + 20, y}}, entry.mark);
        break;
    }
    y += kLine;
  }
}

Figure SmallMultiples(const Titles& titles, std::vector<Panel> panels, const Legend& legend) {
  Figure figure;
  const size_t places = panels.size() + 1, columns = Columns(places);
  const size_t rows = (places + columns - 1) / columns;
  // A single row leaves the legend what it needs, and the panels the rest.
  const double all = figure.width - kLeft - kRight;
  const double width =
      std::floor(rows == 1 ? (all - kLegend) / static_cast<double>(columns - 1) - kGapX
                           : (all + kGapX) / static_cast<double>(columns) - kGapX);
  const double height = std::max(190.0, legend.height() + 4);
  figure.height = kTop + static_cast<double>(rows) * (height + kGapY) - kGapY + kBottom;
  const auto place = [&](size_t k) {
    return Rectangle{kLeft + static_cast<double>(k % columns) * (width + kGapX),
                     kTop + static_cast<double>(k / columns) * (height + kGapY), width, height};
  };
  for (size_t k = 0; k < panels.size(); ++k) {
    panels[k].place = place(k);
    panels[k].labels_y = k % columns == 0;
  }
  figure.panels = std::move(panels);
  const Rectangle rest = place(places - 1);
  legend.Draw({rest.left + 12, rest.top}, figure.width - rest.left - 12, figure.page);
  DrawTitles(titles, figure);
  return figure;
}

void DrawTitles(const Titles& titles, Figure& figure) {
  const double width = figure.width - 2 * kEdge;
  figure.page.Text({kEdge, 22}, Shortened(titles.title, width, 17), {kInk, 17});
  figure.page.Text({kEdge, 44}, Shortened(titles.conditions, width, 12), {kGrey, 12});
  figure.page.Text({kEdge, kTop - 30}, "↑ " + titles.y, {kInk, 12});
  figure.page.Text({kLeft, figure.height - 14}, titles.x + " →", {kInk, 12});
  for (const Panel& panel : figure.panels) {
    figure.page.Text({panel.place.left + panel.place.width / 2, panel.place.top - 10},
                     Shortened(panel.title, panel.place.width, 12), {kInk, 12, Align::kCentre});
  }
}

}  // namespace gaunt::tool
