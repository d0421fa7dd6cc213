// SPDX-License-Identifier: MIT
// Errors of a benchmark's outputs against the definition in double precision.
#ifndef GAUNT_BENCH_ACCURACY_H_
#define GAUNT_BENCH_ACCURACY_H_

#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "bench/planes.h"

namespace gaunt::bench {

// The first output of an item, from its inputs.
using Reference = std::function<void(const std::vector<const double*>& in, double* out)>;

struct Errors {
  double largest = 0.0;
  double rms = 0.0;       // NaN if an output is
  double rounding = 0.0;  // largest of the exact outputs when they are rounded to float
  double relative = 0.0;  // root mean square over items of the L2 norm, in that of the exact output
};

class Accuracy {
 public:
  explicit Accuracy(Reference reference) : reference_(std::move(reference)) {}

  // Of `checked` items at most, spread over all. The inputs of a count and a variant are the same in
  // every run, so that the exact outputs are kept.
  Errors Measure(size_t count, size_t variant, size_t checked, const std::vector<Planes>& in,
                 const Planes& out);

 private:
  Reference reference_;
  std::map<std::pair<size_t, size_t>, std::vector<double>> exact_;  // by count and variant
};

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_ACCURACY_H_
