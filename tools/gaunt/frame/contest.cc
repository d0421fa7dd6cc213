// SPDX-License-Identifier: MIT
#include "frame/contest.h"

#include <time.h>

#include "bench/frame_baseline.h"
#include "frame/frame_reference.h"
#include "frame/parallel.h"

GAUNT_DECLARE_FRAME_BASELINE(baseline)

namespace gaunt::tool {
namespace {

constexpr float kAlpha = 0.25f;  // weight of a new frame
constexpr int kDirections = 48;  // at which errors are measured

double ThreadNanoseconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

Timing TimingOf(std::vector<double> samples, size_t objects) {
  std::sort(samples.begin(), samples.end());
  const double scale = 1.0 / static_cast<double>(objects);
  return {scale * samples[samples.size() / 20], scale * samples[samples.size() / 2]};
}

// One of the scalar loops, with data of its own.
class BaselineRun {
 public:
  BaselineRun(size_t count, void (*run)(const FrameBaselineJob&))
      : run_(run), history_(count * 27), constants_(count * 28), light_(count * 9) {}

  void Run(const FrameInput& input, const uint8_t* rotates) {
    run_({input.count, input.packed, input.indices, input.weights, history_.data(), input.alpha,
          input.quaternions, rotates, constants_.data(), light_.data(), nullptr});
  }

 private:
  void (*run_)(const FrameBaselineJob&);
  std::vector<float> history_, constants_, light_;
};

// E/pi of the 7 float4 in a direction.
void IrradianceOf(const float* constants, const Vec3& n, double e[3]) {
  for (int c = 0; c < 3; ++c) {
    const float *a = constants + 4 * c, *b = constants + 12 + 4 * c;
    e[c] = a[0] * n.x + a[1] * n.y + a[2] * n.z + a[3] + b[0] * n.x * n.y + b[1] * n.y * n.z +
           b[2] * n.z * n.z + b[3] * n.z * n.x + constants[24 + c] * (n.x * n.x - n.y * n.y);
  }
}

Errors ErrorsOf(const std::vector<float>& constants, const std::vector<float>& reference) {
  double error_sum = 0.0, sum = 0.0, largest = 0.0;
  for (size_t at = 0; at < constants.size(); at += LightJob::kConstants) {
    double mean = 0.0, worst = 0.0;
    for (int d = 0; d < kDirections; ++d) {
      const Vec3 n = SphereDirection(d, kDirections);
      double e[3], wanted[3];
      IrradianceOf(constants.data() + at, n, e);
      IrradianceOf(reference.data() + at, n, wanted);
      for (int c = 0; c < 3; ++c) {
        const double error = e[c] - wanted[c];
        error_sum += error * error;
        sum += wanted[c] * wanted[c];
        mean += wanted[c] / (3.0 * kDirections);
        worst = std::max(worst, std::abs(error));
      }
    }
    if (mean > 0.0) largest = std::max(largest, worst / mean);
  }
  return {sum > 0.0 ? std::sqrt(error_sum / sum) : 0.0, largest};
}

// History and light of every object in double precision.
class ReferenceRun {
 public:
  explicit ReferenceRun(size_t count) : history_(count * 27) {}

  void Blend(const ProbeVolume& volume, const Objects& objects) {
    ForTiles(objects.count(), [&](size_t i) {
      frame::BlendReference(volume.coefficients.data(), volume.grid.count(), 8,
                            objects.indices().data() + 8 * i, objects.weights().data() + 8 * i,
                            double{kAlpha}, history_.data() + 27 * i);
    });
  }

  void Light(const Objects& objects, std::vector<float>* constants, std::vector<float>* lights) {
    constants->resize(objects.count() * LightJob::kConstants);
    lights->resize(objects.count() * LightJob::kLight);
    ForTiles(objects.count(), [&](size_t i) {
      const float* q = objects.quaternions().data() + 4 * i;
      const double quaternion[4] = {q[0], q[1], q[2], q[3]};
      double k[LightJob::kConstants], light[LightJob::kLight];
      frame::LightReference(history_.data() + 27 * i, quaternion, objects.rotates()[i] != 0, k,
                            light, light + 3, light + 6);
      for (size_t p = 0; p < LightJob::kConstants; ++p) {
        (*constants)[LightJob::kConstants * i + p] = static_cast<float>(k[p]);
      }
      for (size_t p = 0; p < LightJob::kLight; ++p) {
        (*lights)[LightJob::kLight * i + p] = static_cast<float>(light[p]);
      }
    });
  }

 private:
  static void ForTiles(size_t count, const std::function<void(size_t)>& object) {
    constexpr size_t kTile = 256;
    ParallelFor(static_cast<int>((count + kTile - 1) / kTile), [&](int tile) {
      const size_t first = static_cast<size_t>(tile) * kTile;
      for (size_t i = first; i < std::min(count, first + kTile); ++i) object(i);
    });
  }

  std::vector<double> history_;
};

}  // namespace

ContestResult RunContest(const ProbeVolume& volume, uint32_t format,
                         const std::vector<uint8_t>& packed, Objects* objects, int frames,
                         const std::function<void(double)>& progress) {
  const size_t count = objects->count();
  LightJob job(count), steps(count);
  BaselineRun a(count, baseline::FrameA), a2(count, baseline::FrameA2);
  ReferenceRun reference(count);
  // The scalar loops know one format.
  const int runs = format == GAUNT_FORMAT_SH3_28 ? 4 : 2;
  std::vector<double> samples[4], step_samples[kSteps];
  ContestResult result = {};
  FrameInput input = {};
  for (int frame = 0; frame < frames; ++frame) {
    objects->MoveTo(frame, volume.grid);
    input = {count,
             format,
             packed.data(),
             volume.grid.count(),
             objects->indices().data(),
             objects->weights().data(),
             kAlpha,
             objects->quaternions().data()};
    const uint8_t* rotates = objects->rotates().data();
    StepTimes times = {};
    // In turn, so that a slow moment of the machine meets all of them.
    for (int turn = 0; turn < runs; ++turn) {
      const int who = (frame + turn) % runs;
      const double start = ThreadNanoseconds();
      if (who == 0) job.Run(input);
      if (who == 1) steps.RunSteps(input, &times);
      if (who == 2) a.Run(input, rotates);
      if (who == 3) a2.Run(input, rotates);
      samples[who].push_back(ThreadNanoseconds() - start);
    }
    for (size_t k = 0; k < kSteps; ++k) step_samples[k].push_back(times[k]);
    reference.Blend(volume, *objects);
    if (progress) progress(static_cast<double>(frame + 1) / frames);
  }
  reference.Light(*objects, &result.reference_constants, &result.reference_lights);
  result.constants = job.constants();
  result.lights = job.lights();
  result.errors = ErrorsOf(result.constants, result.reference_constants);
  result.gaunt = TimingOf(samples[0], count);
  for (size_t k = 0; k < kSteps; ++k) {
    result.steps[k] = TimingOf(step_samples[k], count).median;
  }
  if (runs == 4) {
    result.baselines = {{"A", GAUNT_BASELINE_COMPILER, TimingOf(samples[2], count)},
                        {"A2", GAUNT_BASELINE_COMPILER, TimingOf(samples[3], count)}};
  }
  return result;
}

}  // namespace gaunt::tool
