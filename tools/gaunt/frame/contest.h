// SPDX-License-Identifier: MIT
// The main job against its steps and the scalar loops, frame by frame in turn, and against double
// precision.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_CONTEST_H_
#define GAUNT_TOOLS_GAUNT_FRAME_CONTEST_H_

#include <functional>
#include <string>
#include <vector>

#include "frame/bake.h"
#include "frame/job.h"
#include "frame/objects.h"

namespace gaunt::tool {

// Nanoseconds per object over the frames.
struct Timing {
  double p05, median;
};

struct Baseline {
  std::string name, compiler;
  Timing timing;
};

// Of E/pi, over objects, directions and channels.
struct Errors {
  double rms;      // relative to the RMS of the reference
  double largest;  // relative to the mean of the object's reference
};

struct ContestResult {
  Timing gaunt;
  StepTimes steps;                  // the same by the functions of the steps: medians of each
  std::vector<Baseline> baselines;  // of GAUNT_FORMAT_SH3_28 alone
  Errors errors;
  std::vector<float> constants, lights;                      // of the last frame, packed
  std::vector<float> reference_constants, reference_lights;  // from unpacked probes
};

// Lights the objects for a number of frames; they end in the last one.
ContestResult RunContest(const ProbeVolume& volume, uint32_t format,
                         const std::vector<uint8_t>& packed, Objects* objects, int frames,
                         const std::function<void(double)>& progress);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_CONTEST_H_
