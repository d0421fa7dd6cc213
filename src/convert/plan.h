// SPDX-License-Identifier: MIT
// A conversion between two conventions as rows: which planes, times which factors, make a plane.
#ifndef GAUNT_CONVERT_PLAN_H_
#define GAUNT_CONVERT_PLAN_H_

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "convert/convention.h"
#include "evaluate/constants.h"
#include "rotate/turn.h"
#include "simd/order.h"

namespace gaunt::convert {

// Where coefficient m lies in its band.
constexpr int PositionOf(Coefficients coefficients, int l, int m) {
  const int magnitude = m < 0 ? -m : m;
  switch (coefficients) {
    case Coefficients::kSid: return 2 * (l - magnitude) + (m < 0 ? 1 : 0);
    case Coefficients::kFuma:
      if (l == 1) return PositionOf(Coefficients::kSid, l, m);
      return m > 0 ? 2 * m - 1 : -2 * m;
    default: return l + m;
  }
}

// The coefficient of a scale where the orthonormal one is 1.
inline double ScaleOf(Scale scale, int l, int m) {
  const int magnitude = m < 0 ? -m : m;
  const double sn3d = std::sqrt(4.0 * kPi / (2 * l + 1));
  switch (scale) {
    case Scale::kN3d: return std::sqrt(4.0 * kPi);
    case Scale::kSn3d: return sn3d;
    case Scale::kFuma: {
      // Largest value 1 in each function but the first: Malham's weights.
      if (l == 0) return sn3d / std::sqrt(2.0);
      if (l == 2 && magnitude > 0) return sn3d * std::sqrt(4.0 / 3.0);
      if (l == 3 && magnitude == 1) return sn3d * std::sqrt(45.0 / 32.0);
      if (l == 3 && magnitude == 2) return sn3d * std::sqrt(9.0 / 5.0);
      if (l == 3 && magnitude == 3) return sn3d * std::sqrt(8.0 / 5.0);
      return sn3d;
    }
    case Scale::kPolynomial: {
      const double band = l < 2 ? 2 * l + 1 : m == 0 ? 1.25 : m == 2 ? 3.75 : 15.0;
      return std::sqrt(band / (4.0 * kPi));
    }
    default: return 1.0;
  }
}

// (S d)_k = sign[k] d_source[k]: a change of axes.
struct AxisChange {
  int source[3];
  int sign[3];

  // d_from = S d_to for the same direction in two conventions.
  static AxisChange Between(const Axis (&from)[3], const Axis (&to)[3]) {
    AxisChange change = {};
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        if (LineOf(from[k]) != LineOf(to[j])) continue;
        change.source[k] = j;
        change.sign[k] = SignOf(from[k]) * SignOf(to[j]);
      }
    }
    return change;
  }

  AxisChange operator*(const AxisChange& o) const {
    AxisChange product = {};
    for (int k = 0; k < 3; ++k) {
      product.source[k] = o.source[source[k]];
      product.sign[k] = sign[k] * o.sign[source[k]];
    }
    return product;
  }

  // z stays on its line.
  bool IsFlat() const { return source[2] == 2; }
};

struct Moved {
  int m;
  int sign;
};

// Where a flat change takes coefficient m of the result from. With w = x + i y, functions of +m and
// -m are the real and the imaginary part of w^m, and the change makes w a unit times w or its
// conjugate; in z they are even or odd with l + m.
inline Moved MoveOf(const AxisChange& change, int l, int m) {
  const int magnitude = m < 0 ? -m : m;
  const bool odd = magnitude % 2 == 1;
  const int turned = magnitude % 4 < 2 ? 1 : -1;  // the sign in i^m
  const int mirrored = change.sign[0] * change.sign[1];
  Moved moved = {m, odd ? change.sign[0] : 1};
  if (change.source[0] == 0) {
    if (m < 0) moved.sign *= mirrored;
  } else if (odd) {
    moved.m = -m;
    moved.sign *= m < 0 ? turned : turned * mirrored;
  } else {
    moved.sign *= m < 0 ? -turned * mirrored : turned;
  }
  if (change.sign[2] < 0 && (l + magnitude) % 2 == 1) moved.sign = -moved.sign;
  return moved;
}

// Rows of some bands. Row r makes plane r of these bands from terms begin[r] .. begin[r + 1]:
// factor times the plane that lies `source` planes into the band.
struct Plan {
  static constexpr int kMaxRows = 2 * kMaxOrder - 1;
  static constexpr int kMaxTerms = 256;  // of the last band that turns, or of a chunk below

  int first_band;
  int end_band;
  bool exact;       // one term per row, its factor 1 or -1
  bool moves;       // some row reads another plane than its own
  bool staged;      // bands are copied before they are written: the conversion is in place
  double constant;  // added to row 0
  uint16_t begin[kMaxRows + 1];
  uint8_t source[kMaxTerms];
  double factor[kMaxTerms];

  int rows() const { return end_band * end_band - first_band * first_band; }
};

