// SPDX-License-Identifier: MIT
#include "points/point_set.h"

#include <algorithm>
#include <random>
#include <utility>

namespace gaunt::points {
namespace {

constexpr double kTie = 1e-9;    // below it, two distances or coordinates are the same
constexpr double kZero = 1e-14;  // below it, a coordinate is rounding noise

double SmallestSquaredDistance(const PointSet& set) {
  double smallest = 8.0;  // no two points are that far apart
  for (size_t i = 0; i < set.size(); ++i) {
    for (size_t j = 0; j < i; ++j) smallest = std::min(smallest, SquaredDistance(set[i], set[j]));
  }
  return smallest;
}

// A point before which no other of an ordered set comes: top first. Whole multiples of kTie, so
// that rounding noise does not decide.
using Key = std::array<int64_t, 3>;
Key SortKey(const Point& p) {
  return {-std::llround(p[2] / kTie), -std::llround(p[0] / kTie), -std::llround(p[1] / kTie)};
}

using KeyedSet = std::vector<std::pair<Key, Point>>;

// The set in the frame of three axes, sorted.
KeyedSet InFrame(const PointSet& set, const Point& x, const Point& y, const Point& z) {
  KeyedSet keyed;
  for (const Point& p : set) {
    Point turned = Normalized({Dot(p, x), Dot(p, y), Dot(p, z)});
    for (double& c : turned) c = std::abs(c) < kZero ? 0.0 : c;
    keyed.emplace_back(SortKey(turned), turned);
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

bool ComesBefore(const KeyedSet& a, const KeyedSet& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const auto& left, const auto& right) { return left.first < right.first; });
}

}  // namespace

Point Perpendicular(const Point& a) {
  // The axis that is farthest from a.
  const size_t k = static_cast<size_t>(
      std::min_element(a.begin(), a.end(),
                       [](double left, double right) { return std::abs(left) < std::abs(right); }) -
      a.begin());
  Point axis = {};
  axis[k] = 1.0;
  return Normalized(Cross(a, axis));
}

// The standard fixes the numbers of its engines, not those of its distributions.
PointSet RandomPoints(int count, uint32_t seed) {
  std::mt19937_64 random(seed);
  PointSet set;
  while (set.size() < static_cast<size_t>(count)) {
    Point p;
    for (double& x : p) x = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
    const double squared = Dot(p, p);
    if (squared > 0.01 && squared <= 1.0) set.push_back(Normalized(p));
  }
  return set;
}

double Separation(const PointSet& set) {
  if (set.size() < 2) return 2.0 * std::acos(-1.0);
  return 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(SmallestSquaredDistance(set))));
}

// The distance to the nearest point is largest opposite to one point, or half way around between
// two, or at the same distance from three. All of these are tried.
double CoveringRadius(const PointSet& set) {
  double best = 2.0;  // the smallest cosine so far of a direction to its nearest point
  const auto visit = [&](const Point& direction) {
    double nearest = -1.0;
    for (const Point& p : set) {
      nearest = std::max(nearest, Dot(direction, p));
      if (nearest >= best) return;
    }
    best = nearest;
  };
  const auto visit_both = [&](const Point& direction) {
    visit(direction);
    visit(Opposite(direction));
  };
  for (size_t i = 0; i < set.size(); ++i) {
    visit(Opposite(set[i]));
    for (size_t j = 0; j < i; ++j) {
      const Point middle = Along(set[i], 1.0, set[j]);
      visit_both(Dot(middle, middle) > kTie ? Normalized(middle) : Perpendicular(set[i]));
      for (size_t k = 0; k < j; ++k) {
        const Point normal = Cross(Along(set[j], -1.0, set[i]), Along(set[k], -1.0, set[i]));
        if (Dot(normal, normal) > kTie * kTie) visit_both(Normalized(normal));
      }
    }
  }
  return std::acos(std::clamp(best, -1.0, 1.0));
}

PointSet Canonical(const PointSet& set) {
  const double smallest = SmallestSquaredDistance(set);
  KeyedSet best;
  const auto offer = [&](const Point& z, const Point& x) {
    const Point y = Cross(z, x);
    for (const Point& side : {y, Opposite(y)}) {
      KeyedSet candidate = InFrame(set, x, side, z);
      if (best.empty() || ComesBefore(candidate, best)) best = std::move(candidate);
    }
  };
  if (set.size() == 1) offer(set[0], Perpendicular(set[0]));
  for (size_t i = 0; i < set.size(); ++i) {
    for (size_t j = 0; j < set.size(); ++j) {
      if (i == j || SquaredDistance(set[i], set[j]) > smallest + kTie) continue;
      const Point x = Along(set[j], -Dot(set[j], set[i]), set[i]);
      offer(set[i], Dot(x, x) > kTie ? Normalized(x) : Perpendicular(set[i]));
    }
  }
  PointSet canonical;
  for (const auto& [key, point] : best) canonical.push_back(point);
  return canonical;
}

}  // namespace gaunt::points
