// SPDX-License-Identifier: MIT
// Errors of products of functions whose bands differ much in size.
#ifndef GAUNT_BENCH_PRODUCT_STABILITY_H_
#define GAUNT_BENCH_PRODUCT_STABILITY_H_

namespace gaunt::bench {

// product/stability/<method and measure>/<ratio of the first band to the last>
void RegisterProductStability();

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_PRODUCT_STABILITY_H_
