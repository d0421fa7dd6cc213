// SPDX-License-Identifier: MIT
// Sums of SH functions and their irradiance by definition, in double precision.
#ifndef GAUNT_EVALUATE_EVALUATE_REFERENCE_H_
#define GAUNT_EVALUATE_EVALUATE_REFERENCE_H_

namespace gaunt::evaluate {

// A_l / pi of the clamped cosine.
double CosineFactor(int l);

// sum of f_i y_i(direction).
double ShReference(int order, const double* coefficients, const double direction[3]);

// E/pi of radiance at a normal.
double IrradianceReference(int order, const double* radiance, const double normal[3]);

// The 7 float4 of an RGB radiance of order 3, channel-major.
void IrradianceConstantsReference(const double radiance[27], double out[28]);

// The 4x4 matrix of a channel's quadratic form.
void IrradianceMatrixReference(const double radiance[9], double out[16]);

}  // namespace gaunt::evaluate

#endif  // GAUNT_EVALUATE_EVALUATE_REFERENCE_H_
