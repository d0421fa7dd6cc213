// SPDX-License-Identifier: MIT
#include "bench/product_axial_bench.h"
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(product) {
  for (const uint32_t n : {2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u}) {
    const size_t planes = n * n;
    BatchBenchmark batch;
    batch.name = "product/product_mono/n" + std::to_string(n);
    batch.operations = OperationsOf("product", std::to_string(n), "fast");
    batch.inputs = {planes, planes};
    batch.outputs = {planes};
    batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_product(n, n, n, 1, count, in[0], in[1], out[0]);
    };
    RegisterBatch(batch);
  }
  RegisterAxialProducts();
}

}  // namespace gaunt::bench
