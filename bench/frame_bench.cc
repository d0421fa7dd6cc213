// SPDX-License-Identifier: MIT
// The frame job against its scalar loops on synthetic probes: frame/<case>/<target or baseline>.
// Items are objects.
#include <cmath>

#include "bench/frame_baseline.h"
#include "bench/support.h"
#include "frame/job.h"

GAUNT_DECLARE_FRAME_BASELINE(baseline)
#ifdef GAUNT_HAVE_CLANG_NATIVE
GAUNT_DECLARE_FRAME_BASELINE(baseline_clang_native)
#endif

namespace gaunt::bench {
namespace {

constexpr size_t kFrames = 4;  // of taps, one after the other

// Objects in a grid of probes that is 16 wide and 128 to a layer; near objects share probes.
struct FrameData {
  size_t objects, probes;
  std::vector<uint8_t> packed, rotates;
  std::vector<uint32_t> indices[kFrames];
  std::vector<float> weights, quaternions;

  FrameData(size_t object_count, size_t probe_count)
      : objects(object_count),
        probes(probe_count),
        packed(probe_count * 28),
        rotates(object_count),
        weights(object_count * 8),
        quaternions(object_count * 4) {
    uint32_t state = 1;
    const auto random = [&state] { return (state = state * 1664525u + 1013904223u) >> 8; };
    for (size_t k = 0; k < packed.size(); ++k) {
      packed[k] = static_cast<uint8_t>(k % 28 == 3 ? 0x7C + random() % 4 : random() % 255 + 129);
    }
    for (size_t i = 0; i < objects; ++i) {
      for (int t = 0; t < 8; ++t) {
        weights[8 * i + static_cast<size_t>(t)] = static_cast<float>(random() % 1000) * 2.5e-4f;
      }
      rotates[i] = random() % 10 < 3 ? 1 : 0;
      if (!rotates[i]) continue;
      float *q = quaternions.data() + 4 * i, length = 0.0f;
      for (int k = 0; k < 4; ++k) {
        q[k] = static_cast<float>(random() % 2001) * 1e-3f - 1.0f;
        length += q[k] * q[k];
      }
      for (int k = 0; k < 4; ++k) q[k] /= std::sqrt(length);
    }
    for (auto& frame : indices) {
      frame.resize(objects * 8);
      const uint32_t base = random();
      for (size_t i = 0; i < objects; ++i) {
        const uint32_t corner = static_cast<uint32_t>((base + i * 3 + random() % 16) %
                                                      (probes > 146 ? probes - 146 : 1));
        for (uint32_t t = 0; t < 8; ++t) {
          frame[8 * i + t] = corner + (t & 1) + 16 * (t >> 1 & 1) + 128 * (t >> 2);
        }
      }
    }
  }
};

void RunJob(benchmark::State& state, const std::shared_ptr<FrameData>& data,
            const std::string& target) {
  gaunt_target_select(target.c_str());
  tool::LightJob job(data->objects);
  size_t frame = 0;
  for (auto _ : state) {
    job.Run({data->objects, data->packed.data(), data->probes,
             data->indices[frame++ % kFrames].data(), data->weights.data(), 0.25f,
             data->quaternions.data()});
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * data->objects));
  gaunt_target_select(nullptr);
}

void RunBaseline(benchmark::State& state, const std::shared_ptr<FrameData>& data,
                 void (*run)(const FrameBaselineJob&)) {
  std::vector<float> history(data->objects * 27), constants(data->objects * 28),
      light(data->objects * 9);
  size_t frame = 0;
  for (auto _ : state) {
    run({data->objects, data->packed.data(), data->indices[frame++ % kFrames].data(),
         data->weights.data(), history.data(), 0.25f, data->quaternions.data(),
         data->rotates.data(), constants.data(), light.data(), nullptr});
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * data->objects));
}

}  // namespace

GAUNT_BENCHMARKS(frame) {
  for (const auto& [objects, probes] : {std::pair<size_t, size_t>{200, 2048},
                                        {2000, 2048},
                                        {2000, 32768},
                                        {50000, 2048},
                                        {50000, 32768}}) {
    const auto data = std::make_shared<FrameData>(objects, probes);
    const std::string name =
        "frame/" + std::to_string(objects) + "_objects_" + std::to_string(probes) + "_probes/";
    const auto add_baseline = [&](const char* baseline, void (*run)(const FrameBaselineJob&)) {
      benchmark::RegisterBenchmark((name + baseline).c_str(),
                                   [=](benchmark::State& state) { RunBaseline(state, data, run); });
    };
    for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
      const std::string target = gaunt_target_supported(t);
      benchmark::RegisterBenchmark((name + target).c_str(),
                                   [=](benchmark::State& state) { RunJob(state, data, target); });
    }
    add_baseline("A", baseline::FrameA);
    add_baseline("A2", baseline::FrameA2);
#ifdef GAUNT_HAVE_CLANG_NATIVE
    add_baseline("A_clang_native", baseline_clang_native::FrameA);
    add_baseline("A2_clang_native", baseline_clang_native::FrameA2);
#endif
  }
}

}  // namespace gaunt::bench
