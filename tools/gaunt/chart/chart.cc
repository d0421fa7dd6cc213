// SPDX-License-Identifier: MIT
// gaunt chart: draws a family's speed and accuracy.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "chart/bench_run.h"
#include "chart/charts.h"
#include "chart/pictures.h"
#include "command.h"
#include "output_file.h"
#include "simd/count.h"

namespace gaunt::tool {
namespace {

struct ChartOptions {
  Selection selection;
  std::string results;
  std::string bench;
  std::vector<int> orders = {2, 8};
  std::string out = "out/charts";
  int repetitions = 9;
};

constexpr char kLoopLayout[] = "interleaved";  // of scalar loops

Results GetResults(const ChartOptions& options) {
  const Results results = ReadResults({options.results});
  std::vector<std::string> names;
  for (const ResultRow& row : results.rows) names.push_back(row.name);
  CheckFamily(names, options.selection.family, options.results);
  return results;
}

std::string Conditions(const Results& results, const Selection& selection,
                       const std::vector<Mark>& marks) {
  const bool loops_differ =
      selection.layout != kLoopLayout &&
      std::any_of(marks.begin(), marks.end(), [](const Mark& mark) { return mark.is_baseline(); });
  return fmt::format("{} · {} layout{} · {} items · medians", results.compiler, selection.layout,
                     loops_differ ? fmt::format(" (scalar loops: {})", kLoopLayout) : "",
                     selection.items);
}

std::vector<NamedFigure> MakeFigures(const Results& results, const Selection& selection) {
  const std::string& family = selection.family;
  const std::vector<Mark> marks = SelectMarks(results, selection);
  std::vector<Mark> with_error, with_multiplies;
  for (const Mark& mark : marks) {
    if (mark.error) with_error.push_back(mark);
    if (mark.multiplies) with_multiplies.push_back(mark);
  }
  std::vector<NamedFigure> figures;
  if (!with_error.empty()) {
    figures.push_back({family + "_error",
                       ErrorChart(family, Conditions(results, selection, with_error), with_error)});
  }
  if (!with_multiplies.empty()) {
    figures.push_back({family + "_operations",
                       OperationsChart(family, Conditions(results, selection, with_multiplies),
                                       with_multiplies)});
  }
  for (const SeriesData& series : SelectSeries(results, family)) {
    figures.push_back({family + "_" + series.name, SeriesChart(family, results.compiler, series)});
  }
  // Counted here and now, whatever was timed.
  const std::vector<SeriesLine> growth = SelectGrowth(AllOperations(), family);
  if (!growth.empty()) {
    figures.push_back({family + "_growth", GrowthChart(family, growth, PublishedOf(family))});
  }
  if (figures.empty()) {
    throw BadInput(
        fmt::format("no row of {} can be drawn: those of the {} layout and {} items have "
                    "neither errors nor operations, or methods without names",
                    family, selection.layout, selection.items));
  }
  return figures;
}

void RunChart(const ChartOptions& options) {
  // Before any work: they fail.
  const Gnuplot gnuplot;
  const Selection& selection = options.selection;
  if (selection.first_order > selection.last_order) {
    throw BadInput(fmt::format("--orders: the first, {}, is above the last, {}",
                               selection.first_order, selection.last_order));
  }
  std::vector<NamedFigure> figures;
  if (!options.results.empty()) {
    figures = MakeFigures(GetResults(options), selection);
    PrepareFolder(options.out);
  } else {
    const BenchRun bench(options.bench, selection);
    PrepareFolder(options.out);
    figures = MakeFigures(bench.Run(options.repetitions), selection);
  }
  DrawPictures(gnuplot, figures, options.out);
}

}  // namespace

void AddChart(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "chart",
      "Draw a family's time against error and operations, from its benchmarks. These take a while: "
      "of rotate some 100 s on two cores");
  const auto o = std::make_shared<ChartOptions>();
  command->add_option("family", o->selection.family, "Family of functions, such as rotate")
      ->required();
  CLI::Option* results = command->add_option(
      "--results", o->results, "JSON that gaunt_bench wrote; by default gaunt_bench is run");
  command->add_option("--bench", o->bench, "gaunt_bench; by default the one next to gaunt")
      ->excludes(results);
  command->add_option("--repetitions", o->repetitions, "Runs of gaunt_bench, for medians")
      ->check(CLI::Range(1, 99))
      ->capture_default_str()
      ->excludes(results);
  command->add_option("--layout", o->selection.layout, "Layout of the data")
      ->check(CLI::IsMember({"tiled", "planar", "interleaved"}))
      ->capture_default_str();
  command->add_option("--items", o->selection.items, "Items of a call")
      ->check(CLI::IsMember({1000, 1024, 1 << 20}))
      ->capture_default_str();
  command
      ->add_option("--orders", o->orders,
                   "First and last order of the timings; 1 is a copy of one number")
      ->expected(2)
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--out", o->out, "Folder for the pictures")->capture_default_str();
  command->callback([o] {
    o->selection.first_order = o->orders[0];
    o->selection.last_order = o->orders[1];
    RunChart(*o);
  });
}

}  // namespace gaunt::tool
