// SPDX-License-Identifier: MIT
// Runs gaunt_bench for a family.
#ifndef GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_
#define GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_

#include <string>
#include <vector>

#include "chart/marks.h"

namespace gaunt::tool {

class BenchRun {
 public:
  // `bench` is empty for the program next to this one. Throws BadInput if it is not there or has
  // none of the selection.
  BenchRun(const std::string& bench, const Selection& selection);

  // A process for each repetition: some are lucky or unlucky as a whole. Throws
  // std::runtime_error if one fails.
  Results Run(int repetitions) const;

 private:
  std::string bench_, family_;
  std::vector<std::string> names_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_
