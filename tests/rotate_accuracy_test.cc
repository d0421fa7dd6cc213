// SPDX-License-Identifier: MIT
// Accuracy of rotation: against golden matrices, near the poles where angles fail, and against what
// rotations have in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gaunt/gaunt.h"
#include "rotate/rotate_reference.h"
#include "rotate/turn.h"
#include "tests/rotate_tolerance.h"
#include "tests/support/golden.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

using Floats = std::vector<float>;
constexpr size_t kCoefficients = 36;  // of order 6

// Items of floats, back to back, or one for all of them.
gaunt_view ViewOf(Floats& items, size_t planes, bool one = false) {
  gaunt_view view;
  if (one) {
    gaunt_view_broadcast(items.data(), &view);
  } else {
    gaunt_view_interleaved(items.data(), planes, &view);
  }
  return view;
}

// Rotates items of n^2 coefficients by quaternions or, if there are 9 floats of each, by matrices;
// by one for all, with items of zeros added to the end up to the number that is worth a plan.
Floats Rotated(uint32_t n, Floats rotations, Floats in, size_t planes, bool one = false) {
  const size_t items = in.size() / (n * n),
               count = one ? std::max(items, LeastPlannedItems(n)) : items;
  in.resize(count * n * n);
  Floats out(in.size());
  const gaunt_view vr = ViewOf(rotations, planes, one), vi = ViewOf(in, n * n),
                   vo = ViewOf(out, n * n);
  EXPECT_EQ((planes == 4 ? gaunt_rotate : gaunt_rotate_matrix)(n, 1, count, &vr, &vi, &vo),
            GAUNT_OK);
  out.resize(items * n * n);
  return out;
}

// Unit vectors of coefficients: rotating them gives the columns of the matrix.
Floats UnitItems(uint32_t n) {
  const size_t coefficients = n * n;
  Floats items(coefficients * coefficients, 0.0f);
  for (size_t i = 0; i < coefficients; ++i) items[i * coefficients + i] = 1.0f;
  return items;
}

Floats Repeated(const Floats& item, size_t times) {
  Floats items;
  for (size_t i = 0; i < times; ++i) items.insert(items.end(), item.begin(), item.end());
  return items;
}

Floats RandomItems(Random& random, size_t floats) {
  Floats items(floats);
  random.Fill(items.data(), floats, -1.0, 1.0);
  return items;
}

class RotateAccuracy : public TargetTest {};

TEST_P(RotateAccuracy, MatchesGoldenMatrices) {
  std::map<std::string, Floats> cases, golden;
  for (const auto& row : ReadGolden("rotation_cases.csv")) {
    for (size_t k = 1; k <= 9; ++k) cases[row[0]].push_back(std::stof(row[k]));
  }
  for (const auto& row : ReadGolden("rotation_order6.csv")) {
    const int l = std::stoi(row[1]), out = l * (l + 1) + std::stoi(row[2]),
              in = l * (l + 1) + std::stoi(row[3]);
    Floats& columns = golden.try_emplace(row[0], kCoefficients * kCoefficients).first->second;
    columns[static_cast<size_t>(in) * kCoefficients + static_cast<size_t>(out)] = std::stof(row[4]);
  }
  ASSERT_EQ(golden.size(), 12u);
  for (const auto& [name, columns] : golden) {
    for (const bool one : {false, true}) {
      const Floats matrices = one ? cases.at(name) : Repeated(cases.at(name), kCoefficients);
      const Floats found = Rotated(6, matrices, UnitItems(6), 9, one);
      for (size_t i = 0; i < found.size(); ++i) {
        ASSERT_NEAR(found[i], columns[i], one ? 4e-7 : 2e-6) << name << " entry " << i;
      }
    }
  }
}

