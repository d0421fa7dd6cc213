// SPDX-License-Identifier: MIT
// The SH basis by its definition, in double precision.
#ifndef GAUNT_BASIS_BASIS_REFERENCE_H_
#define GAUNT_BASIS_BASIS_REFERENCE_H_

namespace gaunt::basis {

// y_lm(direction / |direction|) for all l < order.
void EvalReference(int order, const double direction[3], double* y);

// Gradient of y_lm(v / |v|) with respect to v at a unit vector, component-major: 3 * order^2 values.
void GradientReference(int order, const double direction[3], double* gradient);

}  // namespace gaunt::basis

#endif  // GAUNT_BASIS_BASIS_REFERENCE_H_
