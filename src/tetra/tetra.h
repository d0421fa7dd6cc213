// SPDX-License-Identifier: MIT
// Interpolation in a mesh of tetrahedra whose corners are probes.
#ifndef GAUNT_TETRA_TETRA_H_
#define GAUNT_TETRA_TETRA_H_

#include <cstddef>
#include <cstdint>

#include "simd/view.h"
#include "tetra/mesh.h"

namespace gaunt::tetra {

// Whether all corners are below `vertices`, all neighbours tetrahedra or none (or `neighbours`
// null), and all positions finite and not too far away.
bool IsSound(uint32_t vertices, const simd::InView& positions, uint32_t tetrahedra,
             const uint32_t* corners, const uint32_t* neighbours);

// Writes SizeOf() bytes; finds neighbours where they are null.
void Prepare(uint32_t vertices, const simd::InView& positions, uint32_t tetrahedra,
             const uint32_t* corners, const uint32_t* neighbours, void* bytes);

// The weights of a position that the walk to `tetrahedron` left outside: of the nearest point of that
// tetrahedron's surface. Where the walk is lost, all tetrahedra are searched, and it becomes the first
// that holds the position, or else the nearest.
void FindNearest(const Mesh& mesh, const float* position, bool is_lost, uint32_t* tetrahedron,
                 float* weights);

struct Table {
  void (*taps)(const Mesh& mesh, size_t count, const simd::InView& positions, uint32_t* tetrahedra,
               uint32_t* indices, float* weights);
};

const Table& Kernels();

}  // namespace gaunt::tetra

#endif  // GAUNT_TETRA_TETRA_H_
