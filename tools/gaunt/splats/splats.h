// SPDX-License-Identifier: MIT
// Rotates files of Gaussian splats.
#ifndef GAUNT_TOOLS_GAUNT_SPLATS_SPLATS_H_
#define GAUNT_TOOLS_GAUNT_SPLATS_SPLATS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "splats/turn.h"

namespace gaunt::tool {

// Splats in memory at a time, at most.
inline constexpr size_t kChunkSplats = 4096;

struct SplatSummary {
  uint64_t splats;
  uint32_t degree;  // of SH
  uint64_t bytes;   // of the file
};

// Positions, normals, orientations and colours of all splats turn with the orthogonal matrix; all
// other bytes stay. The output is written whole or not at all, and may be the input. Progress is
// called with the share of the bytes that is done, which rises to 1. Throws BadInput,
// std::runtime_error.
SplatSummary RotateSplats(const std::string& in, const std::string& out, const Matrix& turn,
                          const std::function<void(double)>& progress);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_SPLATS_SPLATS_H_
