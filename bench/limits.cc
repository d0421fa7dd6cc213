// SPDX-License-Identifier: MIT
#include "bench/limits.h"

#include <time.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/limits.cc"
#include <hwy/foreach_target.h>

#include "simd/lanes-inl.h"
#include "simd/target.h"

namespace gaunt::bench {
#ifndef GAUNT_BENCH_LIMITS_TABLE_
#define GAUNT_BENCH_LIMITS_TABLE_
struct Table {
  size_t (*fma)(size_t rounds, float* out);  // each returns the lanes' operations that it did
  size_t (*add)(size_t rounds, float* out);
  size_t (*div)(size_t rounds, float* out);
  void (*load)(const float* data, size_t floats, float* out);
  void (*store)(float* data, size_t floats);
  void (*stream)(float* data, size_t floats);
  void (*copy)(const float* from, float* to, size_t floats);
  void (*stream_copy)(const float* from, float* to, size_t floats);
};
#endif
}  // namespace gaunt::bench

HWY_BEFORE_NAMESPACE();
namespace gaunt::bench::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)
using V = hn::Vec<LaneTag>;

// Twelve chains hide the latency of every pipe there is.
template <class Step>
GAUNT_LANES size_t RunChains(size_t rounds, float* out, const Step& step) {
  const LaneTag d;
  V a = hn::Set(d, 1.0f), b = hn::Set(d, 1.1f), c = hn::Set(d, 1.2f), e = hn::Set(d, 1.3f);
  V f = hn::Set(d, 1.4f), g = hn::Set(d, 1.5f), h = hn::Set(d, 1.6f), i = hn::Set(d, 1.7f);
  V j = hn::Set(d, 1.8f), l = hn::Set(d, 1.9f), m = hn::Set(d, 2.0f), n = hn::Set(d, 2.1f);
  for (size_t r = 0; r < rounds; ++r) {
    a = step(a), b = step(b), c = step(c), e = step(e), f = step(f), g = step(g);
    h = step(h), i = step(i), j = step(j), l = step(l), m = step(m), n = step(n);
  }
  const V ab = Add(Add(a, b), Add(c, e)), fg = Add(Add(f, g), Add(h, i));
  hn::StoreU(Add(Add(ab, fg), Add(Add(j, l), Add(m, n))), d, out);
  return 12 * rounds * hn::Lanes(d);
}

struct FmaStep {
  V x, y;
  GAUNT_LANES V operator()(V v) const { return MulAdd(v, x, y); }
};
struct AddStep {
  V x;
  GAUNT_LANES V operator()(V v) const { return Add(v, x); }
};
struct DivStep {
  V x;
  GAUNT_LANES V operator()(V v) const { return Sqrt(Div(x, v)); }
};

size_t RunFma(size_t rounds, float* out) {
  const LaneTag d;
  return RunChains(rounds, out, FmaStep{hn::Set(d, 0.999f), hn::Set(d, 0.001f)});
}
size_t RunAdd(size_t rounds, float* out) {
  return RunChains(rounds, out, AddStep{hn::Set(LaneTag(), 1e-6f)});
}
size_t RunDiv(size_t rounds, float* out) {
  return 2 * RunChains(rounds, out, DivStep{hn::Set(LaneTag(), 1.5f)});
}

void RunLoad(const float* data, size_t floats, float* out) {
  const LaneTag d;
  const size_t step = hn::Lanes(d);
  V a = hn::Zero(d), b = a, c = a, e = a;
  for (size_t i = 0; i + 4 * step <= floats; i += 4 * step) {
    a = Max(a, hn::LoadU(d, data + i));
    b = Max(b, hn::LoadU(d, data + i + step));
    c = Max(c, hn::LoadU(d, data + i + 2 * step));
    e = Max(e, hn::LoadU(d, data + i + 3 * step));
  }
  hn::StoreU(Add(Add(a, b), Add(c, e)), d, out);
}

struct StoreStep {
  GAUNT_LANES void operator()(V value, float* to) const { hn::StoreU(value, LaneTag(), to); }
};
// Past the caches; of lines that are written whole.
struct StreamStep {
  GAUNT_LANES void operator()(V value, float* to) const { hn::Stream(value, LaneTag(), to); }
};

template <class Step>
GAUNT_LANES void RunStores(float* data, size_t floats, const Step& store) {
  const LaneTag d;
  const size_t step = hn::Lanes(d);
  const V value = hn::Set(d, 1.0f);
  for (size_t i = 0; i + 4 * step <= floats; i += 4 * step) {
    store(value, data + i);
    store(value, data + i + step);
    store(value, data + i + 2 * step);
    store(value, data + i + 3 * step);
  }
}

void RunStore(float* data, size_t floats) { RunStores(data, floats, StoreStep()); }
void RunStream(float* data, size_t floats) { RunStores(data, floats, StreamStep()); }

