// SPDX-License-Identifier: MIT
// Tetrahedra by their definition, in double precision: all of them are looked at.
#ifndef GAUNT_TETRA_TETRA_REFERENCE_H_
#define GAUNT_TETRA_TETRA_REFERENCE_H_

#include <array>
#include <cstdint>
#include <vector>

namespace gaunt::tetra {

struct MeshReference {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<uint32_t, 4>> tetrahedra;
};

// Barycentric coordinates by Cramer's rule; not finite where the tetrahedron is flat.
std::array<double, 4> BarycentricsReference(const MeshReference& mesh, uint32_t tetrahedron,
                                            const std::array<double, 3>& position);

struct FoundReference {
  uint32_t tetrahedron;
  double least;  // of the barycentrics
};

// The tetrahedron whose least barycentric is largest.
FoundReference FindReference(const MeshReference& mesh, const std::array<double, 3>& position);

// The longest edge over the least height.
double AspectReference(const MeshReference& mesh, uint32_t tetrahedron);

}  // namespace gaunt::tetra

#endif  // GAUNT_TETRA_TETRA_REFERENCE_H_
