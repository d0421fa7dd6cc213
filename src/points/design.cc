// SPDX-License-Identifier: MIT
#include "points/design.h"

#include <algorithm>
#include <cmath>

#include "basis/basis_reference.h"
#include "points/descent.h"
#include "simd/order.h"

namespace gaunt::points {
namespace {

constexpr uint32_t kStarts = 6;  // per number of points
constexpr int kMostTries = 10;   // numbers of points
constexpr int kPolishSteps = 2;
constexpr double kFound = 1e-10;  // residual; where there is no design it stays above 1e-6

// Weight of band l in the square that is minimised: it gives the bands' gradients one size.
double BandWeight(int l) { return 1.0 / (l * (l + 1.0)); }

// Opposite points let odd bands vanish. The sum over pairs of this function of their cosine is the
// weighted square of the even bands' sums, by the addition theorem:
// sum over even l of w_l (2l + 1) P_l = 4 pi sum over even l of w_l sum over m of y_lm(p) y_lm(q).
PairTerm EvenBands(int strength, double squared_distance) {
  const double x = 1.0 - 0.5 * squared_distance;
  // P_l, its derivatives, and those of l - 1.
  PairTerm now = {x, 1.0, 0.0}, before = {1.0, 0.0, 0.0}, sum = {0.0, 0.0, 0.0};
  for (int l = 2; l < strength; ++l) {
    const double k = 2.0 * l - 1.0;
    const PairTerm next = {(k * x * now.value - (l - 1.0) * before.value) / l,
                           before.slope + k * now.value, before.curvature + k * now.slope};
    before = now;
    now = next;
    if (l % 2 == 1) continue;
    const double weight = BandWeight(l) * (2.0 * l + 1.0);
    sum.value += weight * now.value;
    sum.slope += weight * now.slope;
    sum.curvature += weight * now.curvature;
  }
  return sum;
}

// The fewest points to look for. Tight designs, the corners of a segment, an octahedron and an
// icosahedron, reach (t + 1)(t + 3) / 4 (Delsarte, Goethals and Seidel 1977). Beyond, as many as
// have one free angle for each condition, less three for the rotation (Womersley 2018).
int FewestHalf(int strength) {
  if (strength <= 5) return (strength + 1) * (strength + 3) / 8;
  return (strength * (strength + 1) + 4 + 3) / 4;  // rounded up
}

// sum over the points of y_lm
std::vector<double> Sums(int order, const PointSet& set) {
  std::vector<double> y(static_cast<size_t>(order * order)), sums(y.size(), 0.0);
  for (const Point& p : set) {
    basis::EvalReference(order, p.data(), y.data());
    for (size_t i = 0; i < y.size(); ++i) sums[i] += y[i];
  }
  return sums;
}

// The gradient that comes from pairs loses digits by cancellation. In terms of the sums, which
// vanish themselves, it does not.
std::vector<Point> GradientBySums(int strength, const PointSet& half) {
  constexpr double kReach = 1e-4;  // of central differences: the gradient needs few digits
  const std::vector<double> sums = Sums(strength, half);
  const auto potential = [&](const Point& p) {
    std::vector<double> y(sums.size());
    basis::EvalReference(strength, p.data(), y.data());
    double sum = 0.0;
    for (int l = 2; l < strength; l += 2) {
      for (int m = -l; m <= l; ++m) {
        const size_t i = static_cast<size_t>(CoefficientIndex(l, m));
        sum += 4.0 * std::acos(-1.0) * BandWeight(l) * sums[i] * y[i];
      }
    }
    return sum;
  };
  std::vector<Point> gradient;
  for (const Point& p : half) {
    Point slope;
    for (size_t k = 0; k < 3; ++k) {
      Point above = p, below = p;
      above[k] += kReach;
      below[k] -= kReach;
      slope[k] = (potential(above) - potential(below)) / (2.0 * kReach);
    }
    gradient.push_back(slope);
  }
  return gradient;
}

PointSet WithOpposites(const PointSet& half) {
  PointSet set = half;
  for (const Point& p : half) set.push_back(Opposite(p));
  return set;
}

}  // namespace

PointSet SymmetricDesign(int strength, const ProgressFn& progress) {
  const PairFunction bands = [strength](double s) { return EvenBands(strength, s); };
  for (int half_count = FewestHalf(strength), tries = 0; tries < kMostTries;
       ++tries, ++half_count) {
    for (uint32_t seed = 0; seed < kStarts; ++seed) {
      // How many tries it takes is not known: the bar slows down.
      if (progress) progress(1.0 - 8.0 / (8.0 + kStarts * tries + seed));
      PointSet half =
          Descend(bands, Step::kGaussNewton, AntipodalRepulsion(half_count, seed)).points;
      if (DesignResidual(strength, WithOpposites(half)) > kFound) continue;
      for (int i = 0; i < kPolishSteps; ++i) {
        half = GaussNewtonStep(bands, half, GradientBySums(strength, half));
      }
      return Canonical(WithOpposites(half));
    }
  }
  return {};
}

double DesignResidual(int strength, const PointSet& set) {
  const std::vector<double> sums = Sums(strength + 1, set);
  double largest = 0.0;
  for (size_t i = 1; i < sums.size(); ++i) largest = std::max(largest, std::abs(sums[i]));
  return largest / static_cast<double>(set.size());
}

}  // namespace gaunt::points
