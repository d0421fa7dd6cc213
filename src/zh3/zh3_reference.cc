// SPDX-License-Identifier: MIT
#include "zh3/zh3_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"
#include "evaluate/evaluate_reference.h"

namespace gaunt::zh3 {
namespace {

const double kPi = std::acos(-1.0);
const double kRec709[3] = {0.2126, 0.7152, 0.0722};

void Normalise(double v[3]) {
  const double length = std::hypot(v[0], v[1], v[2]);
  const bool known = length >= 1e-37 && std::isfinite(length);
  for (int k = 0; k < 3; ++k) v[k] = known ? v[k] / length : 0.0;
}

// Band 1 as a vector.
void VectorOf(const double* f, double v[3]) {
  v[0] = -f[3];
  v[1] = -f[1];
  v[2] = f[2];
}

double Dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// y_2m(a) over its norm; 0 for no axis.
void ZonalReference(const double axis[3], double band[5]) {
  double y[9];
  basis::EvalReference(3, axis, y);
  const bool none = Dot(axis, axis) == 0.0;
  for (int m = 0; m < 5; ++m) band[m] = none ? 0.0 : y[4 + m] * std::sqrt(4.0 * kPi / 5.0);
}

}  // namespace

void AxisReference(bool shared, size_t stride, const double* weights, const double* in,
                   double* axis) {
  if (weights == nullptr) weights = kRec709;
  double sum[3] = {};
  for (size_t c = 0; c < 3; ++c) {
    double v[3];
    VectorOf(in + c * stride, v);
    for (int k = 0; k < 3; ++k) sum[k] += weights[c] * v[k];
    if (shared) continue;
    Normalise(v);
    std::copy_n(v, 3, axis + 3 * c);
  }
  if (!shared) return;
  Normalise(sum);
  std::copy_n(sum, 3, axis);
}

void SolveReference(bool shared, const double* sh3, double* k2, double* axis) {
  AxisReference(shared, 9, nullptr, sh3, axis);
  for (int c = 0; c < 3; ++c) {
    double band[5];
    ZonalReference(axis + (shared ? 0 : 3 * c), band);
    k2[c] = 0.0;
    for (int m = 0; m < 5; ++m) k2[c] += band[m] * sh3[9 * c + 4 + m];
  }
}

void HallucinateReference(bool shared, double linear, double quadratic, const double* weights,
                          const double* sh2, double* k2) {
  double axis[9];
  AxisReference(shared, 4, weights, sh2, axis);
  for (int c = 0; c < 3; ++c) {
    const double* const f = sh2 + 4 * c;
    double v[3];
    VectorOf(f, v);
    k2[c] = 0.0;
    if (!(f[0] > 0.0)) continue;
    const double along = std::abs(Dot(v, axis + (shared ? 0 : 3 * c)));
    const double r = std::min(along / f[0], std::sqrt(3.0));
    k2[c] = f[0] * (linear * r + quadratic * r * r);
  }
}

void ExpandReference(bool shared, const double* sh2, const double* k2, double* sh3) {
  double axis[9];
  AxisReference(shared, 4, nullptr, sh2, axis);
  for (int c = 0; c < 3; ++c) {
    double band[5];
    ZonalReference(axis + (shared ? 0 : 3 * c), band);
    std::copy_n(sh2 + 4 * c, 4, sh3 + 9 * c);
    for (int m = 0; m < 5; ++m) sh3[9 * c + 4 + m] = k2[c] * band[m];
  }
}

void IrradianceReference(bool shared, const double* sh2, const double* k2, const double* normal,
                         double* out) {
  double sh3[27], y[9];
  ExpandReference(shared, sh2, k2, sh3);
  basis::EvalReference(3, normal, y);
  for (int c = 0; c < 3; ++c) {
    out[c] = 0.0;
    for (int l = 0; l < 3; ++l) {
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        out[c] += evaluate::CosineFactor(l) * sh3[9 * c + i] * y[i];
      }
    }
  }
}

void GeomericsReference(const double* sh2, const double* normal, double* out) {
  for (int c = 0; c < 3; ++c) {
    const double* const f = sh2 + 4 * c;
    out[c] = 0.0;
    if (!(f[0] > 0.0)) continue;
    // Mean of the radiance, and of radiance times direction.
    const double mean = f[0] / std::sqrt(4.0 * kPi);
    double r1[3];
    VectorOf(f, r1);
    const double length = std::hypot(r1[0], r1[1], r1[2]) / std::sqrt(12.0 * kPi);
    Normalise(r1);
    const double s = std::min(length / mean, 1.0);
    const double q = std::clamp(0.5 * (1.0 + Dot(r1, normal)), 0.0, 1.0);
    const double p = 1.0 + 2.0 * s, base = (1.0 - s) / (1.0 + s);
    out[c] = mean * (base + (1.0 - base) * (p + 1.0) * std::pow(q, p));
  }
}

double ErrorReference(bool shared, const double* sh3, const double* sh2, const double* k2) {
  double fitted[27], error = 0.0;
  ExpandReference(shared, sh2, k2, fitted);
  for (int c = 0; c < 3; ++c) {
    for (int l = 0; l < 3; ++l) {
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        const double e = evaluate::CosineFactor(l) * (fitted[9 * c + i] - sh3[9 * c + i]);
        error += e * e;
      }
    }
  }
  return error;
}

