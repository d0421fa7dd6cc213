// SPDX-License-Identifier: MIT
#include "bench/support.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/limits.h"

namespace gaunt::bench {
namespace {

double Now() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// Runs the timed loop; returns nanoseconds per iteration.
template <class Call>
double Time(benchmark::State& state, const Call& call) {
  const double start = Now();
  size_t iterations = 0;
  for (auto _ : state) {
    call();
    benchmark::ClobberMemory();
    ++iterations;
  }
  return (Now() - start) / static_cast<double>(iterations);
}

void Fill(const std::function<void(size_t, size_t, float*)>& make, size_t side, Planes& planes) {
  planes.Fill([&](size_t i, float* item) {
    if (make) return make(i, side, item);
    MakeNoise(i, side, planes.planes(), item);
  });
}

bool IsBroadcast(const std::vector<size_t>& broadcast, size_t side) {
  return std::count(broadcast.begin(), broadcast.end(), side) != 0;
}

// Null without a reference.
std::shared_ptr<Accuracy> MakeAccuracy(const Reference& reference) {
  return reference ? std::make_shared<Accuracy>(reference) : nullptr;
}

// Errors over some hundreds of items; where sides are one item for all, over several such items, so
// that they are of the same inputs as where each item has its own.
template <class Call>
Errors MeasureErrors(Accuracy& accuracy, size_t count, const std::vector<size_t>& broadcast,
                     const std::function<void(size_t, size_t, float*)>& make,
                     std::vector<Planes>& in, const Planes& out, const Call& call) {
  constexpr size_t kChecked = 256, kVariants = 32;
  if (broadcast.empty()) return accuracy.Measure(count, 0, kChecked, in, out);
  Errors all;
  double squared = 0.0, relative = 0.0;
  for (size_t variant = 0; variant < kVariants; ++variant) {
    for (const size_t side : broadcast) {
      in[side].Fill([&](size_t, float* item) { make(variant, side, item); });
    }
    call();
    const Errors errors = accuracy.Measure(count, variant, kChecked / kVariants, in, out);
    all.largest = std::max(all.largest, errors.largest);
    all.rounding = std::max(all.rounding, errors.rounding);
    squared += errors.rms * errors.rms;
    relative += errors.relative * errors.relative;
  }
  all.rms = std::sqrt(squared / kVariants);
  all.relative = std::sqrt(relative / kVariants);
  return all;
}

void SetErrors(benchmark::State& state, const Errors& errors) {
  if (std::isnan(errors.rms)) return state.SkipWithError("an output is not a number");
  state.counters["error"] = errors.largest;
  state.counters["error_rms"] = errors.rms;
  state.counters["error_rounding"] = errors.rounding;
  state.counters["error_relative"] = errors.relative;
}

void RunBatch(benchmark::State& state, const BatchBenchmark& batch, Layout layout, size_t count,
              const std::string& target, Accuracy* accuracy) {
  if (gaunt_target_select(target.c_str()) != GAUNT_OK) {
    return state.SkipWithError("target does not run here");
  }
  std::vector<Planes> in, out;
  const auto is_broadcast = [&](size_t side) { return IsBroadcast(batch.broadcast, side); };
  for (size_t side = 0; side < batch.inputs.size(); ++side) {
    in.emplace_back(is_broadcast(side) ? Layout::kBroadcast : layout, count, batch.inputs[side]);
  }
  for (const size_t planes : batch.outputs) out.emplace_back(layout, count, planes);
  BatchBenchmark::Views in_views, out_views;
  size_t read = batch.more_read, written = batch.more_written;
  for (size_t side = 0; side < in.size(); ++side) {
    Fill(batch.make, side, in[side]);
    in_views.push_back(in[side].view());
    if (!is_broadcast(side)) read += batch.inputs[side] * sizeof(float);
  }
  for (size_t side = 0; side < out.size(); ++side) {
    out_views.push_back(out[side].view());
    written += batch.outputs[side] * sizeof(float);
  }
  if (batch.call(count, in_views, out_views) != GAUNT_OK) {
    return state.SkipWithError("the call failed");
  }
  const auto call = [&] { batch.call(count, in_views, out_views); };
  const double time = Time(state, call);
  const double per_item = time / static_cast<double>(count);
  const size_t working_set = (read + written) * count;
  if (batch.reads_output) read += written;
  const double limit = LimitOf(batch.operations, read, written, working_set);
  state.SetLabel(batch.label);
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * count));
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * count * (read + written)));
  state.counters["ns_item"] = per_item;
  state.counters["mul"] = static_cast<double>(batch.operations.mul);
  state.counters["fma"] = static_cast<double>(batch.operations.fma);
  state.counters["add"] = static_cast<double>(batch.operations.add);
  state.counters["ns_multiply"] = MeasureArithmetic().fma;
  state.counters["limit_ns"] = limit;
  state.counters["x_limit"] = per_item / limit;
  if (accuracy != nullptr) {
    SetErrors(state,
              MeasureErrors(*accuracy, count, batch.broadcast, batch.make, in, out[0], call));
  }
  gaunt_target_select(nullptr);
}