// Quaternions with x and y times `tilt`, or, about axes, with only w and one of the others.
enum class Kind { kRandom, kAboutAxes, kTilt3, kTilt6, kTilt3FromPi, kTilt6FromPi };
Floats MakeQuaternions(Random& random, Kind kind, size_t count) {
  Floats q = RandomItems(random, 4 * count);
  for (size_t i = 0; i < count; ++i) {
    float* const item = q.data() + 4 * i;
    const float tilt = kind == Kind::kTilt3 || kind == Kind::kTilt3FromPi ? 1e-3f : 1e-6f;
    switch (kind) {
      case Kind::kRandom: break;
      case Kind::kAboutAxes:
        for (size_t k = 0; k < 3; ++k) item[k] *= k == i % 3 ? 1.0f : 0.0f;
        break;
      case Kind::kTilt3:
      case Kind::kTilt6: item[0] *= tilt, item[1] *= tilt; break;
      case Kind::kTilt3FromPi:
      case Kind::kTilt6FromPi: item[2] *= tilt, item[3] *= tilt; break;
    }
  }
  return q;
}

// Where beta = acos(R_zz) loses half of the digits, and alpha and gamma have none.
TEST_P(RotateAccuracy, HoldsNearThePoles) {
  for (const uint32_t n : {3u, 6u, 8u, 9u}) {
    const size_t coefficients = n * n, count = n == 6 ? 400 : 60;
    Random random(n);
    for (const Kind kind : {Kind::kRandom, Kind::kAboutAxes, Kind::kTilt3, Kind::kTilt6,
                            Kind::kTilt3FromPi, Kind::kTilt6FromPi}) {
      SCOPED_TRACE("order " + std::to_string(n) + " kind " +
                   std::to_string(static_cast<int>(kind)));
      const Floats quaternions = MakeQuaternions(random, kind, count);
      const Floats in = RandomItems(random, count * coefficients);
      const auto item = [&](const Floats& items, size_t i, size_t planes) {
        const auto first = items.begin() + static_cast<ptrdiff_t>(i * planes);
        return Floats(first, first + static_cast<ptrdiff_t>(planes));
      };
      Floats matrices(9 * count), mirrors(9 * count);
      std::vector<double> wanted(in.size());
      for (size_t i = 0; i < count; ++i) {
        const Floats q = item(quaternions, i, 4), f = item(in, i, coefficients);
        double matrix[9];
        rotate::MatrixReference(std::vector<double>(q.begin(), q.end()).data(), matrix);
        rotate::RotateReference(static_cast<int>(n), 1, matrix,
                                std::vector<double>(f.begin(), f.end()).data(),
                                wanted.data() + coefficients * i);
        for (size_t k = 0; k < 9; ++k) {
          matrices[9 * i + k] = static_cast<float>(matrix[k]);
          mirrors[9 * i + k] = -matrices[9 * i + k];
        }
      }
      const Floats by_quaternion = Rotated(n, quaternions, in, 4);
      const Floats by_matrix = Rotated(n, matrices, in, 9), mirrored = Rotated(n, mirrors, in, 9);
      for (size_t i = 0; i < in.size(); ++i) {
        ASSERT_NEAR(by_quaternion[i], wanted[i], RotateTolerance(n));
        ASSERT_NEAR(by_matrix[i], wanted[i], RotateTolerance(n));
        const bool odd = static_cast<int>(std::sqrt(i % coefficients)) % 2 != 0;
        ASSERT_NEAR(mirrored[i], odd ? -wanted[i] : wanted[i], RotateTolerance(n));
      }
      // One for all.
      for (size_t i = 0; i < count; i += 20) {
        const Floats one = Rotated(n, item(quaternions, i, 4), item(in, i, coefficients), 4, true);
        for (size_t k = 0; k < coefficients; ++k) {
          ASSERT_NEAR(one[k], wanted[coefficients * i + k], RotateOneTolerance(n));
        }
      }
    }
  }
}

TEST_P(RotateAccuracy, MatrixEntriesAreWithin2e6) {
  Random random(8);
  for (const Kind kind : {Kind::kRandom, Kind::kAboutAxes, Kind::kTilt3, Kind::kTilt6,
                          Kind::kTilt3FromPi, Kind::kTilt6FromPi}) {
    const Floats quaternions = MakeQuaternions(random, kind, 12);
    for (size_t i = 0; i < 12; ++i) {
      const Floats q(quaternions.begin() + 4 * i, quaternions.begin() + 4 * i + 4);
      const double exact[4] = {q[0], q[1], q[2], q[3]};
      double matrix[9];
      rotate::MatrixReference(exact, matrix);
      const Floats each = Rotated(6, Repeated(q, kCoefficients), UnitItems(6), 4);
      const Floats one = Rotated(6, q, UnitItems(6), 4, true);
      for (size_t in = 0; in < kCoefficients; ++in) {
        std::vector<double> unit(kCoefficients), column(kCoefficients);
        unit[in] = 1.0;
        rotate::RotateReference(6, 1, matrix, unit.data(), column.data());
        for (size_t out = 0; out < kCoefficients; ++out) {
          ASSERT_NEAR(each[in * kCoefficients + out], column[out], 1e-6);
          ASSERT_NEAR(one[in * kCoefficients + out], column[out], 2e-7);
        }
      }
    }
  }
}

