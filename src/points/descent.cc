// SPDX-License-Identifier: MIT
#include "points/descent.h"

#include <algorithm>
#include <utility>

namespace gaunt::points {
namespace {

constexpr int kMaxSteps = 100;
// Relative to the scale of the Hessian. The floor keeps the free rotations in bounds, along which
// the Hessian is 0.
constexpr double kFirstDamping = 1.0, kLeastDamping = 1e-8, kMostDamping = 1e12;
constexpr double kMoreDamping = 4.0, kLessDamping = 0.125;
constexpr double kRounding = 1e-13;  // relative error of a sum over pairs
constexpr double kNear = 1e-10;      // gradients below it, against the Hessian, may be rounding

// The sum near a set of points, by 2N variables: the way along two tangents at each point.
struct Model {
  PointSet points;
  std::vector<Point> tangents;   // two of each point
  std::vector<double> gradient;  // 2N
  std::vector<double> hessian;   // 2N x 2N, upper half
};

Model MakeModel(const PairFunction& function, Step step, const PointSet& points) {
  const size_t n = 2 * points.size();
  Model model = {points, {}, std::vector<double>(n), std::vector<double>(n * n)};
  for (const Point& p : points) {
    model.tangents.push_back(Perpendicular(p));
    model.tangents.push_back(Cross(p, model.tangents.back()));
  }
  // A feature's second derivative does not count in Gauss-Newton steps: what is left on the
  // diagonal is the term of a point with itself.
  const double self = step == Step::kGaussNewton ? function(0.0).slope : 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Point* e = &model.tangents[2 * i];
    double* diagonal = &model.hessian[2 * i * n + 2 * i];
    for (size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const Point across = Along(points[j], -1.0, points[i]);
      const PairTerm term = function(Dot(across, across));
      const double c[2] = {Dot(e[0], across), Dot(e[1], across)};
      for (size_t a = 0; a < 2; ++a) model.gradient[2 * i + a] += term.slope * c[a];
      if (step == Step::kNewton) {
        const double bend = -term.slope * Dot(points[i], points[j]);
        diagonal[0] += term.curvature * c[0] * c[0] + bend;
        diagonal[1] += term.curvature * c[0] * c[1];
        diagonal[n + 1] += term.curvature * c[1] * c[1] + bend;
      }
      if (j < i) continue;
      const Point* f = &model.tangents[2 * j];
      for (size_t a = 0; a < 2; ++a) {
        for (size_t b = 0; b < 2; ++b) {
          model.hessian[(2 * i + a) * n + 2 * j + b] =
              term.slope * Dot(e[a], f[b]) - term.curvature * c[a] * Dot(f[b], across);
        }
      }
    }
    diagonal[0] += self;
    diagonal[n + 1] += self;
  }
  return model;
}

double Norm(const std::vector<double>& v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

// Solves A x = b for symmetric A, of which the upper half is given, by A = U^T U. False if A is
// not positive definite.
bool SolveCholesky(std::vector<double> a, std::vector<double>* b) {
  const size_t n = b->size();
  std::vector<double>& x = *b;
  for (size_t k = 0; k < n; ++k) {
    double* row = &a[k * n];
    if (!(row[k] > 0.0)) return false;
    const double pivot = std::sqrt(row[k]);
    for (size_t j = k; j < n; ++j) row[j] /= pivot;
    for (size_t i = k + 1; i < n; ++i) {
      double* below = &a[i * n];
      const double factor = row[i];
      for (size_t j = i; j < n; ++j) below[j] -= factor * row[j];
    }
    x[k] /= row[k];
    for (size_t j = k + 1; j < n; ++j) x[j] -= row[j] * x[k];
  }
  for (size_t k = n; k-- > 0;) {
    for (size_t j = k + 1; j < n; ++j) x[k] -= a[k * n + j] * x[j];
    x[k] /= a[k * n + k];
  }
  return true;
}

// Mean size of the Hessian's diagonal.
double Scale(const Model& model) {
  const size_t n = model.gradient.size();
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += std::abs(model.hessian[i * n + i]);
  return sum / static_cast<double>(n);
}

// The points after the step -(H + damping I)^-1 g; none if that matrix is not positive definite.
PointSet Stepped(const Model& model, double damping) {
  std::vector<double> step = model.gradient;
  std::vector<double> hessian = model.hessian;
  for (size_t i = 0; i < step.size(); ++i) hessian[i * step.size() + i] += damping;
  PointSet moved;
  if (!SolveCholesky(std::move(hessian), &step)) return moved;
  for (size_t i = 0; i < model.points.size(); ++i) {
    Point p = model.points[i];
    for (size_t a = 2 * i; a < 2 * i + 2; ++a) p = Along(p, -step[a], model.tangents[a]);
    moved.push_back(Normalized(p));
  }
  return moved;
}

}  // namespace

double SumOverPairs(const PairFunction& function, const PointSet& points) {
  double sum = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) sum += function(SquaredDistance(points[i], points[j])).value;
  }
  return sum;
}

Descent Descend(const PairFunction& function, Step step, const PointSet& start) {
  Model model = MakeModel(function, step, start);
  Descent at = {start, SumOverPairs(function, start), Norm(model.gradient)};
  double damping = kFirstDamping;
  for (int round = 0; round < kMaxSteps && at.gradient > 0.0; ++round) {
    const double scale = Scale(model);
    const double rounding = kRounding * std::abs(at.value);
    // The first damping that does not lead uphill.
    Descent next;
    for (;; damping *= kMoreDamping) {
      if (damping > kMostDamping) return at;
      next.points = Stepped(model, damping * scale);
      if (next.points.empty()) continue;
      next.value = SumOverPairs(function, next.points);
      if (next.value <= at.value + rounding) break;
    }
    model = MakeModel(function, step, next.points);
    next.gradient = Norm(model.gradient);
    // Close to the minimum, what neither lowers the value nor halves the gradient is rounding.
    if (at.gradient < kNear * scale && next.value >= at.value - rounding &&
        next.gradient >= 0.5 * at.gradient) {
      return at;
    }
    at = std::move(next);
    damping = std::max(kLeastDamping, kLessDamping * damping);
  }
  return at;
}

PointSet GaussNewtonStep(const PairFunction& function, const PointSet& points,
                         const std::vector<Point>& gradient) {
  Model model = MakeModel(function, Step::kGaussNewton, points);
  for (size_t i = 0; i < model.tangents.size(); ++i) {
    model.gradient[i] = Dot(model.tangents[i], gradient[i / 2]);
  }
  PointSet moved = Stepped(model, kLeastDamping * Scale(model));
  return moved.empty() ? points : moved;
}

}  // namespace gaunt::points
