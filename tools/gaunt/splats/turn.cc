// SPDX-License-Identifier: MIT
#include "splats/turn.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

// Divides by the largest, so that squares neither overflow nor vanish.
template <size_t N>
std::array<double, N> Scaled(std::array<double, N> v, const char* what) {
  double largest = 0.0;
  for (const double x : v) {
    if (!std::isfinite(x)) throw BadInput(fmt::format("{} is not finite", what));
    largest = std::max(largest, std::abs(x));
  }
  if (largest == 0.0) throw BadInput(fmt::format("{} is zero", what));
  for (double& x : v) x /= largest;
  return v;
}

Matrix Transpose(const Matrix& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }

Matrix Cofactors(const Matrix& m) {
  Matrix c;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c[3 * i + j] = m[3 * i1 + j1] * m[3 * i2 + j2] - m[3 * i1 + j2] * m[3 * i2 + j1];
    }
  }
  return c;
}

double Determinant(const Matrix& m) {
  const Matrix c = Cofactors(m);
  return m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
}

}  // namespace

// In terms of squares, without a root: exact for the rotations of a cube.
Matrix TurnByQuaternion(const Quaternion& quaternion) {
  const auto [w, x, y, z] = Scaled(quaternion, "the quaternion");
  const double ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  Matrix m = {ww + xx - yy - zz,   2 * (x * y - w * z), 2 * (x * z + w * y),
              2 * (x * y + w * z), ww - xx + yy - zz,   2 * (y * z - w * x),
              2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz};
  for (double& entry : m) entry /= ww + xx + yy + zz;
  return m;
}

Matrix TurnAboutAxis(const Vector& axis, double degrees) {
  if (!std::isfinite(degrees)) throw BadInput("the angle is not finite");
  auto [x, y, z] = Scaled(axis, "the axis");
  const double length = std::hypot(x, y, z);
  x /= length, y /= length, z /= length;
  // Quarter turns, which are exact, and at most half of one more.
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters) * (std::acos(-1.0) / 180.0);
  double c = std::cos(rest), s = std::sin(rest);
  for (int k = quarters & 3; k > 0; --k) {
    const double before = c;
    c = -s;
    s = before;
  }
  const double t = 1.0 - c;
  return {c + t * x * x,     t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, c + t * y * y,
          t * y * z - s * x, t * x * z - s * y, t * y * z + s * x, c + t * z * z};
}

Matrix TurnByMatrix(const Matrix& matrix) {
  constexpr double kTolerance = 1e-4;
  const Matrix square = Multiply(matrix, Transpose(matrix));
  for (size_t k = 0; k < 9; ++k) {
    const double error = std::abs(square[k] - kIdentity[k]);
    if (!(error <= kTolerance)) {  // nor if it is no number
      throw BadInput(fmt::format("the matrix is not orthogonal: M M^T is off by {:.3g}", error));
    }
  }
  // Newton's iteration for the polar decomposition; each step squares the error.
  Matrix m = matrix;
  for (int step = 0; step < 3; ++step) {
    const Matrix cofactors = Cofactors(m);
    const double determinant = Determinant(m);
    for (size_t k = 0; k < 9; ++k) m[k] = 0.5 * (m[k] + cofactors[k] / determinant);
  }
  return m;
}

Matrix Mirror(size_t axis) {
  Matrix m = kIdentity;
  m[4 * axis] = -1.0;
  return m;
}

Matrix Multiply(const Matrix& a, const Matrix& b) {
  Matrix m;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      m[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return m;
}

std::array<double, 16> ProductBy(const Quaternion& q) {
  const auto [w, x, y, z] = q;
  return {w, -x, -y, -z, x, w, -z, y, y, z, w, -x, z, -y, x, w};
}

bool Mirrors(const Matrix& m) { return Determinant(m) < 0.0; }

Quaternion Orientation(const Matrix& matrix) {
  Matrix m = matrix;
  if (Mirrors(matrix)) {
    for (double& entry : m) entry = -entry;
  }
  // Four times the squares of w x y z. The largest is at least 1: a good divisor.
  const double squares[4] = {1.0 + m[0] + m[4] + m[8], 1.0 + m[0] - m[4] - m[8],
                             1.0 - m[0] + m[4] - m[8], 1.0 - m[0] - m[4] + m[8]};
  const ptrdiff_t largest = std::max_element(squares, squares + 4) - squares;
  const double twice = std::sqrt(squares[largest]);                   // 2 |q_largest|
  const double wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1];  // four times the products
  const double xy = m[3] + m[1], xz = m[2] + m[6], yz = m[7] + m[5];
  const Quaternion rows[4] = {{squares[0], wx, wy, wz},
                              {wx, squares[1], xy, xz},
                              {wy, xy, squares[2], yz},
                              {wz, xz, yz, squares[3]}};
  Quaternion q;
  for (size_t k = 0; k < 4; ++k) q[k] = rows[largest][k] / (2.0 * twice);
  return q;
}

}  // namespace gaunt::tool