// Columns are orthonormal, at every order.
TEST_P(RotateAccuracy, IsOrthogonal) {
  Random random(21);
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    const size_t coefficients = n * n;
    const Floats q = RandomItems(random, 4);
    for (const bool one : {false, true}) {
      const Floats columns = Rotated(n, one ? q : Repeated(q, coefficients), UnitItems(n), 4, one);
      for (size_t a = 0; a < coefficients; ++a) {
        for (size_t b = a; b < std::min(coefficients, a + 40); ++b) {
          double dot = a == b ? -1.0 : 0.0;
          for (size_t i = 0; i < coefficients; ++i) {
            dot += double{columns[a * coefficients + i]} * double{columns[b * coefficients + i]};
          }
          ASSERT_NEAR(dot, 0.0, one ? 1e-6 : 4e-6) << "order " << n << ": " << a << " " << b;
        }
      }
    }
  }
}

// Two rotations are their product, and a rotation and its inverse are none.
TEST_P(RotateAccuracy, Composes) {
  Random random(5);
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    for (int trial = 0; trial < 20; ++trial) {
      const Floats a = RandomItems(random, 4), b = RandomItems(random, 4);
      const auto product = [](const Floats& p, const Floats& q) {  // p after q
        return Floats{p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
                      p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
                      p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
                      p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
      };
      const Floats f = RandomItems(random, n * n);
      const Floats twice = Rotated(n, b, Rotated(n, a, f, 4), 4);
      const Floats once = Rotated(n, product(b, a), f, 4);
      const Floats inverse = {-a[0], -a[1], -a[2], a[3]};
      const Floats back = Rotated(n, inverse, Rotated(n, a, f, 4), 4);
      // Float products of quaternions are off by 1e-7, which a band multiplies by l.
      const double tolerance = 3.0 * RotateTolerance(n) + 5e-7 * n;
      for (size_t i = 0; i < f.size(); ++i) {
        ASSERT_NEAR(twice[i], once[i], tolerance) << "order " << n;
        ASSERT_NEAR(back[i], f[i], 2.0 * RotateTolerance(n)) << "order " << n;
      }
    }
  }
}

// One matrix, or quaternion, that swaps and mirrors axes and keeps z on its line moves and negates
// coefficients, to the bit, of few items and of many.
void ExpectExact(uint32_t n, const double matrix[9], const Floats& rotation, const Floats& in) {
  const std::vector<double> f(in.begin(), in.end());
  std::vector<double> wanted(in.size());
  rotate::RotateReference(static_cast<int>(n), 2, matrix, f.data(), wanted.data());
  const size_t planes = rotation.size();
  const Floats first(in.begin(), in.begin() + static_cast<ptrdiff_t>(n * n));
  const Floats many = Rotated(n, rotation, in, planes, true);
  const Floats single = Rotated(n, rotation, first, planes);
  for (size_t i = 0; i < in.size(); ++i) {
    // The reference is off by 1e-13; the float nearest to it is one of the input's.
    ASSERT_EQ(many[i], static_cast<float>(wanted[i])) << "order " << n;
    if (i < first.size()) {
      ASSERT_EQ(single[i], static_cast<float>(wanted[i])) << "order " << n;
    }
  }
}

