// SPDX-License-Identifier: MIT
// The frame job, in one call and by steps, against its scalar loops on synthetic probes:
// frame/<case>/<target or baseline>. Items are objects.
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/frame_baseline.h"
#include "bench/support.h"
#include "format_table.h"
#include "frame/job.h"

GAUNT_DECLARE_FRAME_BASELINE(baseline)
#ifdef GAUNT_HAVE_CLANG_NATIVE
GAUNT_DECLARE_FRAME_BASELINE(baseline_clang_native)
#endif

namespace gaunt::bench {
namespace {

constexpr size_t kFrames = 4;  // of taps, one after the other

struct FrameCase {
  size_t objects, probes;
  bool coherent;  // near objects have near probes; else anywhere
  uint32_t format;

  bool operator==(const FrameCase& o) const {
    return objects == o.objects && probes == o.probes && coherent == o.coherent &&
           format == o.format;
  }
};

// Objects in a grid of probes: 16 wide and 128 to a layer or, of a million, 100 and 10000.
struct FrameData {
  FrameCase from;
  std::vector<uint8_t> packed, rotates;
  std::vector<uint32_t> indices[kFrames];
  std::vector<float> weights, quaternions;

  explicit FrameData(const FrameCase& f)
      : from(f), rotates(f.objects), weights(f.objects * 8), quaternions(f.objects * 4) {
    MakeRecords();
    for (size_t i = 0; i < f.objects; ++i) {
      for (int t = 0; t < 8; ++t) {
        weights[8 * i + static_cast<size_t>(t)] = static_cast<float>(Random() % 1000) * 2.5e-4f;
      }
      rotates[i] = Random() % 10 < 3 ? 1 : 0;
      if (!rotates[i]) continue;
      float *q = quaternions.data() + 4 * i, length = 0.0f;
      for (int k = 0; k < 4; ++k) {
        q[k] = static_cast<float>(Random() % 2001) * 1e-3f - 1.0f;
        length += q[k] * q[k];
      }
      for (int k = 0; k < 4; ++k) q[k] /= std::sqrt(length);
    }
    for (auto& frame : indices) MakeTaps(&frame);
  }

 private:
  uint32_t Random() { return (state_ = state_ * 1664525u + 1013904223u) >> 8; }

  // A thousand and one different records, over and over.
  void MakeRecords() {
    constexpr size_t kDifferent = 1001;
    gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
    gaunt_format_info(from.format, &properties);
    const size_t size = properties.planes / 3;
    std::vector<float> probes(kDifferent * properties.planes);
    for (size_t k = 0; k < probes.size(); ++k) {
      const float number = static_cast<float>(Random() % 1000) * 1e-3f;
      probes[k] = k % size == 0 ? 0.5f + number : number - 0.5f;
    }
    gaunt_view view;
    gaunt_view_interleaved(probes.data(), properties.planes, &view);
    packed.resize(kDifferent * properties.bytes);
    gaunt_probe_encode(from.format, kDifferent, &view, packed.data(), properties.bytes, nullptr);
    const size_t all = from.probes * properties.bytes;
    packed.resize(std::max(all, packed.size()));
    for (size_t k = kDifferent * properties.bytes; k < all; ++k) {
      packed[k] = packed[k - kDifferent * properties.bytes];
    }
  }

  void MakeTaps(std::vector<uint32_t>* frame) {
    const bool large = from.probes >= 1000000;
    const uint32_t row = large ? 100 : 16, layer = large ? 10000 : 128;
    const size_t corners = from.probes - (layer + row + 1);
    const size_t base = Random();
    for (size_t i = 0; i < from.objects; ++i) {
      const size_t near = base + i * 3 + Random() % 16,
                   anywhere = Random() * size_t{256} + Random();
      const auto corner = static_cast<uint32_t>((from.coherent ? near : anywhere) % corners);
      for (uint32_t t = 0; t < 8; ++t) {
        frame->push_back(corner + (t & 1) + row * (t >> 1 & 1) + layer * (t >> 2));
      }
    }
  }

