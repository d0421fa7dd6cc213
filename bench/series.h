// SPDX-License-Identifier: MIT
// Accuracy over the steps of a process. Rows read family/<series>/<line>/<steps>, with counters
// `x`, the steps, and `error`; their times mean nothing.
#ifndef GAUNT_BENCH_SERIES_H_
#define GAUNT_BENCH_SERIES_H_

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace gaunt::bench {

struct Series {
  std::string name;   // family/<series>/<line>
  std::string label;  // the line in words, for charts
  std::vector<size_t> steps;
  std::function<std::vector<double>()> errors;  // one for each of the steps
};

void RegisterSeries(const Series& series);

// What family/<series> shows, for charts: "title: conditions", and what its steps are. Once for each.
void DescribeSeries(const std::string& name, const std::string& text,
                    const std::string& steps = "steps");

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_SERIES_H_
