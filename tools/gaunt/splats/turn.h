// SPDX-License-Identifier: MIT
// Rotations and mirrors as orthogonal matrices. Quarter turns and mirrors are exact.
#ifndef GAUNT_TOOLS_GAUNT_SPLATS_TURN_H_
#define GAUNT_TOOLS_GAUNT_SPLATS_TURN_H_

#include <array>
#include <cstddef>

namespace gaunt::tool {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // w x y z
using Matrix = std::array<double, 9>;      // row-major: v' = M v

inline constexpr Matrix kIdentity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

// Of any length but 0. Throws BadInput.
Matrix TurnByQuaternion(const Quaternion& quaternion);
// Anticlockwise for one whom the axis points at. Throws BadInput.
Matrix TurnAboutAxis(const Vector& axis, double degrees);
// The orthogonal matrix nearest to one that is nearly so. Throws BadInput if an entry of M M^T is
// off by more than 1e-4.
Matrix TurnByMatrix(const Matrix& matrix);
// Axis 0, 1, 2.
Matrix Mirror(size_t axis);

// First b, then a.
Matrix Multiply(const Matrix& a, const Matrix& b);
// The 4 x 4 matrix of p -> q p.
std::array<double, 16> ProductBy(const Quaternion& q);

bool Mirrors(const Matrix& m);
// Unit quaternion of a rotation; of a matrix that mirrors, that of -m.
Quaternion Orientation(const Matrix& m);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_SPLATS_TURN_H_