template <class Step>
GAUNT_LANES void RunCopies(const float* from, float* to, size_t floats, const Step& store) {
  const LaneTag d;
  const size_t step = hn::Lanes(d);
  for (size_t i = 0; i + 4 * step <= floats; i += 4 * step) {
    store(hn::LoadU(d, from + i), to + i);
    store(hn::LoadU(d, from + i + step), to + i + step);
    store(hn::LoadU(d, from + i + 2 * step), to + i + 2 * step);
    store(hn::LoadU(d, from + i + 3 * step), to + i + 3 * step);
  }
}

void RunCopy(const float* from, float* to, size_t floats) {
  RunCopies(from, to, floats, StoreStep());
}
void RunStreamCopy(const float* from, float* to, size_t floats) {
  RunCopies(from, to, floats, StreamStep());
}

const Table* GetTable() {
  static constexpr Table kTable = {&RunFma,   &RunAdd,    &RunDiv,  &RunLoad,
                                   &RunStore, &RunStream, &RunCopy, &RunStreamCopy};
  return &kTable;
}

}  // namespace gaunt::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#include "simd/export-inl.h"
GAUNT_EXPORT_FAMILY(bench);

#if HWY_ONCE
namespace gaunt::bench {
namespace {

double Now() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// Least of several runs: a limit is what the machine can do, not what it does on average.
template <class Run>
double Best(const Run& run) {
  double best = 1e300;
  for (int k = 0; k < 15; ++k) {
    const double start = Now();
    run();
    best = std::min(best, Now() - start);
  }
  return best;
}

}  // namespace

const ArithmeticLimits& MeasureArithmetic() {
  static std::map<std::string, ArithmeticLimits> measured;
  const auto [entry, is_new] = measured.try_emplace(simd::ChosenTargetName());
  if (is_new) {
    const Table& kernels = Kernels();
    float out[64];
    size_t operations = 0;
    const auto per_lane = [&](auto run, size_t rounds) {
      const double time = Best([&] { operations = run(rounds, out); });
      return time / static_cast<double>(operations);
    };
    entry->second = {per_lane(kernels.fma, 20000), per_lane(kernels.add, 20000),
                     per_lane(kernels.div, 2000)};
  }
  return entry->second;
}

const MemoryLimits& MeasureMemory(size_t working_set) {
  // The largest size that is not above it, in steps of sqrt(2).
  constexpr size_t kSmallest = 16u << 10, kLargest = 128u << 20;
  size_t bytes = kSmallest;
  while (bytes < kLargest && bytes * 2 <= working_set) bytes *= 2;
  if (bytes < kLargest && bytes * 181 / 128 <= working_set) bytes = bytes * 181 / 128;
  static std::map<std::pair<std::string, size_t>, MemoryLimits> measured;
  const auto [entry, is_new] = measured.try_emplace({simd::ChosenTargetName(), bytes});
  if (is_new) {
    const size_t floats = bytes / sizeof(float);
    constexpr size_t kLine = 16;
    std::vector<float> memory(floats + kLine, 1.0f);
    float* const data =
        memory.data() +
        (kLine - reinterpret_cast<uintptr_t>(memory.data()) / sizeof(float) % kLine) % kLine;
    float out[64];
    const size_t times = std::max<size_t>(1, (4u << 20) / bytes);
    const auto per_byte = [&](auto run) {
      return Best([&] {
               for (size_t k = 0; k < times; ++k) run();
             }) /
             static_cast<double>(bytes * times);
    };
    const Table& kernels = Kernels();
    const size_t half = floats / 2;
    entry->second = {
        per_byte([&] { kernels.load(data, floats, out); }),
        std::min(per_byte([&] { kernels.store(data, floats); }),
                 per_byte([&] { kernels.stream(data, floats); })),
        2.0 * std::min(per_byte([&] { kernels.copy(data, data + half, half); }),
                       per_byte([&] { kernels.stream_copy(data, data + half, half); }))};
  }
  return entry->second;
}

double LimitOf(const Operations& operations, size_t bytes_read, size_t bytes_written,
               size_t working_set) {
  const ArithmeticLimits& arithmetic = MeasureArithmetic();
  const MemoryLimits& memory = MeasureMemory(working_set);
  return std::max({static_cast<double>(operations.Multiplies()) * arithmetic.fma,
                   static_cast<double>(operations.add) * arithmetic.add,
                   static_cast<double>(operations.div) * arithmetic.div,
                   static_cast<double>(bytes_read) * memory.load,
                   static_cast<double>(bytes_written) * memory.store,
                   static_cast<double>(std::min(bytes_read, bytes_written)) * memory.copy});
}

}  // namespace gaunt::bench
#endif
