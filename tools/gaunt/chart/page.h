// SPDX-License-Identifier: MIT
// What the charts share: titles, small multiples, legends.
#ifndef GAUNT_TOOLS_GAUNT_CHART_PAGE_H_
#define GAUNT_TOOLS_GAUNT_CHART_PAGE_H_

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "chart/figure.h"
#include "chart/marks.h"

namespace gaunt::tool {

// Values of a member, sorted.
template <class Marks, class Value>
std::vector<Value> Distinct(const Marks& marks, Value Mark::*member) {
  std::set<Value> values;
  for (const Mark& mark : marks) values.insert(mark.*member);
  return {values.begin(), values.end()};
}

template <class Values, class Value>
size_t IndexOf(const Values& values, const Value& value) {
  return static_cast<size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

// Those of the marks that have one, best first.
std::vector<std::string> Targets(const std::vector<Mark>& marks);

struct Titles {
  std::string title, conditions, x, y;
};

inline constexpr double kWhiskerWidth = 0.9;

class Legend {
 public:
  void Heading(const std::string& text);
  void Mark(const MarkStyle& style, const std::string& text);
  void Line(const PathStyle& style, const std::string& text);
  void Line(const PathStyle& style, const MarkStyle& mark, const std::string& text);
  void Swatch(const std::string& colour, const std::string& text);
  void Whisker(const std::string& colour, const std::string& text);

  double height() const;
  void Draw(Point corner, double width, Layer& page) const;

 private:
  enum class Kind { kHeading, kMark, kLine, kMarkedLine, kSwatch, kWhisker };
  struct Entry {
    Kind kind;
    std::string text;
    MarkStyle mark;
    PathStyle line;
  };
  std::vector<Entry> entries_;
};

// Panels of shared axes in rows, and the legend in the place after the last.
Figure SmallMultiples(const Titles& titles, std::vector<Panel> panels, const Legend& legend);

// Titles above the panels and beside their axes.
void DrawTitles(const Titles& titles, Figure& figure);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_PAGE_H_
