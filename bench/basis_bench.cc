// SPDX-License-Identifier: MIT
#include "bench/basis_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(basis) {
  for (uint32_t n = 1; n <= GAUNT_MAX_ORDER; ++n) {
    BatchBenchmark batch;
    batch.name = "basis/eval/n" + std::to_string(n);
    batch.operations = OperationsOf("basis", std::to_string(n), "unrolled");
    batch.inputs = {3};
    batch.outputs = {n * n};
    batch.call = [n](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_basis_eval(n, count, in[0], out[0]);
    };
    batch.make = MakeDirection;
    batch.large = n == 3 || n == 6;
    RegisterBatch(batch);
  }
  RegisterScalar({"basis/eval/n3", "factored", 3, 9, BasisFactored3, MakeDirection});
  RegisterScalar({"basis/eval/n6", "factored", 3, 36, BasisFactored6, MakeDirection});
  RegisterScalar({"basis/eval/n3", "engine", 3, 9, BasisEngine3, MakeDirection});
  RegisterScalar({"basis/eval/n6", "engine", 3, 36, BasisEngine6, MakeDirection});
}

}  // namespace gaunt::bench
