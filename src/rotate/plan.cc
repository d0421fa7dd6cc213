// SPDX-License-Identifier: MIT
#include "rotate/plan.h"

#include <algorithm>
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
  // Where one of the two is all but zero, the other's angle is all there is.
  constexpr double kPole = 1e-40;
  if (b < kPole * a) return {u * u / a, {1.0, 0.0}, {1.0, 0.0}};
  if (a < kPole * b) return {v * v / b, {1.0, 0.0}, {0.0, 1.0}};
  const double root = std::sqrt(a * b);
  return {u * v / root, u * Conjugate(v) / root, {std::sqrt(a) / length, std::sqrt(b) / length}};
}

// What a PlannedTurn leaves out: factors of the cosines and of the sines, by m > 0.
struct Factors {
  double of_cosine[kMaxOrder], of_sine[kMaxOrder];
};

// The turn comes before the matrices or after them.
enum class Place { kBefore, kAfter };

Factors PlanTurn(int order, const Complex& angle, Place place, PlannedTurn& turn) {
  Factors factors;
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

// Constants of the recurrence below.
struct Constants {
  double norm[kMaxOrder][kMaxOrder] = {};  // 1 / sqrt((l - m)! (l + m)!)
  double factorial[kMaxOrder] = {};        // (2 m)!
  double square[kMaxOrder] = {};
  double zonal[kMaxOrder] = {};    // (2l+1)(l+1)
  double product[kMaxOrder] = {};  // (2l+1) / l
  double below[kMaxOrder] = {};    // (l+1) / l

  constexpr Constants() {
    double factorials[2 * kMaxOrder] = {1.0};
    for (int i = 1; i < 2 * kMaxOrder; ++i) factorials[i] = factorials[i - 1] * i;
    for (int l = 0; l < kMaxOrder; ++l) {
      for (int m = 0; m <= l; ++m) {
        norm[l][m] = 1.0 / (ConstexprSqrt(factorials[l - m]) * ConstexprSqrt(factorials[l + m]));
      }
      factorial[l] = factorials[2 * l];
      square[l] = l * l;
      zonal[l] = (2.0 * l + 1.0) * (l + 1.0);
      if (l == 0) continue;  // where both are times zero
      product[l] = (2.0 * l + 1.0) / l;
      below[l] = (l + 1.0) / l;
    }
  }
};
constexpr Constants kConstants;

// Wigner's d^l_m'm(beta) = norm[l][m'] norm[l][m] D^l for m' >= m >= 0, and that of -m, from l = m'
// up by
//   l D^(l+1) = (2l+1)(l(l+1) cos(beta) - m m') D^l - (l+1)(l^2 - m^2)(l^2 - m'^2) D^(l-1)
// from D^m' = (2m')! cos(beta/2)^(m'+m) (-sin(beta/2))^(m'-m). (Varshalovich, Moskalev and
// Khersonskii 1988, sections 4.8 and 4.13, with the square roots taken out.)
class WignerColumns {
 public:
  WignerColumns(int order, const Complex& half_beta)
      : order_(order), cosine_((half_beta.re - half_beta.im) * (half_beta.re + half_beta.im)) {
    cosines_[0] = sines_[0] = 1.0;
    for (int i = 1; i < 2 * order; ++i) {
      cosines_[i] = cosines_[i - 1] * half_beta.re;
      sines_[i] = sines_[i - 1] * -half_beta.im;
    }
  }

  // visit(l, d^l_m'm, d^l_m'-m) for m' <= l < order.
  template <class Visit>
  void ForEach(int m_out, int m, const Visit& visit) const {
    const Constants& k = kConstants;
    double same = k.factorial[m_out] * cosines_[m_out + m] * sines_[m_out - m], same_below = 0.0;
    double other = k.factorial[m_out] * cosines_[m_out - m] * sines_[m_out + m], other_below = 0.0;
    const double product = m * m_out;
    for (int l = m_out;; ++l) {
      const double norm = k.norm[l][m_out] * k.norm[l][m];
      visit(l, norm * same, norm * other);
      if (l + 1 == order_) return;
      const double zonal = k.zonal[l] * cosine_, mixed = k.product[l] * product;
      const double below =
          k.below[l] * (k.square[l] - k.square[m]) * (k.square[l] - k.square[m_out]);
      const double same_above = (zonal - mixed) * same - below * same_below;
      const double other_above = (zonal + mixed) * other - below * other_below;
      same_below = same, same = same_above;
      other_below = other, other = other_above;
    }
  }

 private:
  int order_;
  double cosine_;
  double cosines_[2 * kMaxOrder], sines_[2 * kMaxOrder];  // powers for beta/2
};

// Real functions are sums and differences of those of m and -m, and d_mm' = (-1)^(m'-m) d_m'm.
void PlanMatrices(int order, const Complex& half_beta, const Factors& first, const Factors& last,
                  float* matrices) {
  const WignerColumns wigner(order, half_beta);
  wigner.ForEach(
      0, 0, [&](int l, double d, double) { matrices[MatricesIndex(l)] = static_cast<float>(d); });
  // Column 0 and row 0, which the sines lack.
  const double root2 = std::sqrt(2.0);
  for (int m_out = 1; m_out < order; ++m_out) {
    const double flip = m_out % 2 == 0 ? 1.0 : -1.0;
    wigner.ForEach(m_out, 0, [&](int l, double d, double) {
      float* const cosines = matrices + MatricesIndex(l);
      cosines[m_out * (l + 1)] = static_cast<float>(root2 * last.of_cosine[m_out] * d);
      cosines[m_out] = static_cast<float>(flip * root2 * first.of_cosine[m_out] * d);
    });
  }
  for (int m_out = 1; m_out < order; ++m_out) {
    for (int m = 1; m <= m_out; ++m) {
      const double sign = m % 2 == 0 ? 1.0 : -1.0, flip = (m_out - m) % 2 == 0 ? 1.0 : -1.0;
      const double cosine = last.of_cosine[m_out] * first.of_cosine[m];
      const double sine = last.of_sine[m_out] * first.of_sine[m];
      const double flipped_cosine = flip * last.of_cosine[m] * first.of_cosine[m_out];
      const double flipped_sine = flip * last.of_sine[m] * first.of_sine[m_out];
      wigner.ForEach(m_out, m, [&](int l, double same, double other) {
        float* const cosines = matrices + MatricesIndex(l);
        float* const sines = cosines + (l + 1) * (l + 1);
        const double sum = same + sign * other, difference = same - sign * other;
        cosines[m_out * (l + 1) + m] = static_cast<float>(cosine * sum);
        sines[(m_out - 1) * l + m - 1] = static_cast<float>(sine * difference);
        cosines[m * (l + 1) + m_out] = static_cast<float>(flipped_cosine * sum);
        sines[(m - 1) * l + m_out - 1] = static_cast<float>(flipped_sine * difference);
      });
    }
  }
}

}  // namespace

