// SPDX-License-Identifier: MIT
// ZH3 and Geomerics' lobe by their definitions, in double precision. RGB: sh3 27 numbers, sh2 12,
// k2 3, axis 3 (shared) or 9.
#ifndef GAUNT_ZH3_ZH3_REFERENCE_H_
#define GAUNT_ZH3_ZH3_REFERENCE_H_

#include <cstddef>

namespace gaunt::zh3 {

// Axes of bands 1 of channels `stride` numbers apart; zero where there is none. Null weights:
// luminance.
void AxisReference(bool shared, size_t stride, const double* weights, const double* in,
                   double* axis);

void SolveReference(bool shared, const double* sh3, double* k2, double* axis);

void HallucinateReference(bool shared, double linear, double quadratic, const double* weights,
                          const double* sh2, double* k2);

void ExpandReference(bool shared, const double* sh2, const double* k2, double* sh3);

// E/pi.
void IrradianceReference(bool shared, const double* sh2, const double* k2, const double* normal,
                         double* out);
void GeomericsReference(const double* sh2, const double* normal, double* out);

// The integral over the sphere of the squared error of E/pi, over all channels.
double ErrorReference(bool shared, const double* sh3, const double* sh2, const double* k2);

// Order 2 and k2 of the least error, by trying axes all over the sphere. Returns the error.
double RefitReference(bool shared, const double* sh3, double* sh2, double* k2);

// The curve closest to `count` probes, 27 numbers each, all of which can be used.
void FitCurveReference(bool shared, size_t count, const double* sh3, double* linear,
                       double* quadratic);

}  // namespace gaunt::zh3

#endif  // GAUNT_ZH3_ZH3_REFERENCE_H_
