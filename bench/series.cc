// SPDX-License-Identifier: MIT
#include "bench/series.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace gaunt::bench {

void RegisterSeries(const Series& series) {
  const auto errors = std::make_shared<std::vector<double>>();  // once for all rows
  for (size_t k = 0; k < series.steps.size(); ++k) {
    const size_t steps = series.steps[k];
    const std::string name = series.name + "/" + std::to_string(steps);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      if (errors->empty()) *errors = series.errors();
      for (auto _ : state) benchmark::ClobberMemory();
      state.counters["x"] = static_cast<double>(steps);
      state.counters["error"] = (*errors)[k];
      state.SetLabel(series.label);
    });
  }
}

void DescribeSeries(const std::string& name, const std::string& text, const std::string& steps) {
  benchmark::AddCustomContext("series " + name, text);
  benchmark::AddCustomContext("steps " + name, steps);
}

}  // namespace gaunt::bench
