// SPDX-License-Identifier: MIT
#include "chart/bench_run.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "bad_input.h"
#include "chart/process.h"
#include "progress.h"

namespace gaunt::tool {
namespace {

namespace fs = std::filesystem;

std::string FindBench(const std::string& path) {
  std::error_code error;
  const std::string bench =
      path.empty()
          ? (fs::read_symlink("/proc/self/exe", error).parent_path() / "gaunt_bench").string()
          : path;
  const std::string found =
      FindProgram(bench.find('/') == std::string::npos ? "./" + bench : bench);
  if (found.empty()) {
    throw BadInput(
        fmt::format("there is no program {}: build gaunt_bench, or give --bench or "
                    "--results",
                    bench));
  }
  return found;
}

// Throws std::runtime_error with the last line if the program fails.
void Run(const std::vector<std::string>& command,
         const std::function<void(const std::string& line)>& on_line) {
  std::string last;
  const int status = RunProcess(command, [&](const std::string& line) {
    if (!line.empty()) last = line;
    on_line(line);
  });
  if (status != 0) {
    throw std::runtime_error(fmt::format("{} ended with status {} {}", command[0], status, last));
  }
}

// Those of the selection: kernels in the layout, scalar loops, and series.
std::vector<std::string> Names(const std::string& bench, const Selection& selection) {
  std::vector<std::string> all, names;
  Run({bench, "--benchmark_list_tests"}, [&](const std::string& line) { all.push_back(line); });
  CheckFamily(all, selection.family, bench);
  std::set<std::string> targets;  // what runs in the layout; others are scalar loops
  for (const std::string& line : all) {
    const std::optional<MarkName> name = ParseMarkName(line);
    if (name && name->layout != "interleaved") targets.insert(name->target);
  }
  for (const std::string& line : all) {
    const std::optional<MarkName> mark = ParseMarkName(line);
    const std::optional<SeriesName> series = ParseSeriesName(line);
    const bool draws_mark = mark && selection.Takes(*mark) &&
                            (mark->layout == selection.layout || targets.count(mark->target) == 0);
    if (draws_mark || (series && series->family == selection.family)) names.push_back(line);
  }
  return names;
}

}  // namespace

Results RunBench(const std::string& path, const Selection& selection, int repetitions) {
  const std::string bench = FindBench(path);
  const std::vector<std::string> names = Names(bench, selection);
  if (names.empty()) return {};
  const TemporaryFolder folder;
  std::vector<std::string> files;
  Progress bar("timing");
  for (int k = 0; k < repetitions; ++k) {
    files.push_back(folder.File(fmt::format("{}.json", k)));
    size_t done = 0;
    Run({bench, fmt::format("--benchmark_filter=^({})$", fmt::join(names, "|")),
         "--benchmark_min_time=0.01", "--benchmark_enable_random_interleaving=true",
         "--benchmark_out_format=json", "--benchmark_out=" + files.back()},
        [&](const std::string& line) {
          if (line.rfind(selection.family + "/", 0) == 0) ++done;
          bar.Set((k + static_cast<double>(done) / static_cast<double>(names.size())) /
                  repetitions);
        });
  }
  return ReadResults(files);
}

}  // namespace gaunt::tool
