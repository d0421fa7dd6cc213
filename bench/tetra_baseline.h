// SPDX-License-Identifier: MIT
// Walks through tetrahedra as engines have them, one position after the other, compiled like a
// user's code.
#ifndef GAUNT_BENCH_TETRA_BASELINE_H_
#define GAUNT_BENCH_TETRA_BASELINE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaunt::bench {

struct EngineTetrahedron {
  uint32_t corners[4];
  int32_t neighbours[4];  // -1 at the border
  float matrix[9];        // to barycentrics 0, 1, 2
  float corner[3];        // position of corner 3
};

// From interleaved vertices, corners, and neighbours of which UINT32_MAX is none.
std::vector<EngineTetrahedron> EngineMesh(const std::vector<float>& vertices,
                                          const std::vector<uint32_t>& corners,
                                          const std::vector<uint32_t>& neighbours);

// Positions outside get the weights that are cut off at 0.
void TetrahedraEngine(const std::vector<EngineTetrahedron>& mesh, size_t count,
                      const float* positions, uint32_t* tetrahedra, uint32_t* indices,
                      float* weights);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_TETRA_BASELINE_H_
