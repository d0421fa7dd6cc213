// SPDX-License-Identifier: MIT
#include "chart/bench_run.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <optional>
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
  const std::string file = bench.find('/') == std::string::npos ? "./" + bench : bench;
  if (!FindProgram(file).empty()) return file;
  if (fs::is_directory(file, error)) throw BadInput(bench + " is a folder, not gaunt_bench");
  if (fs::exists(file, error)) throw BadInput(bench + " is no program that may be run");
  throw BadInput(fmt::format(
      "there is no program {}: build gaunt_bench, or give --bench or --results", bench));
}

// Throws std::runtime_error with the last line if the program fails.
void RunToEnd(const std::vector<std::string>& command,
              const std::function<void(const std::string& line)>& on_line) {
  std::string last;
  const int status = RunProcess(command, [&](const std::string& line) {
    if (!line.empty()) last = line;
    on_line(line);
  });
  if (status == 0) return;
  throw std::runtime_error(fmt::format(
      "{} {} {}{}{}", command[0], status > 128 ? "was ended by signal" : "ended with status",
      status > 128 ? status - 128 : status, last.empty() ? "" : ": ", last));
}

// Those of the selection: kernels in the layout, scalar loops, and series.
std::vector<std::string> Names(const std::string& bench, const Selection& selection) {
  std::vector<std::string> all, names;
  RunToEnd({bench, "--benchmark_list_tests"},
           [&](const std::string& line) { all.push_back(line); });
  CheckFamily(all, selection.family, bench);
  std::vector<MarkName> kernels;
  for (const std::string& line : all) {
    const std::optional<MarkName> mark = ParseMarkName(line);
    const std::optional<SeriesName> series = ParseSeriesName(line);
    if (mark && mark->family == selection.family && !mark->is_baseline()) kernels.push_back(*mark);
    if ((mark && selection.Takes(*mark)) || (series && series->family == selection.family)) {
      names.push_back(line);
    }
  }
  CheckSelection(kernels, selection);
  return names;
}

}  // namespace

BenchRun::BenchRun(const std::string& bench, const Selection& selection)
    : bench_(FindBench(bench)), family_(selection.family), names_(Names(bench_, selection)) {}

Results BenchRun::Run(int repetitions) const {
  if (names_.empty()) return {};
  TemporaryFolder folder;
  std::vector<std::string> files;
  Progress bar("timing");
  for (int k = 0; k < repetitions; ++k) {
    files.push_back(folder.File(fmt::format("{}.json", k)));
    size_t done = 0;
    RunToEnd({bench_, fmt::format("--benchmark_filter=^({})$", fmt::join(names_, "|")),
              "--benchmark_min_time=0.01", "--benchmark_enable_random_interleaving=true",
              "--benchmark_out_format=json", "--benchmark_out=" + files.back()},
             [&](const std::string& line) {
               if (line.rfind(family_ + "/", 0) == 0) ++done;
               bar.Set((k + static_cast<double>(done) / static_cast<double>(names_.size())) /
                       repetitions);
             });
  }
  try {
    return ReadResults(files);
  } catch (const BadInput& error) {
    throw std::runtime_error(fmt::format("{} gave no results: {}", bench_, error.what()));
  }
}

}  // namespace gaunt::tool