// All 48 matrices that only swap and mirror axes. Those that tilt z have no angle that could be off.
TEST_P(RotateAccuracy, MirrorsAndSwapsOfAxesAreExact) {
  Random random(17);
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    const Floats in = RandomItems(random, 2 * n * n);
    int order[3] = {0, 1, 2};
    do {
      for (int signs = 0; signs < 8; ++signs) {
        Floats matrix(9, 0.0f);
        for (int row = 0; row < 3; ++row) {
          matrix[static_cast<size_t>(3 * row + order[row])] = signs >> row & 1 ? -1.0f : 1.0f;
        }
        const std::vector<double> exact(matrix.begin(), matrix.end());
        if (order[2] == 2) {
          ExpectExact(n, exact.data(), matrix, in);
          continue;
        }
        std::vector<double> f(in.begin(), in.end()), wanted(in.size());
        rotate::RotateReference(static_cast<int>(n), 2, exact.data(), f.data(), wanted.data());
        const Floats found = Rotated(n, matrix, in, 9, true);
        for (size_t i = 0; i < in.size(); ++i) {
          ASSERT_NEAR(found[i], wanted[i], RotateOneTolerance(n)) << "order " << n;
        }
      }
    } while (std::next_permutation(order, order + 3));
  }
}

TEST_P(RotateAccuracy, QuaternionsOfRightAnglesAreExact) {
  Random random(18);
  for (uint32_t n = 1; n <= GAUNT_MAX_ROTATE_ORDER; ++n) {
    const Floats in = RandomItems(random, 2 * n * n);
    for (int which = 0; which < 16; ++which) {
      const float a = static_cast<float>(which % 4 - 1 - which % 4 / 3 * 2),
                  b = static_cast<float>(which / 4 % 2), length = random.Between(1e-9, 1e9);
      if (a == 0.0f && b == 0.0f) continue;
      const Floats turn = {0.0f, 0.0f, a * length, b * length};
      const Floats half_turn = {a * length, b * length, 0.0f, 0.0f};
      for (const Floats& q : {turn, half_turn}) {
        double matrix[9];
        rotate::MatrixReference(std::vector<double>(q.begin(), q.end()).data(), matrix);
        ExpectExact(n, matrix, q, in);
      }
    }
  }
}

// The orthonormal matrix nearest to one that is almost so, by Newton's iteration of the polar form.
void Orthonormalise(double matrix[9]) {
  for (int step = 0; step < 20; ++step) {
    double gram[9] = {}, next[9];
    for (int i = 0; i < 27; ++i) {
      gram[i / 9 * 3 + i / 3 % 3] += matrix[i % 3 * 3 + i / 9] * matrix[i % 3 * 3 + i / 3 % 3];
    }
    for (int i = 0; i < 9; ++i) {
      next[i] = 1.5 * matrix[i];
      for (int k = 0; k < 3; ++k) next[i] -= 0.5 * matrix[i / 3 * 3 + k] * gram[3 * k + i % 3];
    }
    std::copy(next, next + 9, matrix);
  }
}

// As gaunt.h states it of matrices that gaunt_rotation_check() finds off by e.
TEST_P(RotateAccuracy, MatricesThatAreOffGiveCoefficientsThatAreOffAsMuch) {
  Random random(41);
  double largest = 0.0;
  for (uint32_t n = 2; n <= 8; ++n) {
    for (int trial = 0; trial < 60; ++trial) {
      const Floats q = RandomItems(random, 4), in = RandomItems(random, n * n);
      double exact[9];
      rotate::MatrixReference(std::vector<double>(q.begin(), q.end()).data(), exact);
      Floats matrix(9);
      for (size_t k = 0; k < 9; ++k) {
        matrix[k] = static_cast<float>(exact[k]) + random.Between(-1e-3, 1e-3);
        exact[k] = matrix[k];
      }
      Orthonormalise(exact);
      const gaunt_view view = ViewOf(matrix, 9);
      float e = 0.0f;
      ASSERT_EQ(gaunt_rotation_check(1, &view, &e), GAUNT_OK);
      std::vector<double> f(in.begin(), in.end()), wanted(in.size());
      rotate::RotateReference(static_cast<int>(n), 1, exact, f.data(), wanted.data());
      const Floats found = Rotated(n, matrix, in, 9);
      for (size_t i = 0; i < in.size(); ++i) {
        const double error = std::abs(found[i] - wanted[i]);
        ASSERT_LE(error, 2.5 * n * e + RotateTolerance(n)) << "order " << n;
        largest = std::max(largest, error / (n * e));
      }
    }
  }
  EXPECT_GT(largest, 0.5);  // and not by much less
}

