// SPDX-License-Identifier: MIT
// Rotation of SH functions by its definition, in double precision.
#ifndef GAUNT_ROTATE_ROTATE_REFERENCE_H_
#define GAUNT_ROTATE_ROTATE_REFERENCE_H_

#include <cstddef>
#include <vector>

namespace gaunt::rotate {

// Nodes and weights of Gauss-Legendre quadrature, appended.
void GaussLegendre(int n, std::vector<double>* nodes, std::vector<double>* weights);

// Row-major matrix of a quaternion x y z w; of a zero quaternion, the identity.
void MatrixReference(const double quaternion[4], double matrix[9]);

// Coefficients of f'(s) = f(R^-1 s), R orthogonal, of channels one after the other.
void RotateReference(int order, size_t channels, const double matrix[9], const double* in,
                     double* out);

}  // namespace gaunt::rotate

#endif  // GAUNT_ROTATE_ROTATE_REFERENCE_H_
