// SPDX-License-Identifier: MIT
// One rotation or mirroring, ready to be applied to many items with the fewest multiplications:
//   Rz(alpha) Ry(beta) Rz(gamma), after a mirror of y if there is one.
// Ry is a matrix d for the cosines and one for the sines of each band. Both turns about z need one
// multiply-add per coefficient, since the larger of the turn's sine and cosine is taken out of it
// and into the rows and columns of d.
#ifndef GAUNT_ROTATE_PLAN_H_
#define GAUNT_ROTATE_PLAN_H_

#include <cstdint>

#include "rotate/rotate.h"

namespace gaunt::rotate {

// Where the matrices of band l begin: (l+1)^2 entries for the cosines, row by row, then l^2 for the
// sines.
constexpr int MatricesIndex(int l) { return l * (2 * l * l + 1) / 3; }

// A turn about z by m times its angle takes the planes p and q, l + side m and l - side m, to
// p - tangent q and q + tangent p, but for a factor.
struct PlannedTurn {
  int8_t side[kMaxOrder];  // -1 where the sine is the larger one, else 1
  float tangent[kMaxOrder];
};

struct Plan {
  PlannedTurn first;
  PlannedTurn last;
  float matrices[MatricesIndex(kMaxOrder)];
};

// Of a quaternion x y z w of any length; of zero, the identity.
void PlanQuaternion(int order, const float quaternion[4], Plan& plan);
// Of an orthonormal row-major matrix.
void PlanMatrix(int order, const float matrix[9], Plan& plan);

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_PLAN_H_
