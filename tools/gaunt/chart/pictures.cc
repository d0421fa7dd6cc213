// SPDX-License-Identifier: MIT
#include "chart/pictures.h"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "chart/process.h"
#include "output_file.h"

namespace gaunt::tool {
namespace {

void Copy(const std::string& from, const std::string& to) {
  std::error_code error;
  std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw std::runtime_error("cannot write " + to + ": " + error.message());
}

}  // namespace

void DrawPictures(const Gnuplot& gnuplot, const std::vector<NamedFigure>& figures,
                  const std::string& folder) {
  TemporaryFolder drawn;
  for (const NamedFigure& figure : figures) {
    gnuplot.Draw(figure.figure, drawn.File(figure.name + ".svg"), drawn.File(figure.name + ".png"));
  }
  for (const NamedFigure& figure : figures) {
    const std::string path = (std::filesystem::path(folder) / figure.name).string();
    for (const std::string ending : {".svg", ".png"}) {
      OutputFile file(path + ending);
      Copy(drawn.File(figure.name + ending), file.path());
      file.Commit();
    }
    fmt::print("{0}.svg {0}.png\n", path);
  }
}

}  // namespace gaunt::tool
