// SPDX-License-Identifier: MIT
// Products of SH functions by their definition, the integral over the sphere, in double precision.
#ifndef GAUNT_PRODUCT_PRODUCT_REFERENCE_H_
#define GAUNT_PRODUCT_PRODUCT_REFERENCE_H_

namespace gaunt::product {

// Coefficients of a(s) b(s), of any orders.
void ProductReference(int order_a, int order_b, int order_out, const double* a, const double* b,
                      double* out);

// Coefficients, of the same order, of in(s) where z > 0, else 0; and of in(s) max(z, 0).
void HemisphereReference(int order, const double* in, double* out);
void CosineReference(int order, const double* in, double* out);

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_PRODUCT_REFERENCE_H_
