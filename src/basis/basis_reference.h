// SPDX-License-Identifier: MIT
// The SH basis by its definition, in double precision.
#ifndef GAUNT_BASIS_BASIS_REFERENCE_H_
#define GAUNT_BASIS_BASIS_REFERENCE_H_

namespace gaunt::basis {

// y_lm(direction / |direction|) for all l < order.
void EvalReference(int order, const double direction[3], double* y);

}  // namespace gaunt::basis

#endif  // GAUNT_BASIS_BASIS_REFERENCE_H_
