// SPDX-License-Identifier: MIT
// Tables of the grids on which functions are multiplied point by point: for each row of points the
// factors that take coefficients there and back.
#ifndef GAUNT_PRODUCT_GRID_H_
#define GAUNT_PRODUCT_GRID_H_

#include "product/quadrature.h"

namespace gaunt::product {

// A grid is made for the sum of the degrees of both factors and of the product. Degrees 2c and
// 2c + 1 share one, of condition count c + 1, which has room for functions of order up to c + 1.
constexpr int GridOf(int degree) { return degree / 2 + 1; }
inline constexpr int kMaxGrid = GridOf(kMaxDegree);

// How much of the sums over an orbit of four points is left out, so that additions become
// multiply-adds: nothing; what joins phi and pi - phi; both, but for orbits of two points; all.
enum class Level { kPoints, kHalves, kQuarters, kAll };

// Of the library. Measured: on Zen 5 kHalves is up to 6 % faster with g++, and up to a third slower
// with clang.
inline constexpr Level kLevel = Level::kAll;

// Points in phi: more than the degree, so that what aliases does so into orders that are not read.
inline constexpr int kPointCounts[] = {4, 8, 12, 16, 24, 32, 40};
inline constexpr int kNumPointCounts = sizeof(kPointCounts) / sizeof(kPointCounts[0]);
constexpr int PointCase(int grid) {
  int i = 0;
  while (kPointCounts[i] < 2 * grid) ++i;
  return i;
}
constexpr int PointsOf(int grid) { return kPointCounts[PointCase(grid)]; }
static_assert(kPointCounts[kNumPointCounts - 1] >= 2 * kMaxGrid, "too few points");

// Of a grid, and of functions that are prepared for one: values at the upper and the lower pole, then
// of the points of each row, the equator first, then those at z and -z of each pair.
inline constexpr int kPoleValues = 2;
constexpr int NumValues(int grid) { return kPoleValues + (grid - 1) * PointsOf(grid); }

// Odd m are kept times this, which makes ones of some constants of the transform.
constexpr double OddScale(int points) {
  return points == 16 ? CosineOfTurn(1, 16) : points == 24 ? CosineOfTurn(3, 24) : 1.0;
}

// The scale of a row is free, since products are made point by point: it makes a one of the factor of
// (1, +-1).
constexpr double RowScale(const PolarParts& at, int points) {
  return 1.0 / (OddScale(points) * at.part[PolarIndex(1, 1)]);
}

// Factors of one row, at PolarIndex(l, m); for a pair of rows at +-z those of l + m odd change sign
// at the lower one.
struct RowFactors {
  const float* in;
  const float* out;
};

constexpr int NumGridFactors() {
  int sum = 0;
  for (int grid = 1; grid <= kMaxGrid; ++grid) sum += grid / 2 * PolarIndex(grid, 0);
  return sum;
}

class GridTable {
 public:
  constexpr explicit GridTable(Level level) {
    const PolarRecurrence recurrence;
    for (int grid = 1, row = 0, next = 0; grid <= kMaxGrid; ++grid) {
      const Rule rule(2 * (grid - 1));
      first_[grid] = next;
      for (int i = 0; i < rule.pairs + (rule.equator ? 1 : 0); ++i, ++row) {
        const bool is_equator = i == rule.pairs;
        PutRow(level, grid, recurrence.At(is_equator ? 0.0 : rule.z[i]),
               is_equator ? rule.equator_weight : rule.weight[i], next);
        next += PolarIndex(grid, 0);
      }
      for (int l = 0; l < grid; ++l) {
        const double root = ConstexprSqrt(2.0 * l + 1.0);
        pole_in_[l] = static_cast<float>(root);
        const double y00 = 1.0 / (2.0 * ConstexprSqrt(kPi));
        pole_out_[PolarIndex(grid - 1, l)] =
            static_cast<float>(rule.pole_weight * 2.0 * kPi * y00 * y00 * y00 * root);
      }
    }
  }

  static constexpr int Pairs(int grid) { return (grid - 1) / 2; }
  static constexpr bool HasEquator(int grid) { return (grid - 1) % 2 != 0; }
  // The rows of pairs, then the equator.
  constexpr RowFactors Row(int grid, int i) const {
    const int at = first_[grid] + i * PolarIndex(grid, 0);
    return {in_ + at, out_ + at};
  }
  // At the poles functions are sums over l of in times coefficient (l, 0), with (-1)^l at the lower
  // one; the product there takes part in coefficient (l, 0) with out.
  constexpr const float* PoleIn() const { return pole_in_; }
  constexpr const float* PoleOut(int grid) const { return pole_out_ + PolarIndex(grid - 1, 0); }

 private:
  constexpr void PutRow(Level level, int grid, const PolarParts& at, double weight, int first) {
    const int points = PointsOf(grid);
    const double odd = OddScale(points);
    const double scale = RowScale(at, points);
    const double left_out = level == Level::kPoints ? 1.0 : level == Level::kHalves ? 2.0 : 4.0;
    const double back = weight * (2.0 * kPi / points) * left_out / (scale * scale);
    for (int l = 0; l < grid; ++l) {
      for (int m = 0; m <= l; ++m) {
        const double part = at.part[PolarIndex(l, m)] * (m % 2 != 0 ? odd : 1.0);
        in_[first + PolarIndex(l, m)] = static_cast<float>(scale * part);
        out_[first + PolarIndex(l, m)] = static_cast<float>(back * part);
      }
    }
  }

  int first_[kMaxGrid + 1] = {};
  float in_[NumGridFactors()] = {};
  float out_[NumGridFactors()] = {};
  float pole_in_[kMaxGrid] = {};
  float pole_out_[PolarIndex(kMaxGrid, 0)] = {};
};

template <Level level>
inline constexpr GridTable kGrids{level};

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_GRID_H_