namespace {

// The channels that share an axis.
class Problem {
 public:
  Problem(const double* sh3, const double* weights, int channels)
      : sh3_(sh3), weights_(weights), channels_(channels) {
    for (int c = 0; c < channels; ++c) norm2_ += weights[c] * weights[c];
  }

  // The best fit with the axis +-n, and its error.
  double Fit(const double n[3], double* sh2, double* k2) const {
    double p[3] = {}, band[5], error = 0.0;
    for (int c = 0; c < channels_; ++c) {
      double v[3];
      VectorOf(sh3_ + 9 * c, v);
      for (int k = 0; k < 3; ++k) p[k] += weights_[c] * v[k];
    }
    const double along = Dot(p, n);
    ZonalReference(n, band);
    for (int c = 0; c < channels_; ++c) {
      const double* const f = sh3_ + 9 * c;
      double v[3];
      VectorOf(f, v);
      for (int k = 0; k < 3; ++k) v[k] -= weights_[c] * (p[k] - along * n[k]) / norm2_;
      const double fit[4] = {f[0], -v[1], v[2], -v[0]};
      double zonal = 0.0;
      for (int m = 0; m < 5; ++m) zonal += band[m] * f[4 + m];
      for (int i = 1; i < 9; ++i) {
        const double e = (i < 4 ? fit[i] : zonal * band[i - 4]) - f[i];
        const double factor = evaluate::CosineFactor(i < 4 ? 1 : 2);
        error += factor * factor * e * e;
      }
      std::copy_n(fit, 4, sh2 + 4 * c);
      k2[c] = zonal;
    }
    return error;
  }

  double Error(const double n[3]) const {
    double sh2[12], k2[3];
    return Fit(n, sh2, k2);
  }

 private:
  const double* sh3_;
  const double* weights_;
  int channels_;
  double norm2_ = 0.0;
};

}  // namespace

double RefitReference(bool shared, const double* sh3, double* sh2, double* k2) {
  const double one[1] = {1.0};
  double total = 0.0;
  for (int group = 0; group < (shared ? 1 : 3); ++group) {
    const Problem problem(sh3 + 9 * group, shared ? kRec709 : one, shared ? 3 : 1);
    struct Candidate {
      double error;
      double n[3];
    };
    std::vector<Candidate> candidates;
    constexpr int kPoints = 600;  // of a spiral over the upper half
    for (int i = 0; i < kPoints; ++i) {
      Candidate candidate;
      const double z = (i + 0.5) / kPoints, turn = i * kPi * (3.0 - std::sqrt(5.0));
      candidate.n[0] = std::sqrt(1.0 - z * z) * std::cos(turn);
      candidate.n[1] = std::sqrt(1.0 - z * z) * std::sin(turn);
      candidate.n[2] = z;
      candidate.error = problem.Error(candidate.n);
      candidates.push_back(candidate);
    }
    constexpr int kBest = 8;
    std::partial_sort(candidates.begin(), candidates.begin() + kBest, candidates.end(),
                      [](const Candidate& a, const Candidate& b) { return a.error < b.error; });
    Candidate best = candidates[0];
    for (int i = 0; i < kBest; ++i) {
      Candidate here = candidates[static_cast<size_t>(i)];
      for (double step = 0.06; step > 1e-7;) {  // along the axes of space
        bool better = false;
        for (int direction = 0; direction < 6; ++direction) {
          Candidate next = here;
          next.n[direction / 2] += direction % 2 == 0 ? step : -step;
          Normalise(next.n);
          next.error = problem.Error(next.n);
          if (next.error >= here.error) continue;
          here = next;
          better = true;
        }
        if (!better) step *= 0.5;
      }
      if (here.error < best.error) best = here;
    }
    total += problem.Fit(best.n, sh2 + 4 * group, k2 + group);
  }
  return total;
}

void FitCurveReference(bool shared, size_t count, const double* sh3, double* linear,
                       double* quadratic) {
  // Gram and Schmidt: r, and what of r^2 is orthogonal to it.
  std::vector<double> first, second, wanted;
  for (size_t i = 0; i < count; ++i, sh3 += 27) {
    double k2[3], axis[9];
    SolveReference(shared, sh3, k2, axis);
    for (int c = 0; c < 3; ++c) {
      double v[3];
      VectorOf(sh3 + 9 * c, v);
      const double along = std::abs(Dot(v, axis + (shared ? 0 : 3 * c)));
      const double r = std::min(along / sh3[9 * c], std::sqrt(3.0));
      first.push_back(r);
      second.push_back(r * r);
      wanted.push_back(k2[c] / sh3[9 * c]);
    }
  }
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const double share = dot(first, second) / dot(first, first);
  for (size_t i = 0; i < first.size(); ++i) second[i] -= share * first[i];
  *quadratic = dot(second, wanted) / dot(second, second);
  *linear = dot(first, wanted) / dot(first, first) - *quadratic * share;
}

}  // namespace gaunt::zh3
