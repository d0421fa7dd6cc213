// SPDX-License-Identifier: MIT
// Operations of the frame job after its gather, by running its kernel on counting lanes.
#include "frame/frame-inl.h"
#include "simd/count.h"

namespace gaunt::frame {

void AppendOperations(OperationRows& rows);

void AppendOperations(OperationRows& rows) {
  const CountPlanes planes;
  const auto append = [&](const char* variant, const HWY_NAMESPACE::Light& kernel) {
    rows.push_back(
        {"frame_light", "3", variant,
         CountKernel(kernel, planes, planes, planes, planes, planes, planes, planes, planes)});
  };
  HWY_NAMESPACE::Light kernel = {};
  kernel.packs = true;
  append("after_gather_constants", kernel);
  kernel.lerps = kernel.rotates = kernel.finds_direction = kernel.extracts = true;
  append("after_gather_all", kernel);
}

}  // namespace gaunt::frame
