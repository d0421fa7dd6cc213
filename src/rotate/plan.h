// SPDX-License-Identifier: MIT
// One rotation or mirroring for all items, ready to be applied with the fewest multiplications:
//   Rz(alpha) Ry(beta) Rz(gamma), after a mirror of y if there is one.
// Ry is a matrix d for the cosines and one for the sines of each band. Both turns about z need one
// multiply-add per coefficient, since the larger of the turn's sine and cosine is taken out of it
// and into the rows and columns of d.
#ifndef GAUNT_ROTATE_PLAN_H_
#define GAUNT_ROTATE_PLAN_H_

#include <array>
#include <cstdint>

#include "rotate/rotate.h"

namespace gaunt::rotate {

// Where the matrices of band l begin: (l+1)^2 entries for the cosines, row by row, then l^2 for the
// sines.
constexpr int MatricesIndex(int l) { return l * (2 * l * l + 1) / 3; }

// A turn about z by m times its angle takes the planes p and q, l + side m and l - side m, to
// p - tangent q and q + tangent p, but for a factor.
struct PlannedTurn {
  int8_t side[kMaxOrder] = {};  // -1 where the sine is the larger one, else 1
  float tangent[kMaxOrder] = {};
};

struct Plan {
  PlannedTurn first;
  PlannedTurn last;
  float matrices[MatricesIndex(kMaxOrder)];
};

// A rotation or mirroring that keeps the z axis on its line, at right angles: it only moves and
// negates coefficients. Coefficient m > 0 becomes to_cosine times itself or, where the two swap,
// that of -m; and -m likewise; all of an odd band are times odd_band as well.
struct Moves {
  bool swaps[kMaxOrder];
  float to_cosine[kMaxOrder];
  float to_sine[kMaxOrder];
  float odd_band;
};

// A rotation by a quaternion, after a mirror of y if there is one.
struct Rotation {
  double quaternion[4];  // x y z w, of any length but 0
  bool mirror_y;

  static Rotation OfQuaternion(const float quaternion[4]);
  static Rotation OfMatrix(const float matrix[9]);  // orthonormal, row-major

  // Whether they may keep the z axis on its line, at a glance: most rotations do not.
  static bool MayKeepZ(const std::array<float, 4>& q) {
    return (q[0] == 0.0f && q[1] == 0.0f) || (q[2] == 0.0f && q[3] == 0.0f);
  }
  static bool MayKeepZ(const std::array<float, 9>& m) {
    return m[2] == 0.0f && m[5] == 0.0f && m[6] == 0.0f && m[7] == 0.0f;
  }

  Plan MakePlan(int order) const;
  // False if it does more than that.
  bool MakeMoves(Moves& moves) const;
};

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_PLAN_H_