Rotation Rotation::OfQuaternion(const float quaternion[4]) {
  Rotation rotation = {{quaternion[0], quaternion[1], quaternion[2], quaternion[3]}, false};
  const auto is_normal = [](float x) { return std::abs(x) >= kSmallestComponent; };
  if (std::none_of(quaternion, quaternion + 4, is_normal)) rotation = {{0.0, 0.0, 0.0, 1.0}, false};
  return rotation;
}

Rotation Rotation::OfMatrix(const float matrix[9]) {
  double r[3][3];
  for (int i = 0; i < 9; ++i) r[i / 3][i % 3] = matrix[i];
  const double determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
                             r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
                             r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
  Rotation rotation = {{}, determinant < 0.0};
  if (rotation.mirror_y) {
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
  std::copy(products[largest], products[largest] + 4, rotation.quaternion);
  return rotation;
}

Plan Rotation::MakePlan(int order) const {
  const EulerAngles angles = AnglesOf(quaternion);
  Plan plan;
  // A mirror of y reverses the turns that it is moved over, and negates the sines.
  Factors first = PlanTurn(order, mirror_y ? Conjugate(angles.gamma) : angles.gamma, Place::kBefore,
                           plan.first);
  if (mirror_y) {
    for (int m = 1; m < order; ++m) first.of_sine[m] = -first.of_sine[m];
  }
  const Factors last = PlanTurn(order, angles.alpha, Place::kAfter, plan.last);
  PlanMatrices(order, angles.half_beta, first, last, plan.matrices);
  return plan;
}

bool Rotation::MakeMoves(Moves& moves) const {
  const double* const q = quaternion;
  // Most rotations tilt the z axis: they need no angles.
  const bool upright = q[0] == 0.0 && q[1] == 0.0, upside_down = q[2] == 0.0 && q[3] == 0.0;
  if (!upright && !upside_down) return false;
  const Complex alpha = AnglesOf(q).alpha;  // and gamma is 0
  if (alpha.re != 0.0 && alpha.im != 0.0) return false;
  // Upside down, y stays as it is and x and z change their signs: those of sines are the other
  // ones.
  moves.odd_band = upside_down ? -1.0f : 1.0f;
  const double sine = upside_down != mirror_y ? -1.0 : 1.0;
  Complex power = {1.0, 0.0};
  for (int m = 0; m < kMaxOrder; ++m) {
    moves.swaps[m] = power.re == 0.0;
    moves.to_cosine[m] = static_cast<float>(moves.swaps[m] ? -sine * power.im : power.re);
    moves.to_sine[m] = static_cast<float>(moves.swaps[m] ? power.im : sine * power.re);
    power = power * alpha;
  }
  return true;
}

}  // namespace gaunt::rotate
