// SPDX-License-Identifier: MIT
// Runs gaunt_bench for a family.
#ifndef GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_
#define GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_

#include <string>

#include "chart/marks.h"

namespace gaunt::tool {

// A process for each repetition: some are lucky or unlucky as a whole. `bench` is empty for the
// program next to this one. Throws BadInput if it is not there or has no such family.
Results RunBench(const std::string& bench, const Selection& selection, int repetitions);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_BENCH_RUN_H_
