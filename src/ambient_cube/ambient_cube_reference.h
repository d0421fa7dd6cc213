// SPDX-License-Identifier: MIT
// The ambient cube by its definition, in double precision and for one channel. Faces +X, -X, +Y,
// -Y, +Z, -Z.
#ifndef GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_REFERENCE_H_
#define GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_REFERENCE_H_

#include <functional>

namespace gaunt::ambient_cube {

// Integral over the sphere of a function that is smooth in each octant.
double IntegralReference(const std::function<double(const double direction[3])>& function);

// Value of a cube at a direction, which is normalised.
double EvaluateReference(const double cube[6], const double direction[3]);

// The cube closest over the sphere to E/pi of radiance, and its values at the axes.
void ClosestReference(int order, const double* radiance, double cube[6]);
void SampledReference(int order, const double* radiance, double cube[6]);

// Radiance whose E/pi is the projection of the cube, 0 in the bands that E does not have.
void ToShReference(int order, const double cube[6], double* radiance);

}  // namespace gaunt::ambient_cube

#endif  // GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_REFERENCE_H_
