// SPDX-License-Identifier: MIT
// Cubemaps in double precision: where faces lie, solid angles of texels, and how moments of the
// faces become coefficients.
#ifndef GAUNT_PROJECT_CUBE_H_
#define GAUNT_PROJECT_CUBE_H_

#include <hwy/base.h>

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

// Exact solid angle of the texel of side 2 h around (u, v).
inline double TexelSolidAngle(double u, double v, double h) {
  const auto corner = [](double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
  };
  return corner(u + h, v + h) - corner(u - h, v + h) - corner(u + h, v - h) + corner(u - h, v - h);
}

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

  // Adds moments in u of two runs of texels, at v and at -v: `sum` and `difference` of the first
  // and the second. Their u is relative to `centre`. Changes both.
  void Add(size_t face, double v, double centre, Channels* sum, Channels* difference) {
    const CubeFace& axes = kCubeFaces[face];
    const bool flip_u = axes.main.sign != axes.across.sign;
    v *= axes.main.sign * axes.down.sign;
    const uint8_t* slot = slots_[face];
    for (const int degree : {degrees_.even, degrees_.odd}) {
      if (degree < 0) break;
      for (Channels* const moments : {sum, difference}) {
        if (centre != 0.0) Shift(degree, centre, moments);
        if (flip_u) Flip(degree, moments);
      }
      double factor = degree % 2 == 0 ? 1.0 : axes.main.sign;
      for (int j = 0; j <= degree; ++j, factor *= v) {
        const Channels* const moments = j % 2 == 0 ? sum : difference;
        for (int k = 0; k + j <= degree; ++k) {
          double* const to = sums_[*slot++];
          for (int c = 0; c < kMaxChannels; ++c) to[c] += factor * moments[k][c];
        }
      }
      sum += degree + 1;
      difference += degree + 1;
    }
  }

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

  // Moments of u' = u + centre, from those of u.
  static void Shift(int degree, double centre, Channels* moments) {
    for (int i = 1; i <= degree; ++i) {
      for (int k = degree; k >= i; --k) {
        for (int c = 0; c < kMaxChannels; ++c) moments[k][c] += centre * moments[k - 1][c];
      }
    }
  }

  static void Flip(int degree, Channels* moments) {
    for (int k = 1; k <= degree; k += 2) {
      for (int c = 0; c < kMaxChannels; ++c) moments[k][c] = -moments[k][c];
    }
  }

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
