// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/basis_reference.h"
#include "light/search_points.h"
#include "points/design.h"
#include "points/repulsion.h"
#include "tests/support/designs.h"
#include "tests/support/random.h"

namespace gaunt::points {

void PrintTo(const Point& p, std::ostream* os) {
  *os << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
}

}  // namespace gaunt::points

namespace gaunt::test {
namespace {

using points::Point;
using points::PointSet;

const double kPi = std::acos(-1.0);

PointSet SearchPoints(const light::SearchPointsSet& committed) {
  return MakeSet(committed.points, committed.count);
}

void ExpectSame(const PointSet& a, const PointSet& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], tolerance) << "point " << i;
  }
}

void ExpectUnitLengths(const PointSet& set) {
  for (const Point& p : set) {
    EXPECT_NEAR(points::Dot(p, p), 1.0, 1e-15) << testing::PrintToString(p);
  }
}

// Mean of x^a y^b z^c over the sphere: 0 if one of them is odd, else
// (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!!
double MonomialMean(int a, int b, int c) {
  if (a % 2 + b % 2 + c % 2 > 0) return 0.0;
  const auto double_factorial = [](int n) {
    double product = 1.0;
    for (; n > 1; n -= 2) product *= n;
    return product;
  };
  return double_factorial(a - 1) * double_factorial(b - 1) * double_factorial(c - 1) /
         double_factorial(a + b + c + 1);
}

// One row per order, 1 to 6.
struct Published {
  int count;
  double energy;    // Wales and Ulker 2006, 9 decimals
  double covering;  // degrees, of the best coverings, to the nearest half
};
constexpr Published kPublished[] = {{1, 0.0, 180.0},          {3, 1.732050808, 90.0},
                                    {6, 9.985281374, 54.7},   {10, 32.716949460, 42.3},
                                    {15, 80.670244114, 35.0}, {22, 185.287536149, 28.0}};

TEST(Repulsion, SearchPointsAreThoseOfTheGenerator) {
  ASSERT_EQ(std::size(light::kSearchPoints), std::size(kPublished));
  for (size_t i = 0; i < std::size(kPublished); ++i) {
    ASSERT_EQ(light::kSearchPoints[i].count, kPublished[i].count);
    ExpectSame(points::Repulsion(kPublished[i].count), SearchPoints(light::kSearchPoints[i]),
               1e-12);
  }
}

TEST(Repulsion, HasThePublishedEnergiesAndCoveringRadii) {
  for (size_t i = 0; i < std::size(kPublished); ++i) {
    const PointSet set = SearchPoints(light::kSearchPoints[i]);
    ExpectUnitLengths(set);
    EXPECT_NEAR(points::CoulombEnergy(set), kPublished[i].energy, 1e-9) << set.size();
    EXPECT_NEAR(points::CoveringRadius(set) * 180.0 / kPi, kPublished[i].covering, 0.5)
        << set.size();
  }
}

// The forces have no part along the sphere: a definition that knows no generator.
TEST(Repulsion, LeavesPointsAtRest) {
  for (const light::SearchPointsSet& committed : light::kSearchPoints) {
    const PointSet set = SearchPoints(committed);
    double squared = 0.0;
    for (const Point& p : set) {
      Point force = {};
      for (const Point& q : set) {
        const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        if (distance == 0.0) continue;
        for (size_t k = 0; k < 3; ++k) force[k] += (p[k] - q[k]) / std::pow(distance, 3);
      }
      const double outward = points::Dot(force, p);
      for (size_t k = 0; k < 3; ++k) squared += std::pow(force[k] - outward * p[k], 2);
    }
    EXPECT_LE(std::sqrt(squared), 1e-12) << committed.count << " points";
  }
}

