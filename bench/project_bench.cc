// SPDX-License-Identifier: MIT
#include <chrono>

#include "bench/limits.h"
#include "bench/support.h"

namespace gaunt::bench {

// Items are texels of a 1024 x 512 RGB panorama.
GAUNT_BENCHMARKS(project) {
  constexpr uint32_t kWidth = 1024, kHeight = 512;
  const auto texels = std::make_shared<std::vector<float>>(size_t{kWidth} * kHeight * 3, 0.5f);
  for (const uint32_t n : {3u, 6u}) {
    for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
      const std::string target = gaunt_target_supported(t);
      const std::string name =
          "project/equirect/n" + std::to_string(n) + "/rgb32f/1024x512/" + target;
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        gaunt_target_select(target.c_str());
        const gaunt_image image = {texels->data(), kWidth,         kHeight, 12,
                                   12 * kWidth,    GAUNT_TEXEL_F32};
        std::vector<float> out(3 * n * n);
        gaunt_view view;
        gaunt_view_interleaved(out.data(), 3 * n * n, &view);
        const Operations texel = 3 * OperationsOf("project_equirect", std::to_string(n), "mono");
        constexpr size_t kTexels = size_t{kWidth} * kHeight;
        const double limit = LimitOf(texel, 12, 0, 12 * kTexels);
        const auto start = std::chrono::steady_clock::now();
        for (auto _ : state) gaunt_project_equirect(n, 3, &image, nullptr, &view);
        const std::chrono::duration<double, std::nano> time =
            std::chrono::steady_clock::now() - start;
        const double items = static_cast<double>(state.iterations()) * kTexels;
        state.counters["ns_item"] = time.count() / items;
        state.counters["x_limit"] = time.count() / items / limit;
        state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * kWidth * kHeight);
        state.SetBytesProcessed(static_cast<int64_t>(state.iterations()) * kWidth * kHeight * 12);
        state.counters["mul"] = static_cast<double>(texel.mul);
        state.counters["fma"] = static_cast<double>(texel.fma);
        state.counters["add"] = static_cast<double>(texel.add);
        gaunt_target_select(nullptr);
      });
    }
  }
}

}  // namespace gaunt::bench
