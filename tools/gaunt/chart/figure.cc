// SPDX-License-Identifier: MIT
#include "chart/figure.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gaunt::tool {
namespace {

// In single quotes nothing is special to gnuplot but the quote.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

// 2×10⁻⁷
std::string Power(int digit, int exponent) {
  static const std::array<const char*, 10> kSuperscripts = {"⁰", "¹", "²", "³", "⁴",
                                                            "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) {
    raised += kSuperscripts[static_cast<size_t>(c - '0')];
  }
  return (digit == 1 ? "10" : fmt::format("{}×10", digit)) + raised;
}

// At decades, and at 2 and 5 between where they are few.
std::vector<Tick> Ticks(double from, double to, Axis::Format format) {
  const auto decades = [&](const std::vector<int>& digits) {
    std::vector<Tick> ticks;
    for (int exponent = static_cast<int>(std::floor(std::log10(from))) - 1;
         std::pow(10.0, exponent) <= to; ++exponent) {
      for (const int digit : digits) {
        const double at = digit * std::pow(10.0, exponent);
        if (at < from || at > to) continue;
        ticks.push_back({at, format == Axis::Format::kPowers ? Power(digit, exponent)
                                                             : fmt::format("{:.6g}", at)});
      }
    }
    return ticks;
  };
  const std::vector<Tick> few = decades({1});
  return few.size() > 2 ? few : decades({1, 2, 5});
}

std::string PanelScript(const Figure& figure, const Panel& panel, const std::string& name) {
  const auto x = [&](double pixels) { return pixels / figure.width; };
  const auto y = [&](double pixels) { return 1.0 - pixels / figure.height; };
  const Rectangle& place = panel.place;
  const auto ticks = [](const Axis& axis, bool labels) {
    std::vector<std::string> list;
    for (const Tick& tick : axis.ticks()) {
      list.push_back(fmt::format("{} {:.9g}", Quoted(labels ? tick.label : ""), tick.at));
    }
    return fmt::format("({})", fmt::join(list, ", "));
  };
  Layer layer = panel.layer;
  std::string script = fmt::format(
      "unset label\n"
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
      x(place.left), x(place.left + place.width), y(place.top), y(place.top + place.height));
  script += fmt::format(
      "set logscale xy\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n"
      "set xtics scale 0 offset 0,0.3 textcolor rgb '{}' {}\n"
      "set ytics scale 0 offset 0.5,0 textcolor rgb '{}' {}\n"
      "set grid xtics ytics back linetype 1 linecolor rgb '#e8e8e8' linewidth 1 dashtype solid\n"
      "set border 15 back linecolor rgb '#c4c4c4' linewidth 1\n",
      panel.x.from(), panel.x.to(), panel.y.from(), panel.y.to(), kGrey,
      ticks(panel.x, panel.labels_x), kGrey, ticks(panel.y, panel.labels_y));
  return script + layer.Script(name);
}

}  // namespace

std::vector<std::string> Colours(size_t count) {
  static constexpr double kRamp[][3] = {
      {23, 21, 92}, {134, 31, 134}, {207, 53, 78}, {232, 119, 34}, {220, 174, 29}};
  constexpr double kEnd = 4.0;
  // Few of them stay with the darker ones.
  const double step = count < 2 ? 0.0 : std::min(1.5, kEnd / static_cast<double>(count - 1));
  std::vector<std::string> colours;
  for (size_t i = 0; i < count; ++i) {
    const double at = step * static_cast<double>(i);
    const size_t below = static_cast<size_t>(std::min(at, kEnd - 1.0));
    const double share = at - static_cast<double>(below);
    std::array<long, 3> rgb;
    for (size_t c = 0; c < 3; ++c) {
      rgb[c] = std::lround((1.0 - share) * kRamp[below][c] + share * kRamp[below + 1][c]);
    }
    colours.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]));
  }
  return colours;
}

void Layer::Text(Point at, const std::string& text, const TextStyle& style) {
  static const std::array<const char*, 3> kAligns = {"left", "center", "right"};
  labels_ += fmt::format(
      "set label {} at {:.9g},{:.9g} {} font 'sans-serif,{}' textcolor rgb '{}' front\n",
      Quoted(text), at.x, at.y, kAligns[static_cast<size_t>(style.align)], style.size,
      style.colour);
}

void Layer::Marks(const std::vector<Point>& at, const MarkStyle& style) {
  if (at.empty()) return;
  static constexpr int kTypes[kShapes] = {7, 5, 9, 13, 11, 15};
  data_ += fmt::format("${{NAME}}_{} << END\n", blocks_);
  for (const Point& point : at) data_ += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
  data_ += "END\n";
  const size_t shape = style.shape % kShapes;
  const int type = kTypes[shape] - (style.hollow ? 1 : 0);
  const auto draw = [&](const std::string& colour, double size) {
    clauses_ += fmt::format(
        ", ${{NAME}}_{} using 1:2 with points pointtype {} pointsize {:.3g}*shape{} linewidth 1.2 "
        "linecolor rgb '{}'",
        blocks_, type, size, shape, colour);
  };
  // A rim keeps marks apart that lie on one another.
  if (!style.hollow) draw("#ffffff", style.size * 1.3);
  draw(style.colour, style.size);
  ++blocks_;
}

void Layer::Path(const std::vector<Point>& through, const PathStyle& style) {
  if (through.empty()) return;
  static const std::array<const char*, 3> kDashes = {"solid", "(10,7)", "(2,5)"};
  data_ += fmt::format("${{NAME}}_{} << END\n", blocks_);
  for (const Point& point : through) data_ += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
  data_ += "END\n";
  clauses_ += fmt::format(
      ", ${{NAME}}_{} using 1:2 with lines linewidth {:.3g} linecolor rgb '{}' dashtype {}",
      blocks_, style.width, style.colour, kDashes[static_cast<size_t>(style.dash)]);
  ++blocks_;
}

std::string Layer::Script(const std::string& name) const {
  std::string script = data_ + labels_ + "plot NaN notitle" + clauses_ + "\n";
  const std::string hole = "${NAME}";
  for (size_t at; (at = script.find(hole)) != std::string::npos;) {
    script.replace(at, hole.size(), "$" + name);
  }
  return script;
}

Axis::Axis(const std::vector<double>& values, Format format) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  // Room for marks at the ends, and never less than a decade.
  const double middle = std::sqrt(*least * *most);
  const double half = std::max(1.15 * std::pow(*most / *least, 0.53), 3.2);
  from_ = middle / half;
  to_ = middle * half;
  // Labels at the very ends would run into the next panel.
  ticks_ = Ticks(Moved(from_, 0.03), Moved(from_, 0.97), format);
}

double Axis::Share(double value) const { return std::log(value / from_) / std::log(to_ / from_); }

double Axis::Moved(double value, double share) const {
  return value * std::pow(to_ / from_, share);
}

std::string Figure::Script() const {
  std::string script = "set encoding utf8\nunset key\nset multiplot\n";
  for (size_t k = 0; k < panels.size(); ++k) {
    script += PanelScript(*this, panels[k], fmt::format("panel{}", k));
  }
  script += fmt::format(
      "unset label\nunset logscale\nunset tics\nunset border\nunset grid\n"
      "set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\n"
      "set bmargin at screen 0\nset xrange [0:{0}]\nset yrange [{1}:0]\n",
      width, height);
  return script + page.Script("page") + "unset multiplot\n";
}

}  // namespace gaunt::tool
