// SPDX-License-Identifier: MIT
#include "points/repulsion.h"

#include <cmath>
#include <utility>

#include "points/descent.h"

namespace gaunt::points {
namespace {

constexpr uint32_t kStarts = 20;
constexpr double kSameEnergy = 1e-11;  // relative
constexpr double kAtRest = 1e-11;      // gradient; of up to 200 points rounding leaves 4e-13

// 1 / |p - q|, where |p - q|^2 = 2 - 2 cosine.
PairTerm Coulomb(double squared_distance) {
  const double inverse = 1.0 / std::sqrt(squared_distance);
  const double slope = inverse / squared_distance;
  return {inverse, slope, 3.0 * slope / squared_distance};
}

// 1 / |p - q| + 1 / |p + q|
PairTerm AntipodalCoulomb(double squared_distance) {
  const PairTerm near = Coulomb(squared_distance), far = Coulomb(4.0 - squared_distance);
  return {near.value + far.value, near.slope - far.slope, near.curvature + far.curvature};
}

}  // namespace

double CoulombEnergy(const PointSet& set) { return SumOverPairs(Coulomb, set); }

PointSet Repulsion(int count, const ProgressFn& progress) {
  Descent best;
  for (uint32_t seed = 0; seed < kStarts; ++seed) {
    Descent found = Descend(Coulomb, Step::kNewton, RandomPoints(count, seed));
    const bool better = best.points.empty() || found.value < best.value - kSameEnergy * best.value;
    if (found.gradient < kAtRest && better) best = std::move(found);
    if (progress) progress((seed + 1.0) / kStarts);
  }
  return Canonical(best.points);
}

PointSet AntipodalRepulsion(int half_count, uint32_t seed) {
  return Descend(AntipodalCoulomb, Step::kNewton, RandomPoints(half_count, seed)).points;
}

}  // namespace gaunt::points