TEST(Repulsion, FindsTheShapesOfFewPoints) {
  ExpectSame(points::Repulsion(1), {{0.0, 0.0, 1.0}}, 0.0);
  ExpectSame(points::Repulsion(2), {{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}, 1e-15);
  const double h = std::sqrt(0.75), third = 1.0 / 3.0;
  ExpectSame(points::Repulsion(3), {{0.0, 0.0, 1.0}, {h, 0.0, -0.5}, {-h, 0.0, -0.5}}, 1e-15);
  const double r = std::sqrt(8.0) / 3.0;  // a tetrahedron
  ExpectSame(
      points::Repulsion(4),
      {{0.0, 0.0, 1.0}, {r, 0.0, -third}, {-0.5 * r, h * r, -third}, {-0.5 * r, -h * r, -third}},
      1e-14);
}

// The first start, and most of the others, end in higher minima.
TEST(Repulsion, SeesFurtherThanTheNearestMinimum) {
  EXPECT_NEAR(points::CoulombEnergy(points::Repulsion(37)), 560.618887731, 1e-9);
}

TEST(Design, CommittedOnesAreThoseOfTheGenerator) {
  for (const DesignPointsSet& committed : kDesignPoints) {
    ExpectSame(points::SymmetricDesign(committed.strength), SphericalDesign(committed.strength),
               1e-12);
  }
}

// By definition: means of spherical harmonics vanish up to the strength, and not beyond.
TEST(Design, MeansOfHarmonicsVanish) {
  for (const DesignPointsSet& committed : kDesignPoints) {
    const PointSet set = SphericalDesign(committed.strength);
    ExpectUnitLengths(set);
    const int order = committed.strength + 2;
    std::vector<double> y(static_cast<size_t>(order * order)), mean(y.size(), 0.0);
    for (const Point& p : set) {
      basis::EvalReference(order, p.data(), y.data());
      for (size_t i = 0; i < y.size(); ++i) mean[i] += y[i] / static_cast<double>(set.size());
    }
    EXPECT_NEAR(mean[0], 0.5 / std::sqrt(kPi), 1e-14);
    const size_t bands = static_cast<size_t>(order) - 1, beyond = bands * bands;
    double within = 0.0, above = 0.0;
    for (size_t i = 1; i < beyond; ++i) within = std::max(within, std::abs(mean[i]));
    for (size_t i = beyond; i < y.size(); ++i) above = std::max(above, std::abs(mean[i]));
    EXPECT_LE(within, 1e-14) << "strength " << committed.strength;
    EXPECT_GE(above, 1e-4) << "strength " << committed.strength;
    EXPECT_NEAR(points::DesignResidual(committed.strength, set), within, 1e-15);
    EXPECT_NEAR(points::DesignResidual(committed.strength + 1, set), above, 1e-14);
  }
}

// y_1^0 = sqrt(3 / 4 pi) z is all that one point at +z leaves up to strength 1.
TEST(Design, ResidualIsTheLargestMean) {
  EXPECT_NEAR(points::DesignResidual(1, {{0.0, 0.0, 1.0}}), std::sqrt(0.75 / kPi), 1e-15);
}

TEST(Design, IntegratesMonomials) {
  for (const DesignPointsSet& committed : kDesignPoints) {
    const PointSet set = SphericalDesign(committed.strength);
    for (int a = 0; a <= committed.strength; ++a) {
      for (int b = 0; a + b <= committed.strength; ++b) {
        for (int c = 0; a + b + c <= committed.strength; ++c) {
          double sum = 0.0;
          for (const Point& p : set) {
            sum += std::pow(p[0], a) * std::pow(p[1], b) * std::pow(p[2], c);
          }
          ASSERT_NEAR(sum / static_cast<double>(set.size()), MonomialMean(a, b, c), 1e-14)
              << "strength " << committed.strength << ", x^" << a << " y^" << b << " z^" << c;
        }
      }
    }
  }
}

TEST(Design, HasTheOppositeOfEachPoint) {
  for (const DesignPointsSet& committed : kDesignPoints) {
    const PointSet set = SphericalDesign(committed.strength);
    for (const Point& p : set) {
      EXPECT_EQ(std::count(set.begin(), set.end(), Point{-p[0], -p[1], -p[2]}), 1)
          << testing::PrintToString(p);
    }
  }
}

TEST(Design, OfLowStrengthIsTight) {
  for (const int strength : {1, 3, 5}) {
    const PointSet set = points::SymmetricDesign(strength);
    EXPECT_EQ(set.size(), static_cast<size_t>((strength + 1) * (strength + 3) / 4));
    EXPECT_LE(points::DesignResidual(strength, set), 1e-14);
  }
}

TEST(Design, OfAtLeastAStrengthIsTheSmallest) {
  EXPECT_EQ(SphericalDesign(0).size(), static_cast<size_t>(kDesignPoints[0].count));
  EXPECT_EQ(SphericalDesign(kDesignPoints[0].strength + 1).size(),
            static_cast<size_t>(kDesignPoints[1].count));
  EXPECT_THROW(SphericalDesign(1000), std::out_of_range);
}

// No direction is farther from all points than the covering radius, and some are nearly as far.
TEST(PointSet, CoveringRadiusCovers) {
  Random random(3);
  for (const light::SearchPointsSet& committed : light::kSearchPoints) {
    const PointSet set = SearchPoints(committed);
    double farthest = 0.0;
    for (int trial = 0; trial < 20000; ++trial) {
      float d[3];
      random.Direction(d);
      double nearest = 2.0 * kPi;
      for (const Point& p : set) {
        nearest = std::min(
            nearest, std::acos(std::clamp(points::Dot(p, points::Normalized({d[0], d[1], d[2]})),
                                          -1.0, 1.0)));
      }
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, points::CoveringRadius(set) + 1e-12) << committed.count << " points";
    EXPECT_GE(farthest, points::CoveringRadius(set) - 0.03) << committed.count << " points";
  }
}

TEST(PointSet, SeparationIsTheAngleOfTheNearestTwo) {
  for (const DesignPointsSet& committed : kDesignPoints) {
    const PointSet set = SphericalDesign(committed.strength);
    double largest = -1.0;
    for (size_t i = 0; i < set.size(); ++i) {
      for (size_t j = 0; j < i; ++j) largest = std::max(largest, points::Dot(set[i], set[j]));
    }
    EXPECT_NEAR(points::Separation(set), std::acos(largest), 1e-13);
  }
}

// Turned, mirrored and in another order, a set has the same canonical form.
TEST(PointSet, CanonicalFormIsOfTheShapeOnly) {
  Random random(5);
  for (const light::SearchPointsSet& committed : light::kSearchPoints) {
    const PointSet set = SearchPoints(committed);
    float a[3], b[3];
    random.Direction(a);
    random.Direction(b);
    const Point z = points::Normalized({a[0], a[1], a[2]});
    const Point x = points::Normalized(points::Cross(z, {b[0], b[1], b[2]}));
    const Point y = points::Cross(x, z);  // left-handed
    PointSet turned;
    for (const Point& p : set) {
      turned.insert(turned.begin(), {points::Dot(p, x), points::Dot(p, y), points::Dot(p, z)});
    }
    const PointSet canonical = points::Canonical(turned);
    ExpectSame(canonical, set, 1e-14);
    EXPECT_NEAR(canonical[0][2], 1.0, 1e-15);
    if (canonical.size() < 2) continue;
    EXPECT_GT(canonical[1][0], 0.0);
    EXPECT_NEAR(canonical[1][1], 0.0, 1e-15);
    EXPECT_NEAR(std::acos(canonical[1][2]), points::Separation(set), 1e-14);
  }
}

}  // namespace
}  // namespace gaunt::test
