// SPDX-License-Identifier: MIT
// Benchmarks of batched functions: every target and layout, with operations, limits and errors
// beside times. Names read family/op/n<order>/<layout>/<items>/<target>.
#ifndef GAUNT_BENCH_SUPPORT_H_
#define GAUNT_BENCH_SUPPORT_H_

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy.h"
#include "gaunt/gaunt.h"
#include "simd/count.h"

namespace gaunt::bench {

// Sizes: in cache and not a power of two; the same with one; out of every cache.
inline constexpr size_t kSmall = 1000, kPowerOfTwo = 1024, kLarge = 1u << 20;

struct BatchBenchmark {
  using Views = std::vector<const gaunt_view*>;

  std::string name;  // family/op/n<order>
  Operations operations;
  std::vector<size_t> inputs;  // planes
  std::vector<size_t> outputs;
  std::function<gaunt_status(size_t count, const Views& in, const Views& out)> call;
  // Fills an item of input `side`; by default with numbers in [-1, 1].
  std::function<void(size_t item, size_t side, float* planes)> make;
  bool large = false;             // out of cache too
  std::vector<size_t> broadcast;  // inputs that are one item for all
  // Bytes per item that are not in views: packed records, indices, weights.
  size_t more_read = 0, more_written = 0;
  bool reads_output = false;
  Reference reference;  // of the first output; where given, errors are measured
  // "job: method" in words. `gaunt chart` draws rows that have one, and compares those of a job.
  std::string label;
};

void RegisterBatch(const BatchBenchmark& batch);

// A scalar loop over interleaved items, for comparison:
// family/op/n<order>/interleaved/<items>/<baseline>.
struct ScalarBenchmark {
  std::string name;            // family/op/n<order>
  std::string baseline;        // "scalar"
  std::vector<size_t> inputs;  // planes
  size_t output = 0;
  std::vector<size_t> broadcast;  // inputs that are one item for all
  std::function<void(size_t count, const std::vector<const float*>& in, float* out)> call;
  // As those of BatchBenchmark.
  bool large = false;
  std::function<void(size_t item, size_t side, float* planes)> make;
  Reference reference;
  std::string label;
};
void RegisterScalar(const ScalarBenchmark& scalar);

// Numbers in [-1, 1], and unit vectors, for inputs.
void MakeNoise(size_t item, size_t side, size_t planes, float* out);
void MakeDirection(size_t item, size_t side, float* planes);

// Each family's registration, called by main.
#define GAUNT_BENCHMARKS(family) void RegisterBenchmarks_##family()

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_SUPPORT_H_
