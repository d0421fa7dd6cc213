// SPDX-License-Identifier: MIT
// What gaunt_bench wrote.
#ifndef GAUNT_TOOLS_GAUNT_CHART_RESULTS_H_
#define GAUNT_TOOLS_GAUNT_CHART_RESULTS_H_

#include <map>
#include <string>
#include <vector>

namespace gaunt::tool {

struct ResultRow {
  std::string name;
  std::string label;                       // in words, or empty
  std::map<std::string, double> counters;  // medians over repetitions
};

struct Results {
  std::string compiler;
  std::vector<ResultRow> rows;                      // by name
  std::map<std::string, std::string> descriptions;  // of family/<series>
  std::map<std::string, std::string> steps = {};    // what those of family/<series> are
};

double Median(std::vector<double> values);

// Of files of the same program, which count as repetitions. Throws BadInput if they are not what
// gaunt_bench writes, or if a benchmark failed.
Results ReadResults(const std::vector<std::string>& paths);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_RESULTS_H_
