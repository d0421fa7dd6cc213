// SPDX-License-Identifier: MIT
#include "frame/job.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace gaunt::tool {
namespace {

constexpr size_t kPlanes = 27;

void Check(gaunt_status status) {
  if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
}

// Inputs are never written, but views have one type for inputs and outputs.
gaunt_view Interleaved(const float* data, size_t planes) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(data), planes, &view);
  return view;
}

gaunt_view Tiled(float* data, size_t planes) {
  gaunt_view view;
  gaunt_view_tiled(data, planes, &view);
  return view;
}

size_t WholeTiles(size_t count) { return (count + LightJob::kTile - 1) / LightJob::kTile; }

}  // namespace

struct LightJob::Tile {
  size_t first, count;
  gaunt_view history, now, rotated, alpha, quaternions, constants;
  gaunt_view light_directions, colours, ambient;  // fields of one record
};

LightJob::LightJob(size_t count)
    : history_(WholeTiles(count) * kTile * kPlanes),
      constants_(count * kConstants),
      lights_(count * kLight),
      now_(kTile * kPlanes),
      rotated_(kTile * kPlanes) {}

void LightJob::RunStep(Step step, const FrameInput& input, const Tile& tile) const {
  const size_t n = tile.count;
  switch (step) {
    case Step::kGather:
      return Check(gaunt_probe_gather(GAUNT_FORMAT_SH3_28, 3, n, 8, input.indices + tile.first * 8,
                                      input.weights + tile.first * 8, input.packed, input.probes,
                                      28, &tile.now));
    case Step::kLerp:
      return Check(gaunt_sh_blend(3, 3, n, &tile.history, &tile.now, &tile.alpha, &tile.history));
    case Step::kRotate:
      return Check(gaunt_rotate(3, 3, n, &tile.quaternions, &tile.history, &tile.rotated));
    case Step::kDirection:
      return Check(gaunt_light_direction(3, 3, n, &tile.rotated, nullptr, &tile.light_directions));
    case Step::kExtract:
      return Check(gaunt_light_extract(3, 3, 1, GAUNT_SENSE_IRRADIANCE, n, &tile.rotated,
                                       &tile.light_directions, &tile.colours, &tile.ambient));
    case Step::kConstants:
      return Check(gaunt_irradiance_constants(3, n, &tile.rotated, &tile.constants));
  }
}

void LightJob::Run(const FrameInput& input, StepTimes* times) {
  using Clock = std::chrono::steady_clock;
  const auto nanoseconds = [](Clock::duration d) {
    return std::chrono::duration<double, std::nano>(d).count();
  };
  Tile tile;
  tile.now = Tiled(now_.data(), kPlanes);
  tile.rotated = Tiled(rotated_.data(), kPlanes);
  float alpha = input.alpha;
  gaunt_view_broadcast(&alpha, &tile.alpha);
  for (size_t first = 0; first < input.count; first += kTile) {
    tile.first = first;
    tile.count = std::min(kTile, input.count - first);
    tile.history = Tiled(history_.data() + first * kPlanes, kPlanes);
    tile.quaternions = Interleaved(input.quaternions + first * 4, 4);
    tile.constants = Interleaved(constants_.data() + first * kConstants, kConstants);
    tile.light_directions = Interleaved(lights_.data() + first * kLight, kLight);
    tile.colours = tile.ambient = tile.light_directions;
    tile.colours.data += 3;
    tile.ambient.data += 6;
    for (int step = 0; step < kSteps; ++step) {
      if (times == nullptr) {
        RunStep(static_cast<Step>(step), input, tile);
        continue;
      }
      const auto start = Clock::now();
      RunStep(static_cast<Step>(step), input, tile);
      const auto end = Clock::now();
      // What reading the clock costs is not the step's.
      (*times)[static_cast<size_t>(step)] +=
          nanoseconds(end - start) - nanoseconds(Clock::now() - end);
    }
  }
}

}  // namespace gaunt::tool
