// SPDX-License-Identifier: MIT
// What the charts share: titles, small multiples, legends.
#ifndef GAUNT_TOOLS_GAUNT_CHART_PAGE_H_
#define GAUNT_TOOLS_GAUNT_CHART_PAGE_H_

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "chart/figure.h"

namespace gaunt::tool {

// Values of a member in the order of their first appearance.
template <class Marks, class Value>
std::vector<Value> Distinct(const Marks& marks, Value Mark::*member) {
  std::vector<Value> values;
  for (const Mark& mark : marks) {
    if (std::find(values.begin(), values.end(), mark.*member) == values.end()) {
      values.push_back(mark.*member);
    }
  }
  return values;
}

template <class Values, class Value>
size_t IndexOf(const Values& values, const Value& value) {
  return static_cast<size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

struct Titles {
  std::string title, conditions, x, y;
};

class Legend {
 public:
  void Heading(const std::string& text);
  void Mark(const MarkStyle& style, const std::string& text);
  void Line(const PathStyle& style, const std::string& text);

  double height() const;
  void Draw(Point corner, Layer& page) const;

 private:
  enum class Kind { kHeading, kMark, kLine };
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
