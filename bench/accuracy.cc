// SPDX-License-Identifier: MIT
#include "bench/accuracy.h"

#include <algorithm>
#include <cmath>

namespace gaunt::bench {
namespace {

std::vector<double> Exact(const Reference& reference, size_t item, const std::vector<Planes>& in,
                          size_t planes) {
  std::vector<std::vector<double>> inputs;
  std::vector<const double*> pointers;
  for (const Planes& side : in) inputs.push_back(side.Item(item));
  for (const std::vector<double>& values : inputs) pointers.push_back(values.data());
  std::vector<double> out(planes);
  reference(pointers, out.data());
  return out;
}

}  // namespace

Errors Accuracy::Measure(size_t count, size_t variant, size_t checked,
                         const std::vector<Planes>& in, const Planes& out) {
  checked = std::min(count, checked);
  const auto item_of = [&](size_t k) { return k * count / checked; };
  const auto [entry, is_new] = exact_.try_emplace({count, variant});
  std::vector<double>& exact = entry->second;
  for (size_t k = 0; is_new && k < checked; ++k) {
    const std::vector<double> values = Exact(reference_, item_of(k), in, out.planes());
    exact.insert(exact.end(), values.begin(), values.end());
  }

  Errors errors;
  double squared = 0.0, relative = 0.0;
  const double* expected = exact.data();
  for (size_t k = 0; k < checked; ++k) {
    double of_item = 0.0, norm = 0.0;
    for (const double value : out.Item(item_of(k))) {
      const double error = std::abs(value - *expected);
      errors.largest = std::max(errors.largest, error);
      errors.rounding =
          std::max(errors.rounding, std::abs(static_cast<float>(*expected) - *expected));
      of_item += error * error;
      norm += *expected * *expected;
      ++expected;
    }
    squared += of_item;
    if (norm > 0.0) relative += of_item / norm;
  }
  errors.rms = std::sqrt(squared / static_cast<double>(exact.size()));
  errors.relative = std::sqrt(relative / static_cast<double>(checked));
  return errors;
}

}  // namespace gaunt::bench
