// SPDX-License-Identifier: MIT
// The main job through the C API: light the dynamic objects of one frame from packed probes, by the one
// function for it or by those of its steps.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_JOB_H_
#define GAUNT_TOOLS_GAUNT_FRAME_JOB_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::tool {

// What one frame needs to know of its objects.
struct FrameInput {
  size_t count;
  uint32_t format;        // GAUNT_FORMAT_*
  const uint8_t* packed;  // records, back to back
  size_t probes;
  const uint32_t* indices;   // [i * 8 + tap]
  const float* weights;      // [i * 8 + tap]
  float alpha;               // weight of this frame against the ones before
  const float* quaternions;  // x y z w; all zero for objects that do not rotate
};

// Steps of a frame, which one after the other go over a tile of objects.
enum class Step { kGather, kLerp, kRotate, kDirection, kExtract, kConstants };
inline constexpr int kSteps = 6;
inline constexpr const char* kStepNames[kSteps] = {"gather",    "lerp",    "rotate",
                                                   "direction", "extract", "constants"};
using StepTimes = std::array<double, kSteps>;  // nanoseconds, of all objects

class LightJob {
 public:
  static constexpr size_t kTile = 256;       // objects
  static constexpr size_t kConstants = 28;  // floats per object: 7 float4
  static constexpr size_t kLight = 9;       // direction, colour, ambient

  explicit LightJob(size_t count);

  // Lights one frame, by gaunt_frame_light().
  void Run(const FrameInput& input);
  // The same, but for a rounding of one quaternion alone, by the functions of the steps. With `times`,
  // adds to the time of each step; that costs time itself.
  void RunSteps(const FrameInput& input, StepTimes* times = nullptr);

  const std::vector<float>& constants() const { return constants_; }
  const std::vector<float>& lights() const { return lights_; }

 private:
  struct Tile;  // views of a tile's data
  void RunStep(Step step, const FrameInput& input, const Tile& tile);
  void Gather(const FrameInput& input, const Tile& tile);

  std::vector<float> history_;  // tiles of 16 objects, 27 planes
  std::vector<float> constants_;
  std::vector<float> lights_;
  std::vector<float> gathered_, now_, rotated_;  // scratch of one tile
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_JOB_H_
