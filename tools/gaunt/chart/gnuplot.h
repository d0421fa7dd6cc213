// SPDX-License-Identifier: MIT
// Draws with gnuplot.
#ifndef GAUNT_TOOLS_GAUNT_CHART_GNUPLOT_H_
#define GAUNT_TOOLS_GAUNT_CHART_GNUPLOT_H_

#include <string>

#include "chart/figure.h"

namespace gaunt::tool {

class Gnuplot {
 public:
  Gnuplot();  // throws BadInput if there is none

  // The same picture as SVG and as PNG of twice the pixels. Throws std::runtime_error.
  void Draw(const Figure& figure, const std::string& svg, const std::string& png) const;

 private:
  std::string program_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_GNUPLOT_H_
