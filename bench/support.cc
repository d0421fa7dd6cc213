// SPDX-License-Identifier: MIT
#include "bench/support.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/limits.h"

namespace gaunt::bench {
namespace {

constexpr size_t kLine = 64;

const char* Name(Layout layout) {
  switch (layout) {
    case Layout::kPlanar: return "planar";
    case Layout::kInterleaved: return "interleaved";
    case Layout::kTiled: return "tiled";
    case Layout::kBroadcast: return "broadcast";
  }
  return "";
}

// Planes of a batch in cache-line-aligned memory. Planar data is laid out as it comes, so that 1024
// items are 4 KiB from plane to plane.
class Planes {
 public:
  Planes(Layout layout, size_t count, size_t planes)
      : count_(count), planes_(planes), memory_((count + 64) * planes + 64) {
    void* at = memory_.data();
    size_t room = memory_.size() * sizeof(float);
    float* data = static_cast<float*>(std::align(kLine, kLine, at, room));
    switch (layout) {
      case Layout::kPlanar:
        gaunt_view_planar(data, static_cast<ptrdiff_t>(count * sizeof(float)), &view_);
        break;
      case Layout::kInterleaved: gaunt_view_interleaved(data, planes, &view_); break;
      case Layout::kTiled: gaunt_view_tiled(data, planes, &view_); break;
      case Layout::kBroadcast: gaunt_view_broadcast(data, &view_); break;
    }
  }

  const gaunt_view* view() const { return &view_; }
  size_t bytes() const { return count_ * planes_ * sizeof(float); }

  template <class Make>
  void Fill(const Make& make) {
    std::vector<float> item(planes_);
    for (size_t i = 0; i < count_; ++i) {
      make(i, item.data());
      for (size_t p = 0; p < planes_; ++p) *Element(i, p) = item[p];
    }
  }

 private:
  float* Element(size_t i, size_t p) {
    ptrdiff_t bytes = static_cast<ptrdiff_t>(p) * view_.plane_stride;
    if (view_.tile_items == 0) {
      bytes += static_cast<ptrdiff_t>(i) * view_.item_stride;
    } else {
      bytes += static_cast<ptrdiff_t>(i / view_.tile_items) * view_.tile_stride +
               static_cast<ptrdiff_t>(i % view_.tile_items) * view_.item_stride;
    }
    return view_.data + bytes / static_cast<ptrdiff_t>(sizeof(float));
  }

  size_t count_, planes_;
  std::vector<float> memory_;
  gaunt_view view_;
};

void MakeNoise(size_t item, size_t side, size_t planes, float* out) {
  for (size_t p = 0; p < planes; ++p) {
    const double x = std::sin(static_cast<double>((item * 97 + side) * 31 + p)) * 43758.5453;
    out[p] = static_cast<float>(2.0 * (x - std::floor(x)) - 1.0);
  }
}

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

void RunBatch(benchmark::State& state, const BatchBenchmark& batch, Layout layout, size_t count,
              const std::string& target) {
  if (gaunt_target_select(target.c_str()) != GAUNT_OK) {
    return state.SkipWithError("target does not run here");
  }
  std::vector<Planes> in, out;
  const auto is_broadcast = [&](size_t side) {
    return std::count(batch.broadcast.begin(), batch.broadcast.end(), side) != 0;
  };
  for (size_t side = 0; side < batch.inputs.size(); ++side) {
    in.emplace_back(is_broadcast(side) ? Layout::kBroadcast : layout,
                    is_broadcast(side) ? 1 : count, batch.inputs[side]);
  }
  for (const size_t planes : batch.outputs) out.emplace_back(layout, count, planes);
  BatchBenchmark::Views in_views, out_views;
  size_t read = batch.more_read, written = batch.more_written;
  for (size_t side = 0; side < in.size(); ++side) {
    in[side].Fill([&](size_t i, float* item) {
      if (batch.make) return batch.make(i, side, item);
      MakeNoise(i, side, batch.inputs[side], item);
    });
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
  const double time = Time(state, [&] { batch.call(count, in_views, out_views); });
  const double per_item = time / static_cast<double>(count);
  const double limit = LimitOf(batch.operations, read, written, (read + written) * count);
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * count));
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * count * (read + written)));
  state.counters["ns_item"] = per_item;
  state.counters["mul"] = static_cast<double>(batch.operations.mul);
  state.counters["fma"] = static_cast<double>(batch.operations.fma);
  state.counters["add"] = static_cast<double>(batch.operations.add);
  state.counters["x_limit"] = per_item / limit;
  gaunt_target_select(nullptr);
}

}  // namespace

void RegisterBatch(const BatchBenchmark& batch) {
  for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
    const std::string target = gaunt_target_supported(t);
    for (const Layout layout : {Layout::kTiled, Layout::kPlanar, Layout::kInterleaved}) {
      for (const size_t count : {kSmall, kPowerOfTwo, kLarge}) {
        if (count == kLarge && !batch.large) continue;
        const std::string name =
            batch.name + "/" + Name(layout) + "/" + std::to_string(count) + "/" + target;
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          RunBatch(state, batch, layout, count, target);
        });
      }
    }
  }
}

void RegisterScalar(const ScalarBenchmark& scalar) {
  for (const size_t count : {kSmall, kPowerOfTwo}) {
    const std::string name =
        scalar.name + "/interleaved/" + std::to_string(count) + "/" + scalar.baseline;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      std::vector<float> in(count * scalar.input), out(count * scalar.output);
      for (size_t i = 0; i < count; ++i) scalar.make(i, 0, in.data() + i * scalar.input);
      const double time = Time(state, [&] { scalar.call(count, in.data(), out.data()); });
      state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * count));
      state.counters["ns_item"] = time / static_cast<double>(count);
    });
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
