// SPDX-License-Identifier: MIT
#include "rotate/plan.h"

#include <cmath>

#include "basis/constants.h"

namespace gaunt::rotate {
namespace {

struct Complex {
  double re, im;
};
Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
Complex operator/(const Complex& c, double divisor) { return {c.re / divisor, c.im / divisor}; }
Complex Conjugate(const Complex& c) { return {c.re, -c.im}; }
double SquaredLength(const Complex& c) { return c.re * c.re + c.im * c.im; }

// e^(i angle) of the Euler angles alpha and gamma, and of the half of beta.
struct EulerAngles {
  Complex alpha, gamma, half_beta;
};

// Right angles come out exact.
EulerAngles AnglesOf(const double q[4]) {
  // Of a unit quaternion, u = cos(beta/2) e^(i (alpha + gamma)/2) and v = sin(beta/2) e^(i (alpha -
  // gamma)/2).
  const Complex u = {q[3], q[2]}, v = {q[1], -q[0]};
  const double a = SquaredLength(u), b = SquaredLength(v), length = std::sqrt(a + b);
  if (length == 0.0) return {{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  // Where one of the two is all but zero, the other's angle is all there is.
  constexpr double kPole = 1e-40;
  if (b < kPole * a) return {u * u / a, {1.0, 0.0}, {1.0, 0.0}};
  if (a < kPole * b) return {v * v / b, {1.0, 0.0}, {0.0, 1.0}};
  const double root = std::sqrt(a * b);
  return {u * v / root, u * Conjugate(v) / root, {std::sqrt(a) / length, std::sqrt(b) / length}};
}

// What a PlannedTurn leaves out: factors of the cosines and of the sines, by m.
struct Factors {
  double of_cosine[kMaxOrder], of_sine[kMaxOrder];
};

// The turn comes before the matrices or after them.
enum class Place { kBefore, kAfter };

Factors PlanTurn(int order, const Complex& angle, Place place, PlannedTurn& turn) {
  Factors factors = {};
  factors.of_cosine[0] = 1.0;
  Complex power = {1.0, 0.0};
  for (int m = 1; m < order; ++m) {
    power = power * angle;
    const double c = power.re, s = power.im;
    if (std::abs(c) >= std::abs(s)) {
      turn.side[m] = 1;
      turn.tangent[m] = static_cast<float>(s / c);
      factors.of_cosine[m] = factors.of_sine[m] = c;
    } else {
      turn.side[m] = -1;
      turn.tangent[m] = static_cast<float>(c / s);
      factors.of_cosine[m] = place == Place::kBefore ? -s : s;
      factors.of_sine[m] = -factors.of_cosine[m];
    }
  }
  return factors;
}

// 1 / sqrt((l - m)! (l + m)!) as [l][m], reciprocals, and factorials of 2 m.
struct Norms {
  double norm[kMaxOrder][kMaxOrder] = {};
  double reciprocal[kMaxOrder] = {};
  double factorial[kMaxOrder] = {};

  constexpr Norms() {
    double factorials[2 * kMaxOrder] = {1.0};
    for (int i = 1; i < 2 * kMaxOrder; ++i) factorials[i] = factorials[i - 1] * i;
    for (int l = 0; l < kMaxOrder; ++l) {
      for (int m = 0; m <= l; ++m) {
        norm[l][m] = 1.0 / (ConstexprSqrt(factorials[l - m]) * ConstexprSqrt(factorials[l + m]));
      }
      if (l > 0) reciprocal[l] = 1.0 / l;
      factorial[l] = factorials[2 * l];
    }
  }
};
constexpr Norms kNorms;

// Wigner's d^l_m'm(beta) = norm[l][m'] norm[l][m] D^l for m' >= m >= 0, and that of -m, from l = m' up by
//   l D^(l+1) = (2l+1)(l(l+1) cos(beta) - m m') D^l - (l+1)(l^2 - m^2)(l^2 - m'^2) D^(l-1)
// from D^m' = (2m')! cos(beta/2)^(m'+m) (-sin(beta/2))^(m'-m). (Varshalovich, Moskalev and
// Khersonskii 1988, sections 4.8 and 4.13, with the square roots taken out.)
class WignerColumns {
 public:
  explicit WignerColumns(const Complex& half_beta)
      : cosine_((half_beta.re - half_beta.im) * (half_beta.re + half_beta.im)) {
    cosines_[0] = sines_[0] = 1.0;
    for (int i = 1; i < 2 * kMaxOrder; ++i) {
      cosines_[i] = cosines_[i - 1] * half_beta.re;
      sines_[i] = sines_[i - 1] * -half_beta.im;
    }
  }

  // visit(l, d^l_m'm, d^l_m'-m) for m' <= l < order.
  template <class Visit>
  void ForEach(int m_out, int m, int order, const Visit& visit) const {
    const double start = kNorms.factorial[m_out];
    double same = start * cosines_[m_out + m] * sines_[m_out - m], same_below = 0.0;
    double other = start * cosines_[m_out - m] * sines_[m_out + m], other_below = 0.0;
    const double product = m * m_out;
    for (int l = m_out;; ++l) {
      const double norm = kNorms.norm[l][m_out] * kNorms.norm[l][m];
      visit(l, norm * same, norm * other);
      if (l + 1 == order) return;
      const double up = (2 * l + 1) * kNorms.reciprocal[l], zonal = (2 * l + 1) * (l + 1) * cosine_;
      const double down =
          (l + 1) * kNorms.reciprocal[l] * (l * l - m * m) * (l * l - m_out * m_out);
      const double same_above = (zonal - up * product) * same - down * same_below;
      const double other_above = (zonal + up * product) * other - down * other_below;
      same_below = same, same = same_above;
      other_below = other, other = other_above;
    }
  }

 private:
  double cosine_;
  double cosines_[2 * kMaxOrder], sines_[2 * kMaxOrder];  // powers for beta/2
};

void MakePlan(int order, const double quaternion[4], bool mirror_y, Plan& plan) {
  const EulerAngles angles = AnglesOf(quaternion);
  // A mirror of y reverses the turns that it is moved over, and negates the sines.
  Factors first = PlanTurn(order, mirror_y ? Conjugate(angles.gamma) : angles.gamma, Place::kBefore,
                           plan.first);
  if (mirror_y) {
    for (double& factor : first.of_sine) factor = -factor;
  }
  const Factors last = PlanTurn(order, angles.alpha, Place::kAfter, plan.last);
  const auto put = [&](int l, int m_out, int m, double cosine, double sine) {
    float* const cosines = plan.matrices + MatricesIndex(l);
    cosines[m_out * (l + 1) + m] =
        static_cast<float>(last.of_cosine[m_out] * cosine * first.of_cosine[m]);
    if (m_out == 0 || m == 0) return;
    float* const sines = cosines + (l + 1) * (l + 1);
    sines[(m_out - 1) * l + m - 1] =
        static_cast<float>(last.of_sine[m_out] * sine * first.of_sine[m]);
  };
  // Real functions are sums and differences of those of m and -m.
  const WignerColumns wigner(angles.half_beta);
  const double half = std::sqrt(0.5);
  for (int m_out = 0; m_out < order; ++m_out) {
    for (int m = 0; m <= m_out; ++m) {
      const double sign = m % 2 == 0 ? 1.0 : -1.0, transposed = (m_out - m) % 2 == 0 ? 1.0 : -1.0;
      const double scale = (m_out == 0 ? half : 1.0) * (m == 0 ? half : 1.0);
      wigner.ForEach(m_out, m, order, [&](int l, double same, double other) {
        const double cosine = scale * (same + sign * other), sine = same - sign * other;
        put(l, m_out, m, cosine, sine);
        if (m != m_out) put(l, m, m_out, transposed * cosine, transposed * sine);
      });
    }
  }
}

}  // namespace

void PlanQuaternion(int order, const float quaternion[4], Plan& plan) {
  const double q[4] = {quaternion[0], quaternion[1], quaternion[2], quaternion[3]};
  MakePlan(order, q, false, plan);
}

void PlanMatrix(int order, const float matrix[9], Plan& plan) {
  double r[3][3];
  for (int i = 0; i < 9; ++i) r[i / 3][i % 3] = matrix[i];
  const double determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
                             r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
                             r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
  const bool mirror_y = determinant < 0.0;
  if (mirror_y) {
    for (auto& row : r) row[1] = -row[1];
  }
  // Four times the products of a unit quaternion's components x y z w: each row is the quaternion
  // times one of them, and that of the largest has the fewest rounding errors.
  const double products[4][4] = {
      {1.0 + r[0][0] - r[1][1] - r[2][2], r[0][1] + r[1][0], r[0][2] + r[2][0], r[2][1] - r[1][2]},
      {r[0][1] + r[1][0], 1.0 - r[0][0] + r[1][1] - r[2][2], r[1][2] + r[2][1], r[0][2] - r[2][0]},
      {r[0][2] + r[2][0], r[1][2] + r[2][1], 1.0 - r[0][0] - r[1][1] + r[2][2], r[1][0] - r[0][1]},
      {r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], 1.0 + r[0][0] + r[1][1] + r[2][2]}};
  int largest = 0;
  for (int i = 1; i < 4; ++i) {
    if (products[i][i] > products[largest][largest]) largest = i;
  }
  MakePlan(order, products[largest], mirror_y, plan);
}

}  // namespace gaunt::rotate
