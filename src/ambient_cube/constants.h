// SPDX-License-Identifier: MIT
// Constants of the ambient cube (Mitchell, McTaggart and Green 2006).
#ifndef GAUNT_AMBIENT_CUBE_CONSTANTS_H_
#define GAUNT_AMBIENT_CUBE_CONSTANTS_H_

#include "evaluate/constants.h"

namespace gaunt::ambient_cube {

// Planes of a cube: of each face, +X, -X, +Y, -Y, +Z, -Z, its three channels.
inline constexpr int kChannels = 3;
inline constexpr int kFaces = 6;
inline constexpr int kPlanes = kChannels * kFaces;
constexpr size_t FacePlane(size_t axis, bool negative, size_t channel) {
  return kChannels * (2 * axis + (negative ? 1 : 0)) + channel;
}

// E/pi of band 1 along its axis, and the multiple of it that is closest over the sphere.
using Axis = evaluate::QuadraticConstants<evaluate::IrradianceBands>;
inline constexpr double kSampledLinear = Axis::kLinear;
inline constexpr double kClosestLinear = 1.25 * Axis::kLinear;

// E/pi of band 4 on the axes: m = 0 on z, m = 0 on x and y, m = 2 on y (less that on x), m = 4 on x
// and y.
inline constexpr double kBand4 = evaluate::CosineBand(4) / ConstexprSqrt(kPi);
inline constexpr double kFourthPole = 3.0 / 2.0 * kBand4;
inline constexpr double kFourthEquator = 9.0 / 16.0 * kBand4;
inline constexpr double kFourthTwo = 3.0 / 8.0 * ConstexprSqrt(5.0) * kBand4;
inline constexpr double kFourthFour = 3.0 / 16.0 * ConstexprSqrt(35.0) * kBand4;

// Radiance whose E/pi is the projection of a cube, of sums and differences of opposite faces.
inline constexpr double kRootPi = ConstexprSqrt(kPi);
inline constexpr double kBand0Sum = kRootPi / 3.0 / evaluate::CosineBand(0);
inline constexpr double kBand1Difference =
    ConstexprSqrt(3.0) / 4.0 * kRootPi / evaluate::CosineBand(1);
inline constexpr double kBand2Along = ConstexprSqrt(5.0) / 15.0 * kRootPi / evaluate::CosineBand(2);
inline constexpr double kBand2Across =
    ConstexprSqrt(15.0) / 15.0 * kRootPi / evaluate::CosineBand(2);

}  // namespace gaunt::ambient_cube

#endif  // GAUNT_AMBIENT_CUBE_CONSTANTS_H_