void RunScalar(benchmark::State& state, const ScalarBenchmark& scalar, size_t count,
               Accuracy* accuracy) {
  std::vector<Planes> in;
  std::vector<const float*> pointers;
  for (size_t side = 0; side < scalar.inputs.size(); ++side) {
    in.emplace_back(IsBroadcast(scalar.broadcast, side) ? Layout::kBroadcast : Layout::kInterleaved,
                    count, scalar.inputs[side]);
    Fill(scalar.make, side, in[side]);
  }
  for (const Planes& side : in) pointers.push_back(side.view()->data);
  const Planes out(Layout::kInterleaved, count, scalar.output);
  const auto call = [&] { scalar.call(count, pointers, out.view()->data); };
  const double time = Time(state, call);
  state.SetLabel(scalar.label);
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * count));
  state.counters["ns_item"] = time / static_cast<double>(count);
  if (accuracy != nullptr) {
    SetErrors(state, MeasureErrors(*accuracy, count, scalar.broadcast, scalar.make, in, out, call));
  }
}

}  // namespace

void RegisterBatch(const BatchBenchmark& batch) {
  const std::shared_ptr<Accuracy> accuracy = MakeAccuracy(batch.reference);
  for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
    const std::string target = gaunt_target_supported(t);
    for (const Layout layout : {Layout::kTiled, Layout::kPlanar, Layout::kInterleaved}) {
      for (const size_t count : {kSmall, kPowerOfTwo, kLarge}) {
        if (count == kLarge && !batch.large) continue;
        const std::string name =
            batch.name + "/" + Name(layout) + "/" + std::to_string(count) + "/" + target;
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          RunBatch(state, batch, layout, count, target, accuracy.get());
        });
      }
    }
  }
}

void RegisterScalar(const ScalarBenchmark& scalar) {
  const std::shared_ptr<Accuracy> accuracy = MakeAccuracy(scalar.reference);
  for (const size_t count : {kSmall, kPowerOfTwo, kLarge}) {
    if (count == kLarge && !scalar.large) continue;
    const std::string name =
        scalar.name + "/interleaved/" + std::to_string(count) + "/" + scalar.baseline;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      RunScalar(state, scalar, count, accuracy.get());
    });
  }
}

void MakeNoise(size_t item, size_t side, size_t planes, float* out) {
  for (size_t p = 0; p < planes; ++p) {
    const double x = std::sin(static_cast<double>((item * 97 + side) * 31 + p)) * 43758.5453;
    out[p] = static_cast<float>(2.0 * (x - std::floor(x)) - 1.0);
  }
}

void MakeDirection(size_t item, size_t, float* planes) {
  const double turn = 2.39996322972865332 * static_cast<double>(item);
  const double fraction = 0.6180339887498949 * static_cast<double>(item);
  const double z = 1.0 - 2.0 * (fraction - std::floor(fraction));
  const double r = std::sqrt(1.0 - z * z);
  planes[0] = static_cast<float>(r * std::cos(turn));
  planes[1] = static_cast<float>(r * std::sin(turn));
  planes[2] = static_cast<float>(z);
}

}  // namespace gaunt::bench
