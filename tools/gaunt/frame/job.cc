// SPDX-License-Identifier: MIT
#include "frame/job.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace gaunt::tool {
namespace {

constexpr size_t kPlanes = 27;
constexpr uint32_t kTaps = 8;

void Check(gaunt_status status) {
  if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
}

gaunt_format_properties PropertiesOf(uint32_t format) {
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  Check(gaunt_format_info(format, &properties));
  return properties;
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
      gathered_(kTile * kPlanes),
      now_(kTile * kPlanes),
      rotated_(kTile * kPlanes) {}

void LightJob::Run(const FrameInput& input) {
  gaunt_view history, alpha, quaternions, constants, directions;
  gaunt_view_tiled(history_.data(), kPlanes, &history);
  float share = input.alpha;
  gaunt_view_broadcast(&share, &alpha);
  quaternions = Interleaved(input.quaternions, 4);
  constants = Interleaved(constants_.data(), kConstants);
  directions = Interleaved(lights_.data(), kLight);
  gaunt_view colours = directions, ambient = directions;  // fields of one record
  colours.data += 3;
  ambient.data += 6;
  gaunt_frame_job job = {};
  job.struct_size = sizeof(job);
  job.taps = kTaps;
  job.indices = input.indices;
  job.weights = input.weights;
  job.packed = input.packed;
  job.packed_count = input.probes;
  job.stride = PropertiesOf(input.format).bytes;
  job.history = &history;
  job.alpha = &alpha;
  job.quaternions = &quaternions;
  job.directions = &directions;
  job.colours = &colours;
  job.ambient = &ambient;
  job.constants = &constants;
  Check(gaunt_frame_light(input.format, input.count, &job));
}

// Of order 3, whatever the format's.
void LightJob::Gather(const FrameInput& input, const Tile& tile) {
  const gaunt_format_properties properties = PropertiesOf(input.format);
  const uint32_t order = std::min(properties.order, 3u);
  const size_t size = order * order;
  const gaunt_view gathered = Tiled(gathered_.data(), 3 * size);
  Check(gaunt_probe_gather(input.format, order, tile.count, kTaps,
                           input.indices + tile.first * kTaps, input.weights + tile.first * kTaps,
                           input.packed, input.probes, properties.bytes,
                           order == 3 ? &tile.now : &gathered));
  if (order == 3) return;
  constexpr size_t kItems = GAUNT_TILE_ITEMS;
  for (size_t i = 0; i < kTile / kItems; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const float* const from = gathered_.data() + (i * 3 + c) * size * kItems;
      std::copy(from, from + size * kItems, now_.data() + (i * 3 + c) * 9 * kItems);
    }
  }
}

void LightJob::RunStep(Step step, const FrameInput& input, const Tile& tile) {
  const size_t n = tile.count;
  switch (step) {
    case Step::kGather: return Gather(input, tile);
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

void LightJob::RunSteps(const FrameInput& input, StepTimes* times) {
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
