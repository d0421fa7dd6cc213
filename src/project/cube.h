// SPDX-License-Identifier: MIT
// Cubemaps in double precision: where faces lie, solid angles of texels, and how moments of the
// faces become coefficients.
#ifndef GAUNT_PROJECT_CUBE_H_
#define GAUNT_PROJECT_CUBE_H_

#include <hwy/base.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "project/legendre.h"
#include "project/project.h"

namespace gaunt::project {

struct Axis {
  int axis;  // 0 x, 1 y, 2 z
  int sign;
};

// A texel at u (along its row) and v (down its column), in [-1, 1], lies at main + u across + v
// down.
struct CubeFace {
  Axis main, across, down;
};

// Direct3D, OpenGL and Unity keep their faces in memory alike (see gaunt.h).
inline constexpr CubeFace kCubeFaces[6] = {
    {{0, +1}, {2, -1}, {1, -1}}, {{0, -1}, {2, +1}, {1, -1}}, {{1, +1}, {0, +1}, {2, +1}},
    {{1, -1}, {0, +1}, {2, -1}}, {{2, +1}, {0, +1}, {1, -1}}, {{2, -1}, {0, -1}, {1, -1}}};

// Centre of texel i of `size`, in [-1, 1].
inline double TexelCentre(size_t i, size_t size) {
  return (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(size) - 1.0;
}

// Exact solid angles of the texels of faces of a small size, of which a quarter will do.
class SmallFace {
 public:
  static constexpr size_t kMaxSize = 15;

  explicit SmallFace(size_t size) : size_(size) {
    constexpr size_t kCorners = kMaxSize / 2 + 2;
    const size_t half = (size + 1) / 2;
    double above[kCorners], below[kCorners];
    Corners(0, half, above);
    for (size_t j = 0; j < half; ++j) {
      Corners(j + 1, half, below);
      for (size_t i = 0; i < half; ++i) {
        angles_[j][i] = below[i + 1] - below[i] - above[i + 1] + above[i];
      }
      for (size_t i = 0; i <= half; ++i) above[i] = below[i];
    }
  }

  double SolidAngle(size_t column, size_t row) const {
    return angles_[std::min(row, size_ - 1 - row)][std::min(column, size_ - 1 - column)];
  }

 private:
  // Solid angles of the rectangles from the middle to the corners 0 .. half of a row of corners.
  void Corners(size_t row, size_t half, double* corners) const {
    const double scale = 2.0 / static_cast<double>(size_);
    const double y = scale * static_cast<double>(row) - 1.0;
    for (size_t i = 0; i <= half; ++i) {
      const double x = scale * static_cast<double>(i) - 1.0;
      corners[i] = std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
    }
  }

  size_t size_;
  double angles_[kMaxSize / 2 + 1][kMaxSize / 2 + 1];
};

// The highest order that goes by moments: monomials up to it stay well conditioned.
inline constexpr int kMaxCubeMomentOrder = 10;
inline constexpr size_t kMaxCubeMoments = 2 * kMaxCubeMomentOrder - 1;

// Bands are homogeneous polynomials of a texel's place d = (u, v, 1) on its face. Even bands share
// the weight dOmega |d|^-even with all monomials of degree up to `even` in u and v, odd bands the
// weight dOmega |d|^-odd.
struct CubeDegrees {
  int even;
  int odd;  // -1 for order 1

  explicit CubeDegrees(int order)
      : even((order - 1) / 2 * 2), odd(order < 2 ? -1 : order / 2 * 2 - 1) {}
  // Powers of u, from 0 up: of the even weight, then of the odd one.
  size_t Moments() const { return static_cast<size_t>(even + 1 + odd + 1); }
};

// Moments of all faces: integrals of the light times x^a y^b z^c |d|^-(a+b+c), a + b + c = even or
// odd. Faces add into the same ones, so that one map leads from them to the coefficients.
class CubeMoments {
 public:
  using Channels = double[kMaxChannels];

  explicit CubeMoments(int order) : order_(order), degrees_(order) {
    for (size_t f = 0; f < 6; ++f) {
      uint8_t* slot = slots_[f];
      for (const int degree : {degrees_.even, degrees_.odd}) {
        for (int j = 0; j <= degree; ++j) {
          for (int k = 0; k + j <= degree; ++k) {
            int exponents[3] = {};
            exponents[kCubeFaces[f].main.axis] = degree - j - k;
            exponents[kCubeFaces[f].across.axis] = k;
            exponents[kCubeFaces[f].down.axis] = j;
            *slot++ = static_cast<uint8_t>((degree % 2 == 0 ? 0 : Odd()) +
                                           Slot(degree, exponents[0], exponents[1]));
          }
        }
      }
    }
  }

  const CubeDegrees& degrees() const { return degrees_; }
  // Where the moments of a face go: for the even degree and then the odd one, in the order of powers
  // of v, and in each of powers of u.
  const uint8_t* slots(size_t face) const { return slots_[face]; }
  Channels& operator[](uint8_t slot) { return sums_[slot]; }

  // Turns the moments into coefficients, once.
  HWY_NOINLINE void Finish(Pass& pass) {
    Turned turned;
    for (const int degree : {degrees_.even, degrees_.odd}) {
      Channels* const moments = sums_ + (degree % 2 == 0 ? 0 : Odd());
      for (int d = degree; d >= 0; d -= 2) {
        if (d < degree) Contract(d, moments);
        TurnAll(d, moments, turned);
      }
    }
    const Legendre legendre(order_, 0, order_);
    legendre.ForEachPolynomial<kMaxCubeMomentOrder>([&](int l, int m, const double* q) {
      for (const int part : {0, 1}) {
        if (part == 1 && m == 0) continue;
        double* const sum = pass.sums[pass.count + static_cast<size_t>(part)];
        for (int k = (l - m) % 2; k <= l - m; k += 2) {
          for (int c = 0; c < kMaxChannels; ++c) sum[c] += q[k] * turned.at[m][k][part][c];
        }
      }
      pass.List(l, m);
    });
  }

 private:
  // Integrals of the light times (x + i y)^m z^k |d|^-(m+k).
  struct Turned {
    Channels at[kMaxCubeMomentOrder][kMaxCubeMomentOrder][2];
  };

  static int Slot(int degree, int a, int b) { return a * (2 * degree + 3 - a) / 2 + b; }
  int Odd() const { return (degrees_.even + 1) * (degrees_.even + 2) / 2; }

  // Moments of a degree from those of two more: x^2 + y^2 + z^2 = |d|^2. In place: no slot is read
  // after it is written.
  static void Contract(int degree, Channels* moments) {
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        const double* const x = moments[Slot(degree + 2, a + 2, b)];
        const double* const y = moments[Slot(degree + 2, a, b + 2)];
        const double* const z = moments[Slot(degree + 2, a, b)];
        double* const to = moments[Slot(degree, a, b)];
        for (int c = 0; c < kMaxChannels; ++c) to[c] = x[c] + y[c] + z[c];
      }
    }
  }

  // (x + i y)^m z^(degree - m) for every m, by the binomial theorem.
  static void TurnAll(int degree, const Channels* moments, Turned& turned) {
    for (int m = 0; m <= degree; ++m) {
      Channels* const to = turned.at[m][degree - m];
      for (int c = 0; c < kMaxChannels; ++c) to[0][c] = to[1][c] = 0.0;
      double binomial = 1.0;
      for (int b = 0; b <= m; ++b) {
        const double factor = b % 4 < 2 ? binomial : -binomial;  // i^b
        const double* const from = moments[Slot(degree, m - b, b)];
        for (int c = 0; c < kMaxChannels; ++c) to[b % 2][c] += factor * from[c];
        binomial = binomial * (m - b) / (b + 1);
      }
    }
  }

  int order_;
  CubeDegrees degrees_;
  uint8_t slots_[6][kMaxCubeMomentOrder * kMaxCubeMomentOrder];
  Channels sums_[kMaxCubeMomentOrder * kMaxCubeMomentOrder] = {};
};

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_CUBE_H_
