// SPDX-License-Identifier: MIT
#ifndef GAUNT_BENCH_PRODUCT_AXIAL_BENCH_H_
#define GAUNT_BENCH_PRODUCT_AXIAL_BENCH_H_

namespace gaunt::bench {

// Products with functions about an axis, rows of the family product.
void RegisterAxialProducts();

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PRODUCT_AXIAL_BENCH_H_