class Conversion {
 public:
  Conversion(const Convention& from, const Convention& to)
      : from_(from), to_(to), change_(AxisChange::Between(from.axes, to.axes)) {
    constexpr AxisChange kTurned = {{2, 1, 0}, {1, 1, 1}};
    constexpr AxisChange kNone = {{0, 1, 2}, {1, 1, 1}};
    constexpr AxisChange kSwapped = {{1, 0, 2}, {1, 1, 1}};
    after_ = change_.source[2] == 1 ? kSwapped : kNone;
    before_ = IsFlat() ? change_ : change_ * after_ * kTurned;  // all but the first undo themselves
  }

  bool IsFlat() const { return change_.IsFlat(); }

  // Whether the conversion exists for these orders.
  bool Has(int order) const {
    if (order > MaxOrderOf(from_, kMaxOrder) || order > MaxOrderOf(to_, kMaxOrder)) return false;
    if (!IsFlat() && order > rotate::kMaxTurnOrder) return false;
    // Band 3 of irradiance is gone.
    return !(IsIrradiance(from_.quantity) && !IsIrradiance(to_.quantity) && order > 3);
  }

  void Fill(int first_band, int end_band, Plan& plan) const {
    plan.first_band = first_band;
    plan.end_band = end_band;
    plan.constant = first_band == 0 ? Constant() : 0.0;
    plan.exact = plan.constant == 0.0;
    plan.moves = false;
    int terms = 0, row = 0;
    for (int l = first_band; l < end_band; ++l) {
      for (int position = 0; position <= 2 * l; ++position, ++row) {
        plan.begin[row] = static_cast<uint16_t>(terms);
        const int begin = terms;
        ForEachTerm(l, MAt(l, position), [&](int m_from, double factor) {
          const int source = PositionOf(from_.coefficients, l, m_from);
          plan.source[terms] = static_cast<uint8_t>(source);
          plan.factor[terms] = factor;
          ++terms;
          if (std::abs(factor) != 1.0) plan.exact = false;
          if (source != position) plan.moves = true;
        });
        if (terms != begin + 1) plan.exact = false;
      }
    }
    plan.begin[row] = static_cast<uint16_t>(terms);
  }

 private:
  int MAt(int l, int position) const {
    for (int m = -l; m <= l; ++m) {
      if (PositionOf(to_.coefficients, l, m) == position) return m;
    }
    return 0;
  }

  // term(m_from, factor) for each coefficient that coefficient m of the result is made of.
  template <class Term>
  void ForEachTerm(int l, int m, const Term& term) const {
    const auto emit = [&](Moved moved, double factor) {
      term(moved.m, factor * moved.sign * Phase(m, moved.m) * Ratio(l, m, moved.m));
    };
    if (IsFlat()) return emit(MoveOf(before_, l, m), 1.0);
    const Moved last = MoveOf(after_, l, m);
    const int magnitude = std::abs(last.m);
    const int direction = last.m < 0 ? -1 : 1;
    // Sines are coupled where l + m' + m is odd, and there is none of m = 0.
    const int parity = (l + magnitude + (last.m < 0 ? 1 : 0)) % 2;
    for (int k = parity == 0 && last.m < 0 ? 2 : parity; k <= l; k += 2) {
      const double entry = rotate::kTurn.entry[rotate::TurnIndex(l, magnitude, k)];
      emit(MoveOf(before_, l, direction * k), last.sign * entry);
    }
  }

  // (-1)^m where one of the two has the Condon-Shortley phase.
  double Phase(int m_to, int m_from) const {
    const bool to = to_.sign == Sign::kCondonShortley && m_to % 2 != 0;
    const bool from = from_.sign == Sign::kCondonShortley && m_from % 2 != 0;
    return to == from ? 1.0 : -1.0;
  }

  double Ratio(int l, int m_to, int m_from) const {
    return ScaleOf(to_.scale, l, m_to) / ScaleOf(from_.scale, l, m_from) * QuantityRatio(l);
  }

  double QuantityRatio(int l) const {
    const auto pi = [](Quantity quantity) {
      return quantity == Quantity::kIrradiance       ? kPi
             : quantity == Quantity::kRadianceOverPi ? 1.0 / kPi
                                                     : 1.0;
    };
    const bool to = IsIrradiance(to_.quantity), from = IsIrradiance(from_.quantity);
    const double cosine = to == from ? 1.0 : evaluate::CosineBand(l);
    return pi(to_.quantity) / pi(from_.quantity) * (from ? 1.0 / cosine : cosine);
  }

  // The difference of the offsets is a constant function, and y_0 is 1 / (2 sqrt(pi)).
  double Constant() const {
    const double value =
        static_cast<double>(from_.offset) * QuantityRatio(0) - static_cast<double>(to_.offset);
    return value * 2.0 * std::sqrt(kPi) * ScaleOf(to_.scale, 0, 0);
  }

  Convention from_;
  Convention to_;
  AxisChange change_;
  // The change, or, where z turns: change = before, x and z swapped, after.
  AxisChange before_;
  AxisChange after_;
};

}  // namespace gaunt::convert

#endif  // GAUNT_CONVERT_PLAN_H_
