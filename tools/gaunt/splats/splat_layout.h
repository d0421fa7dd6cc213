// SPDX-License-Identifier: MIT
// Where a PLY file of Gaussian splats has what a rotation changes.
#ifndef GAUNT_TOOLS_GAUNT_SPLATS_SPLAT_LAYOUT_H_
#define GAUNT_TOOLS_GAUNT_SPLATS_SPLAT_LAYOUT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "splats/ply.h"

namespace gaunt::tool {

// Offsets in bytes of floats in a record of `stride` bytes, which may have any alignment.
struct SplatLayout {
  size_t element;  // of the header: the splats
  uint64_t count;
  size_t stride;
  std::array<size_t, 3> position;
  std::vector<size_t> normal;         // three, or none
  std::array<size_t, 4> orientation;  // w x y z
  uint32_t order;                     // of SH, 1 .. 4
  std::vector<size_t> rest;           // 3 (order^2 - 1): those of one channel after another's
};

// Throws BadInput.
SplatLayout FindSplats(const PlyHeader& header);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_SPLATS_SPLAT_LAYOUT_H_
