// SPDX-License-Identifier: MIT
#include <time.h>

#include "bench/limits.h"
#include "bench/project_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {
namespace {

double Now() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// One call over `items` texels or samples of `bytes` each.
struct Job {
  std::string name;
  size_t items;
  size_t bytes;
  Operations operations;  // of an item
  std::function<void()> call;
};

void Run(benchmark::State& state, const Job& job, bool with_limit) {
  const double start = Now();
  for (auto _ : state) {
    job.call();
    benchmark::ClobberMemory();
  }
  const double items = static_cast<double>(state.iterations()) * static_cast<double>(job.items);
  const double per_item = (Now() - start) / items;
  state.counters["ns_item"] = per_item;
  if (with_limit) {
    state.counters["x_limit"] =
        per_item / LimitOf(job.operations, job.bytes, 0, job.bytes * job.items);
    state.counters["mul"] = static_cast<double>(job.operations.mul);
    state.counters["fma"] = static_cast<double>(job.operations.fma);
    state.counters["add"] = static_cast<double>(job.operations.add);
  }
  const int64_t all = state.iterations() * static_cast<int64_t>(job.items);
  state.SetItemsProcessed(all);
  state.SetBytesProcessed(all * static_cast<int64_t>(job.bytes));
}

void Register(const Job& job) {
  for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
    const std::string target = gaunt_target_supported(t);
    benchmark::RegisterBenchmark((job.name + "/" + target).c_str(),
                                 [job, target](benchmark::State& state) {
                                   gaunt_target_select(target.c_str());
                                   Run(state, job, true);
                                   gaunt_target_select(nullptr);
                                 });
  }
}

void RegisterScalarLoop(const Job& job) {
  benchmark::RegisterBenchmark((job.name + "/scalar").c_str(),
                               [job](benchmark::State& state) { Run(state, job, false); });
}

Operations PerItem(const char* op, uint32_t n) {
  return OperationsOf(op, std::to_string(n), "rgb");
}

std::shared_ptr<std::vector<float>> Output(uint32_t n) {
  return std::make_shared<std::vector<float>>(3 * n * n);
}
gaunt_view ViewOf(std::vector<float>& out) {
  gaunt_view view;
  gaunt_view_interleaved(out.data(), out.size(), &view);
  return view;
}

// 0.5 in every channel, as floats or halves.
std::shared_ptr<std::vector<unsigned char>> Grey(size_t channels, uint32_t type) {
  const size_t component = type == GAUNT_TEXEL_F16 ? 2 : 4;
  const auto pixels = std::make_shared<std::vector<unsigned char>>(channels * component);
  // The first byte that is not zero is the last one: 0x3800 is 0.5, and 0x3F000000.
  for (size_t i = component; i <= pixels->size(); i += component) {
    (*pixels)[i - 1] = type == GAUNT_TEXEL_F16 ? 0x38 : 0x3F;
  }
  return pixels;
}

// RGB of a cubemap of RGBA.
void RegisterCubemap(uint32_t n, uint32_t size, uint32_t type) {
  const ptrdiff_t texel = type == GAUNT_TEXEL_F16 ? 8 : 16;
  const size_t items = size_t{6} * size * size;
  const auto pixels = Grey(4 * items, type);
  const auto out = Output(n);
  Job job = {"project/cubemap/n" + std::to_string(n) +
                 (type == GAUNT_TEXEL_F16 ? "/rgba16f/" : "/rgba32f/") + std::to_string(size),
             items, static_cast<size_t>(texel), PerItem("project_cubemap", n), [=] {
               gaunt_image images[6];
               const gaunt_image* faces[6];
               for (size_t f = 0; f < 6; ++f) {
                 images[f] = {pixels->data() + f * size * size * static_cast<size_t>(texel),
                              size,
                              size,
                              texel,
                              texel * static_cast<ptrdiff_t>(size),
                              type};
                 faces[f] = &images[f];
               }
               const gaunt_view view = ViewOf(*out);
               gaunt_project_cubemap(n, 3, faces, nullptr, &view);
             }};
  Register(job);
  if (type != GAUNT_TEXEL_F32) return;
  job.call = [=] {
    const float* faces[6];
    for (size_t f = 0; f < 6; ++f) {
      faces[f] = reinterpret_cast<const float*>(pixels->data()) + f * size * size * 4;
    }
    CubemapEngine(static_cast<int>(n), size, faces, out->data());
  };
  RegisterScalarLoop(job);
}

// An RGB panorama.
void RegisterEquirect(uint32_t n) {
  constexpr uint32_t kWidth = 1024, kHeight = 512;
  constexpr size_t kItems = size_t{kWidth} * kHeight;
  const auto pixels = Grey(3 * kItems, GAUNT_TEXEL_F32);
  const auto out = Output(n);
  Job job = {"project/equirect/n" + std::to_string(n) + "/rgb32f/1024x512", kItems, 12,
             PerItem("project_equirect", n), [=] {
               const gaunt_image image = {pixels->data(), kWidth,         kHeight, 12,
                                          12 * kWidth,    GAUNT_TEXEL_F32};
               const gaunt_view view = ViewOf(*out);
               gaunt_project_equirect(n, 3, &image, nullptr, &view);
             }};
  Register(job);
  job.call = [=] {
    EquirectEngine(static_cast<int>(n), kWidth, kHeight,
                   reinterpret_cast<const float*>(pixels->data()), out->data());
  };
  RegisterScalarLoop(job);
}

// RGB samples in tiles.
void RegisterSamples(uint32_t n) {
  constexpr size_t kItems = kSmall, kPlanes = 7;  // direction, value, weight
  constexpr size_t kRoom = (kItems + GAUNT_TILE_ITEMS - 1) / GAUNT_TILE_ITEMS * GAUNT_TILE_ITEMS;
  const auto data = std::make_shared<std::vector<float>>(kRoom * kPlanes, 0.5f);
  for (size_t i = 0; i < kRoom; ++i) {
    float direction[3];
    MakeDirection(i, 0, direction);
    for (size_t k = 0; k < 3; ++k) {
      (*data)[i / GAUNT_TILE_ITEMS * 3 * GAUNT_TILE_ITEMS + k * GAUNT_TILE_ITEMS +
              i % GAUNT_TILE_ITEMS] = direction[k];
    }
  }
  const auto out = Output(n);
  Register({"project/samples/n" + std::to_string(n) + "/tiled/" + std::to_string(kItems), kItems,
            kPlanes * sizeof(float), PerItem("project_samples", n), [=] {
              gaunt_view directions, values, weights;
              gaunt_view_tiled(data->data(), 3, &directions);
              gaunt_view_tiled(data->data() + 3 * kRoom, 3, &values);
              gaunt_view_tiled(data->data() + 6 * kRoom, 1, &weights);
              const gaunt_view view = ViewOf(*out);
              gaunt_project_samples(n, 3, kItems, &directions, &values, &weights, &view);
            }});
}

}  // namespace

GAUNT_BENCHMARKS(project) {
  for (const uint32_t n : {3u, 6u}) {
    for (const uint32_t size : {64u, 256u}) {
      RegisterCubemap(n, size, GAUNT_TEXEL_F32);
      RegisterCubemap(n, size, GAUNT_TEXEL_F16);
    }
    RegisterEquirect(n);
  }
  for (const uint32_t n : {3u, 6u, 10u}) RegisterSamples(n);
}

}  // namespace gaunt::bench