TEST_P(RotateAccuracy, MovesALobeForwards) {
  // A quarter turn about z takes +x to +y.
  const float half = std::sqrt(0.5f);
  Floats x = {1, 0, 0}, y = {0, 1, 0}, lobe(kCoefficients), wanted(kCoefficients);
  const gaunt_view vx = ViewOf(x, 3), vy = ViewOf(y, 3), vl = ViewOf(lobe, 36),
                   vw = ViewOf(wanted, 36);
  ASSERT_EQ(gaunt_basis_eval(6, 1, &vx, &vl), GAUNT_OK);
  ASSERT_EQ(gaunt_basis_eval(6, 1, &vy, &vw), GAUNT_OK);
  const Floats moved = Rotated(6, {0, 0, half, half}, lobe, 4);
  for (size_t i = 0; i < kCoefficients; ++i) EXPECT_NEAR(moved[i], wanted[i], 2e-6);
}

// Zero, and lengths whose squares no float can hold.
TEST_P(RotateAccuracy, TakesQuaternionsOfAnyLength) {
  Random random(2);
  for (const uint32_t n : {2u, 3u, 6u, 10u}) {
    const Floats q = RandomItems(random, 4), f = RandomItems(random, n * n);
    const Floats wanted = Rotated(n, q, f, 4);
    for (const float length : {1e-36f, 1e-19f, 1e-9f, 1e9f, 1e19f, 1e38f}) {
      Floats scaled = q;
      for (float& x : scaled) x *= length;
      const Floats found = Rotated(n, scaled, f, 4);
      for (size_t i = 0; i < f.size(); ++i) ASSERT_NEAR(found[i], wanted[i], 3e-6) << length;
    }
    const Floats unturned = Rotated(n, {0, 0, 0, 0}, f, 4);
    for (size_t i = 0; i < f.size(); ++i) ASSERT_EQ(unturned[i], f[i]);
  }
}

using Quaternion = std::array<double, 4>;

// p after q, of length 1.
Quaternion Product(const Quaternion& p, const Quaternion& q) {
  Quaternion out = {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
                    p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
                    p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
                    p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
  double squared = 0.0;
  for (const double x : out) squared += x * x;
  for (double& x : out) x /= std::sqrt(squared);
  return out;
}

// By up to 6 degrees about any axis, in floats.
Floats SmallRotation(Random& random) {
  Floats step(4);
  random.Direction(step.data());
  for (float& x : step) x *= random.Between(0.01, 0.05);
  step[3] = 1.0f;
  return step;
}

// 1000 small rotations of the coefficients, one after the other, against one by their product.
TEST_P(RotateAccuracy, DriftsLittleAndKeepsTheNormOfEachBand) {
  constexpr int kObjects = 8;
  double error = 0.0, growth[6] = {};
  for (uint64_t object = 0; object < kObjects; ++object) {
    Random random(object);
    const Floats start = RandomItems(random, kCoefficients);
    Floats rotated = start;
    Quaternion whole = {0, 0, 0, 1};
    for (int i = 0; i < 1000; ++i) {
      const Floats step = SmallRotation(random);
      rotated = Rotated(6, step, rotated, 4);
      whole = Product({step[0], step[1], step[2], step[3]}, whole);
    }
    double matrix[9];
    rotate::MatrixReference(whole.data(), matrix);
    const std::vector<double> f(start.begin(), start.end());
    std::vector<double> wanted(kCoefficients);
    rotate::RotateReference(6, 1, matrix, f.data(), wanted.data());
    for (int l = 0; l < 6; ++l) {
      double before = 0.0, after = 0.0;
      for (size_t i = static_cast<size_t>(l * l); i < static_cast<size_t>((l + 1) * (l + 1)); ++i) {
        error = std::max(error, std::abs(rotated[i] - wanted[i]));
        before += f[i] * f[i];
        after += double{rotated[i]} * double{rotated[i]};
      }
      growth[l] += (std::sqrt(after / before) - 1.0) / kObjects;
    }
  }
  EXPECT_LT(error, 6e-5);
  // Rounding that is not even-handed makes 1e-4 of it.
  for (int l = 0; l < 6; ++l) EXPECT_NEAR(growth[l], 0.0, 1.5e-5) << "band " << l;
}

GAUNT_INSTANTIATE_TARGETS(RotateAccuracy);

}  // namespace
}  // namespace gaunt::test
