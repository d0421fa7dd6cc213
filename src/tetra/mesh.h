// SPDX-License-Identifier: MIT
// A prepared mesh of tetrahedra, as it lies in the caller's memory. It has any alignment.
#ifndef GAUNT_TETRA_MESH_H_
#define GAUNT_TETRA_MESH_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::tetra {

inline constexpr int kCorners = 4;
inline constexpr uint32_t kNone = UINT32_MAX;
// Positions and vertices are no further from the origin than this.
inline constexpr double kFarthest = 1e15;
// Barycentrics from here up are inside, where they are sums of terms up to 1, and in proportion where
// terms are larger. It is more than they round, so that no position is sent to and fro between two
// tetrahedra that meet.
inline constexpr double kInside = -1e-6;

// At the start of the bytes. Records follow, then the corners of each tetrahedron, then vertices.
struct Header {
  uint32_t magic, version;
  uint32_t vertices, tetrahedra;
  uint32_t step_limit;  // of a walk
  uint32_t reserved[11];
};

// A cache line per tetrahedron: what a step of a walk reads. Neighbour i is across the face that
// lies opposite corner i.
struct Record {
  float rows[3][3];  // barycentrics 0, 1, 2 of a position less corner 3; NaN where it is flat
  float corner[3];   // position of corner 3
  uint32_t neighbours[kCorners];
};

struct Corners {
  uint32_t vertices[kCorners];
};

struct Vertex {
  float at[3];
};

static_assert(sizeof(Header) == 64 && sizeof(Record) == 64 && sizeof(Corners) == 16, "no padding");

struct Mesh {
  const uint8_t* records;
  const uint8_t* corners;
  const uint8_t* vertices;
  uint32_t tetrahedra;
  uint32_t last_vertex;
  uint32_t step_limit;
};

// The number of bytes, or 0 if no size holds it.
size_t SizeOf(uint32_t vertices, uint32_t tetrahedra);

// Whether the bytes begin as those of a mesh do, and are as many; finds its parts.
bool FindMesh(const void* bytes, size_t size, Mesh* mesh);

}  // namespace gaunt::tetra

#endif  // GAUNT_TETRA_MESH_H_
