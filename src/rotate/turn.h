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

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_TURN_H_
