// SPDX-License-Identifier: MIT
#include "chart/figure.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gaunt::tool {
namespace {

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

// At decades, or only every so many of them; with digits between where they are few.
std::vector<Tick> Ticks(double from, double to, Axis::Format format) {
  constexpr int kMost = 8;
  const int first = static_cast<int>(std::floor(std::log10(from)));
  const int last = static_cast<int>(std::ceil(std::log10(to)));
  const auto at_digits = [&](const std::vector<int>& digits) {
    std::vector<Tick> ticks;
    const int step = (last - first) / kMost + 1;
    for (int exponent = first; exponent <= last; ++exponent) {
      if (exponent % step != 0) continue;
      for (const int digit : digits) {
        const double at = digit * std::pow(10.0, exponent);
        if (at < from || at > to) continue;
        ticks.push_back({at, format == Axis::Format::kPowers ? Power(digit, exponent)
                                                             : fmt::format("{:.6g}", at)});
      }
    }
    return ticks;
  };
  if (format == Axis::Format::kSteps && last - first <= kMost) return at_digits({1, 3});
  if (format == Axis::Format::kDigits && last - first <= 2) {
    return at_digits({1, 2, 3, 4, 5, 6, 7, 8, 9});
  }
  const std::vector<Tick> few = at_digits({1});
  return few.size() > 2 ? few : at_digits({1, 2, 5});
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

// What could be special to gnuplot becomes its octal number; so does a digit after one.
std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  bool octal = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ') {
      quoted += ' ';
      octal = false;
    } else {
      const bool digit = c >= '0' && c <= '7';
      octal = std::strchr("\"\\`@${}'", c) != nullptr || (octal && digit);
      quoted += octal ? fmt::format("\\{:03o}", byte) : std::string(1, c);
    }
  }
  return quoted + "\"";
}

std::string Shortened(const std::string& text, double width, int size) {
  const auto room = static_cast<size_t>(std::max(1.0, width / (0.6 * size)));
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  if (static_cast<size_t>(std::count_if(text.begin(), text.end(), begins)) <= room) return text;
  std::string kept;
  size_t characters = 0;
  for (const char c : text) {
    if (begins(c) && ++characters == room) break;
    kept += c;
  }
  return kept + "…";
}

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
  static constexpr int kTypes[kShapes] = {7, 5, 13, 9, 11, 15};
  const size_t shape = style.shape % kShapes;
  const int type = kTypes[shape] - (style.hollow ? 1 : 0);
  const auto draw = [&](int pointtype, const std::string& colour, double size) {
    return fmt::format(
        "points pointtype {} pointsize {:.3g}*shape{} linewidth 1.2 linecolor rgb '{}'", pointtype,
        size, shape, colour);
  };
  // A rim keeps marks apart that lie on one another.
  std::vector<std::string> how;
  if (!style.hollow) how.push_back(draw(type, "#ffffff", style.size * 1.3));
  how.push_back(draw(type, style.colour, style.size));
  plots_.push_back({at, how});
}

void Layer::Path(const std::vector<Point>& through, const PathStyle& style) {
  if (through.empty()) return;
  static const std::array<const char*, 4> kDashes = {"solid", "(10,7)", "(2,5)", "(10,5,2,5)"};
  plots_.push_back(
      {through,
       {fmt::format("lines linewidth {:.3g} linecolor rgb '{}' dashtype {}", style.width,
                    style.colour, kDashes[static_cast<size_t>(style.dash)])}});
}

std::string Layer::Script(const std::string& name) const {
  std::string script = labels_, command = "plot NaN notitle";
  for (size_t k = 0; k < plots_.size(); ++k) {
    script += fmt::format("${}_{} << END\n", name, k);
    for (const Point& point : plots_[k].points) {
      script += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
    }
    script += "END\n";
    for (const std::string& how : plots_[k].how) {
      command += fmt::format(", ${}_{} using 1:2 with {}", name, k, how);
    }
  }
  return script + command + "\n";
}

Axis::Axis(const std::vector<double>& values, Format format) {
  constexpr double kLeast = 1e-40, kMost = 1e40;
  double least = kMost, most = kLeast;
  for (const double value : values) {
    if (!(value >= kLeast && value <= kMost)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) least = most = 1.0;
  // Room for marks at the ends, and never less than a decade.
  const double middle = std::sqrt(least * most);
  const double half = std::max(1.15 * std::pow(most / least, 0.53), 3.2);
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
