// SPDX-License-Identifier: MIT
// Pictures as files.
#ifndef GAUNT_TOOLS_GAUNT_CHART_PICTURES_H_
#define GAUNT_TOOLS_GAUNT_CHART_PICTURES_H_

#include <string>
#include <vector>

#include "chart/figure.h"
#include "chart/gnuplot.h"

namespace gaunt::tool {

struct NamedFigure {
  std::string name;
  Figure figure;
};

// Draws <name>.svg and <name>.png of each in a folder, and prints their names. All of them are drawn
// before the first is in its place. Throws std::runtime_error.
void DrawPictures(const Gnuplot& gnuplot, const std::vector<NamedFigure>& figures,
                  const std::string& folder);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_PICTURES_H_