  uint32_t state_ = 1;
};

// Made where it is needed, and kept until another is.
const FrameData& DataOf(const FrameCase& from) {
  static std::unique_ptr<FrameData> last;
  if (last == nullptr || !(last->from == from)) {
    last.reset();
    last = std::make_unique<FrameData>(from);
  }
  return *last;
}

void RunJob(benchmark::State& state, const FrameCase& from, const std::string& target,
            bool by_steps) {
  const FrameData& data = DataOf(from);
  gaunt_target_select(target.c_str());
  tool::LightJob job(from.objects);
  size_t frame = 0;
  const auto run = [&] {
    const tool::FrameInput input = {from.objects,
                                    from.format,
                                    data.packed.data(),
                                    from.probes,
                                    data.indices[frame++ % kFrames].data(),
                                    data.weights.data(),
                                    0.25f,
                                    data.quaternions.data()};
    by_steps ? job.RunSteps(input) : job.Run(input);
  };
  run();  // memory that has never been touched is slow
  for (auto _ : state) run();
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * from.objects));
  gaunt_target_select(nullptr);
}

void RunBaseline(benchmark::State& state, const FrameCase& from,
                 void (*light)(const FrameBaselineJob&)) {
  const FrameData& data = DataOf(from);
  std::vector<float> history(from.objects * 27), constants(from.objects * 28),
      lights(from.objects * 9);
  size_t frame = 0;
  const auto run = [&] {
    light({from.objects, data.packed.data(), data.indices[frame++ % kFrames].data(),
           data.weights.data(), history.data(), 0.25f, data.quaternions.data(), data.rotates.data(),
           constants.data(), lights.data(), nullptr});
  };
  run();
  for (auto _ : state) run();
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * from.objects));
}

void RegisterCase(const FrameCase& from, const std::string& name) {
  for (uint32_t t = 0; gaunt_target_supported(t) != nullptr; ++t) {
    const std::string target = gaunt_target_supported(t);
    for (const bool by_steps : {false, true}) {
      benchmark::RegisterBenchmark(
          (name + target + (by_steps ? "_by_steps" : "")).c_str(),
          [=](benchmark::State& state) { RunJob(state, from, target, by_steps); });
    }
  }
}

void RegisterBaselines(const FrameCase& from, const std::string& name) {
  const auto add = [&](const char* baseline, void (*run)(const FrameBaselineJob&)) {
    benchmark::RegisterBenchmark((name + baseline).c_str(),
                                 [=](benchmark::State& state) { RunBaseline(state, from, run); });
  };
  add("A", baseline::FrameA);
  add("A2", baseline::FrameA2);
#ifdef GAUNT_HAVE_CLANG_NATIVE
  add("A_clang_native", baseline_clang_native::FrameA);
  add("A2_clang_native", baseline_clang_native::FrameA2);
#endif
}

}  // namespace

GAUNT_BENCHMARKS(frame) {
  constexpr uint32_t kMain = GAUNT_FORMAT_SH3_28;  // that the scalar loops read
  for (const FrameCase& from : {FrameCase{200, 2048, true, kMain},
                                {2000, 2048, true, kMain},
                                {2000, 32768, true, kMain},
                                {2000, 1000000, true, kMain},
                                {2000, 1000000, false, kMain},
                                {50000, 2048, true, kMain},
                                {50000, 32768, true, kMain},
                                {50000, 1000000, true, kMain},
                                {50000, 1000000, false, kMain}}) {
    const std::string name = "frame/" + std::to_string(from.objects) + "_objects_" +
                             std::to_string(from.probes) + "_probes" +
                             (from.coherent ? "" : "_anywhere");
    RegisterCase(from, name + "/");
    RegisterBaselines(from, name + "/");
    if (from.objects != 2000) continue;
    for (const tool::FormatName& format : tool::kFormatNames) {
      if (format.format == kMain) continue;
      FrameCase other = from;
      other.format = format.format;
      RegisterCase(other, name + "_" + format.name + "/");
    }
  }
}

}  // namespace gaunt::bench
