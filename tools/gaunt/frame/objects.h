// SPDX-License-Identifier: MIT
// Objects that move through a scene, the same in every run.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_OBJECTS_H_
#define GAUNT_TOOLS_GAUNT_FRAME_OBJECTS_H_

#include <cstdint>
#include <vector>

#include "frame/bake.h"
#include "frame/scene.h"

namespace gaunt::tool {

class Objects {
 public:
  Objects(const Scene& scene, size_t count);

  size_t count() const { return start_.size(); }
  // Moves to a frame and finds the probes around each object.
  void MoveTo(int frame, const ProbeGrid& grid);

  Vec3 Position(size_t i) const { return position_[i]; }
  const std::vector<uint32_t>& indices() const { return indices_; }  // [i * 8 + tap]
  const std::vector<float>& weights() const { return weights_; }
  // x y z w; zero for the 70 % of objects that do not rotate.
  const std::vector<float>& quaternions() const { return quaternions_; }
  const std::vector<uint8_t>& rotates() const { return rotates_; }

 private:
  std::vector<Vec3> start_, reach_, axis_, position_;
  std::vector<uint32_t> indices_;
  std::vector<float> weights_, quaternions_;
  std::vector<uint8_t> rotates_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_OBJECTS_H_
