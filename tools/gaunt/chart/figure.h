// SPDX-License-Identifier: MIT
// Pictures of panels, written as a script for gnuplot. Places on the page are in pixels from its
// upper left corner.
#ifndef GAUNT_TOOLS_GAUNT_CHART_FIGURE_H_
#define GAUNT_TOOLS_GAUNT_CHART_FIGURE_H_

#include <string>
#include <utility>
#include <vector>

#include "chart/marks.h"

namespace gaunt::tool {

inline constexpr char kInk[] = "#222222", kGrey[] = "#777777";

// A text as gnuplot reads it, whatever is in it; without control characters.
std::string Quoted(const std::string& text);

// With an ellipsis if it could be wider, in pixels.
std::string Shortened(const std::string& text, double width, int size);

// Colours of things that have an order, dark to light: apart for every kind of sight, and in grey.
std::vector<std::string> Colours(size_t count);

enum class Align { kLeft, kCentre, kRight };

struct TextStyle {
  std::string colour = kInk;
  int size = 12;
  Align align = Align::kLeft;
};

struct MarkStyle {
  size_t shape = 0;  // circle, square, diamond, triangle, triangle down, pentagon, and again
  bool hollow = false;
  std::string colour = kInk;
  double size = 1.0;
};
inline constexpr size_t kShapes = 6;

enum class Dash { kSolid, kDashed, kDotted, kDashedDotted };

struct PathStyle {
  std::string colour = kInk;
  double width = 1.0;
  Dash dash = Dash::kSolid;
};

// Things drawn over one another, in the order of the calls.
class Layer {
 public:
  void Text(Point at, const std::string& text, const TextStyle& style);
  void Marks(const std::vector<Point>& at, const MarkStyle& style);
  void Path(const std::vector<Point>& through, const PathStyle& style);

  // Commands that draw it. Names of data begin with `name`.
  std::string Script(const std::string& name) const;

 private:
  struct Plot {
    std::vector<Point> points;
    std::vector<std::string> how;  // over one another
  };
  std::string labels_;
  std::vector<Plot> plots_;
};

struct Tick {
  double at;
  std::string label;
};

// A logarithmic axis with a margin around the values.
class Axis {
 public:
  enum class Format { kPlain, kPowers, kSteps, kDigits };  // kSteps: 1, 3, 10; kDigits: 1, 2, 3, 4

  // Of values that are finite and positive, and neither tiny nor huge.
  explicit Axis(const std::vector<double>& values, Format format = Format::kPlain);

  double from() const { return from_; }
  double to() const { return to_; }
  const std::vector<Tick>& ticks() const { return ticks_; }
  double Share(double value) const;  // 0 at its beginning, 1 at its end
  double Moved(double value, double share) const;

 private:
  double from_, to_;
  std::vector<Tick> ticks_;
};

struct Rectangle {
  double left, top, width, height;
};

struct Panel {
  std::string title;
  Rectangle place;  // of its plotting area
  Axis x, y;
  bool labels_x = true, labels_y = true;
  Layer layer;
};

struct Figure {
  double width = 900, height = 0;
  Layer page;  // in pixels
  std::vector<Panel> panels;

  // Without the terminal and the output. The sizes of marks, which terminals do not agree on, are
  // in variables shape0 and so on.
  std::string Script() const;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_FIGURE_H_
