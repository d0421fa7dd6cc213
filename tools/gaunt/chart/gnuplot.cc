// SPDX-License-Identifier: MIT
#include "chart/gnuplot.h"

#include <fmt/core.h>

#include <array>
#include <fstream>
#include <stdexcept>

#include "bad_input.h"
#include "chart/process.h"

namespace gaunt::tool {
namespace {

std::string ShapeSizes(const std::array<double, kShapes>& sizes) {
  std::string script;
  for (size_t k = 0; k < kShapes; ++k) script += fmt::format("shape{} = {}\n", k, sizes[k]);
  return script;
}

}  // namespace

Gnuplot::Gnuplot() : program_(FindProgram("gnuplot")) {
  if (program_.empty()) throw BadInput("charts need gnuplot: install the package gnuplot-nox");
}

void Gnuplot::Draw(const Figure& figure, const std::string& svg, const std::string& png) const {
  TemporaryFolder folder;
  const std::string body = figure.Script();
  const auto draw = [&](const std::string& terminal, const std::string& to) {
    std::ofstream script(folder.File("script"), std::ios::binary);
    script << terminal << "\nset output " << Quoted(to) << "\n" << body << "unset output\n";
    script.close();
    if (!script) throw std::runtime_error("cannot write " + folder.File("script"));
    std::string first;
    const int status = RunProcess({program_, folder.File("script")}, [&](const std::string& line) {
      if (first.empty() && line.find_first_not_of(" \t^") != std::string::npos) first = line;
    });
    if (status != 0) throw std::runtime_error("gnuplot failed: " + first);
  };
  // Sizes of fonts are pixels in SVG and points in PNG. Those of marks give every shape the same
  // area in both.
  const std::string style = "noenhanced font 'sans-serif,12' background rgb 'white'";
  draw(fmt::format("set terminal svg size {},{} fixed {}\n{}", figure.width, figure.height, style,
                   ShapeSizes({0.70, 0.62, 0.62, 0.73, 0.73, 0.61})),
       svg);
  draw(fmt::format("set terminal pngcairo size {},{} {} fontscale 1.5 linewidth 2 pointscale 2 "
                   "dashlength 1.7\n{}",
                   2 * figure.width, 2 * figure.height, style,
                   ShapeSizes({1.13, 0.97, 1.38, 1.37, 1.37, 1.28})),
       png);
}

}  // namespace gaunt::tool
