// SPDX-License-Identifier: MIT
// Zonal functions turned and convolved by definition, in double precision.
#ifndef GAUNT_ZONAL_ZONAL_REFERENCE_H_
#define GAUNT_ZONAL_ZONAL_REFERENCE_H_

namespace gaunt::zonal {

// sum over l < order of z_l y_l0 at an angle from +z whose cosine is given.
double ZonalReference(int order, const double* zonal, double cosine);

// Coefficients of f(s) = ZonalReference(s . direction), by quadrature over the sphere.
void RotateReference(int order, const double* zonal, const double direction[3], double* out);

// Coefficients of the integral over t of f(t) h(s . t), with the kernel h by its coefficients, by
// quadrature over s and t.
void ConvolveReference(int order, const double* kernel, const double* in, double* out);

}  // namespace gaunt::zonal

#endif  // GAUNT_ZONAL_ZONAL_REFERENCE_H_
