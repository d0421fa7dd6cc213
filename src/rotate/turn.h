// SPDX-License-Identifier: MIT
// The matrix of the one change of axes that mixes coefficients: x and z swapped. All others are
// this one between two that only move and negate coefficients. Signs are those without the
// Condon-Shortley phase; with it, it is x and -z that are swapped.
#ifndef GAUNT_ROTATE_TURN_H_
#define GAUNT_ROTATE_TURN_H_

#include <cstdint>

#include "basis/constants.h"

namespace gaunt::rotate {

// Orders that the table holds.
inline constexpr int kMaxTurnOrder = 16;

// Entries for |m'| and |m| of one band, all bands packed. An entry of even l + m' + m couples the
// cosines (m', m >= 0), one of odd l + m' + m the sines; other pairs are not coupled.
constexpr int TurnIndex(int l, int m_out, int m_in) {
  return l * (l + 1) * (2 * l + 1) / 6 + m_out * (l + 1) + m_in;
}

// Wigner's d of a quarter turn, by the one formula that is all integers but for a square root:
//   d_m'm = 2^-l sqrt(C(2l, l+m) / C(2l, l+m')) K,  K = [t^(l+m')] (t - 1)^(l-m) (t + 1)^(l+m),
// times sqrt(2) for each of m', m that is not 0, because real functions pair +m and -m. K stays
// below C(2l, l), so nothing rounds until the end. (Edmonds 1957, section 4.1, at beta = pi/2.)
struct TurnTable {
  double entry[kMaxTurnOrder * (kMaxTurnOrder + 1) * (2 * kMaxTurnOrder + 1) / 6] = {};

  constexpr TurnTable() {
    int64_t choose[2 * kMaxTurnOrder][2 * kMaxTurnOrder] = {};
    for (int n = 0; n < 2 * kMaxTurnOrder; ++n) {
      choose[n][0] = 1;
      for (int k = 1; k <= n; ++k) choose[n][k] = choose[n - 1][k - 1] + choose[n - 1][k];
    }
    for (int l = 0; l < kMaxTurnOrder; ++l) {
      for (int m_out = 0; m_out <= l; ++m_out) {
        for (int m_in = 0; m_in <= l; ++m_in) {
          int64_t sum = 0;
          for (int k = 0; k <= l - m_in && k <= l + m_out; ++k) {
            const int64_t term = choose[l - m_in][k] * choose[l + m_in][l + m_out - k];
            sum += (l - m_in - k) % 2 == 0 ? term : -term;
          }
          const double pairs = (m_out != 0 ? 2.0 : 1.0) * (m_in != 0 ? 2.0 : 1.0);
          const double ratio = pairs * static_cast<double>(choose[2 * l][l + m_in]) /
                               static_cast<double>(choose[2 * l][l + m_out]);
          entry[TurnIndex(l, m_out, m_in)] = static_cast<double>(sum) * ConstexprSqrt(ratio) /
                                             static_cast<double>(int64_t{1} << l);
        }
      }
    }
  }
};

inline constexpr TurnTable kTurn;

// The same in float, for what applies it again and again: rounded so that no band as a whole grows
// or shrinks, which rounding each entry to the nearest does by up to 4e-8 each time.
struct FloatTurnTable {
  float entry[TurnIndex(kMaxTurnOrder, 0, 0)] = {};

  constexpr FloatTurnTable() {
    for (int l = 0; l < kMaxTurnOrder; ++l) {
      double growth = 0.0;  // of the sum of squares, halved
      for (int m_out = 0; m_out <= l; ++m_out) {
        for (int m_in = 0; m_in <= l; ++m_in) {
          const int i = TurnIndex(l, m_out, m_in);
          entry[i] = static_cast<float>(kTurn.entry[i]);
          growth += IsUsed(l, m_out, m_in) * kTurn.entry[i] * (double{entry[i]} - kTurn.entry[i]);
        }
      }
      while (Improve(l, growth)) {
      }
    }
  }

 private:
  // Sines have no entries for m = 0.
  static constexpr bool IsUsed(int l, int m_out, int m_in) {
    return (l + m_out + m_in) % 2 == 0 || (m_out != 0 && m_in != 0);
  }

  static constexpr float Ulp(float x) {
    float power = 1.0f;
    while (power > (x < 0.0f ? -x : x)) power *= 0.5f;
    return power * 0x1p-23f;
  }

  // Moves the entry, and its twin across the diagonal, that brings the growth closest to 0, to a
  // float beside it that is within one ulp of the exact value. False if none brings it closer.
  constexpr bool Improve(int l, double& growth) {
    Move best = {};
    double least = Abs(growth);
    for (int m_out = 0; m_out <= l; ++m_out) {
      for (int m_in = m_out; m_in <= l; ++m_in) {
        const int i = TurnIndex(l, m_out, m_in);
        const double exact = kTurn.entry[i];
        // Ones stay what they are, and cost no multiplication.
        if (!IsUsed(l, m_out, m_in) || exact == 0.0 || Abs(exact) == 1.0) continue;
        const float ulp = Ulp(entry[i]);
        for (const float to : {entry[i] - ulp, entry[i] + ulp}) {
          if (Abs(to - exact) > double{ulp}) continue;
          const double twins = m_out == m_in ? 1.0 : 2.0;
          const double moved = growth + twins * exact * (double{to} - double{entry[i]});
          if (Abs(moved) < least) {
            least = Abs(moved);
            best = {i, TurnIndex(l, m_in, m_out), to, moved};
          }
        }
      }
    }
    if (least == Abs(growth)) return false;
    entry[best.index] = entry[best.twin] = best.to;
    growth = best.growth;
    return true;
  }

  struct Move {
    int index, twin;
    float to;
    double growth;
  };
  static constexpr double Abs(double x) { return x < 0.0 ? -x : x; }
};

inline constexpr FloatTurnTable kFloatTurn;

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_TURN_H_
