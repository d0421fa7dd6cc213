// SPDX-License-Identifier: MIT
// Constants of ZH3 (Roughton, Sloan, Silvennoinen, Iwanicki and Shirley 2024) and of the non-linear
// evaluation of order 2 by Geomerics (Hazel 2017).
#ifndef GAUNT_ZH3_CONSTANTS_H_
#define GAUNT_ZH3_CONSTANTS_H_

#include "evaluate/constants.h"
#include "light/constants.h"

namespace gaunt::zh3 {

inline constexpr double kSqrt3 = ConstexprSqrt(3.0);

// |band 1| / band 0 of light from one direction: no non-negative light has more.
inline constexpr double kMaxRatio = kSqrt3;

// Below this, a vector has no direction.
inline constexpr double kLeastVector = 1e-37;

// k2 / L_0 = linear r + quadratic r^2 of a model, r = |band 1 along the axis| / L_0.
struct Curve {
  double linear;
  double quadratic;
};
// From GAUNT_ZH3_MODEL_AMBIENT_DIRECTIONAL up.
inline constexpr Curve kModels[] = {
    {ConstexprSqrt(5.0 / 3.0), 0.0},
    {-ConstexprSqrt(5.0 / 3.0), 2.0 * ConstexprSqrt(5.0) / 3.0},
    {0.08, 0.6},
};

inline constexpr float kLuminance[3] = {static_cast<float>(light::kLuminance[0]),
                                        static_cast<float>(light::kLuminance[1]),
                                        static_cast<float>(light::kLuminance[2])};

// E/pi of k2 is kZonal (3 cos^2 - 1) k2: a quarter of sqrt(5 / (16 pi)).
inline constexpr double kZonal = evaluate::CosineBand(2) * -basis::kSecondConstant<0>;

// The refit weighs bands 1 and 2 by the clamped cosine.
inline constexpr double kBand1 = evaluate::CosineBand(1);
inline constexpr double kBand2 = evaluate::CosineBand(2);
// The refitted band 1 has at least this much along its axis, relative to the largest coefficient
// (both weighted): rounding must not turn the axis.
inline constexpr double kLeastAlong = 0x1p-10;

// The six axes of an icosahedron, from which the refit climbs. (0, 1, g), (1, g, 0), (g, 0, 1) and
// their mirror images, g the golden ratio, normalised.
inline constexpr int kStarts = 6;
inline constexpr int kFirstSteps = 4,
                     kLastSteps = 8;  // of Newton's method, from each and from the best
inline constexpr double kShort = ConstexprSqrt((5.0 - ConstexprSqrt(5.0)) / 10.0);
inline constexpr double kLong = ConstexprSqrt((5.0 + ConstexprSqrt(5.0)) / 10.0);
inline constexpr float kStart[kStarts][3] = {
    {0.0f, static_cast<float>(kShort), static_cast<float>(kLong)},
    {0.0f, static_cast<float>(-kShort), static_cast<float>(kLong)},
    {static_cast<float>(kShort), static_cast<float>(kLong), 0.0f},
    {static_cast<float>(kShort), static_cast<float>(-kLong), 0.0f},
    {static_cast<float>(kLong), 0.0f, static_cast<float>(kShort)},
    {static_cast<float>(-kLong), 0.0f, static_cast<float>(kShort)},
};

}  // namespace gaunt::zh3

#endif  // GAUNT_ZH3_CONSTANTS_H_
