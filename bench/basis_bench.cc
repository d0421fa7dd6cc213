// SPDX-License-Identifier: MIT
#include "basis/basis.h"
#include "bench/basis_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {
namespace {

BatchBenchmark BasisBenchmark(const std::string& op, uint32_t n, const std::string& variant) {
  BatchBenchmark batch;
  batch.name = "basis/" + op + "/n" + std::to_string(n);
  batch.operations = OperationsOf("basis", std::to_string(n), variant);
  batch.inputs = {3};
  batch.outputs = {n * n};
  batch.make = MakeDirection;
  return batch;
}

void RegisterBaseline(size_t n, const std::string& baseline,
                      void (*loop)(size_t count, const float* directions, float* out)) {
  ScalarBenchmark scalar;
  scalar.name = "basis/eval/n" + std::to_string(n);
  scalar.baseline = baseline;
  scalar.inputs = {3};
  scalar.output = n * n;
  scalar.make = MakeDirection;
  scalar.call = [loop](size_t count, const std::vector<const float*>& in, float* out) {
    loop(count, in[0], out);
  };
  RegisterScalar(scalar);
}

simd::InView In(const gaunt_view& v) {
  return {reinterpret_cast<const unsigned char*>(v.data), v.item_stride, v.plane_stride,
          v.tile_stride, v.tile_items};
}
simd::OutView Out(const gaunt_view& v) {
  return {reinterpret_cast<unsigned char*>(v.data), v.item_stride, v.plane_stride, v.tile_stride,
          v.tile_items};
}

}  // namespace

GAUNT_BENCHMARKS(basis) {
  for (const uint32_t n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 16, 32, 64}) {
    const bool unrolled = n <= basis::kMaxUnrolled;
    BatchBenchmark batch = BasisBenchmark("eval", n, unrolled ? "unrolled" : "bands");
    batch.call = [n](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_basis_eval(n, count, in[0], out[0]);
    };
    batch.large = n == 3 || n == 6 || n == 10;
    RegisterBatch(batch);
  }
  // The loop over bands at orders that are unrolled, for comparison.
  for (const uint32_t n : {3, 6, 8, 10}) {
    BatchBenchmark batch = BasisBenchmark("eval_bands", n, "bands");
    batch.call = [n](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      basis::Kernels().eval_any(static_cast<int>(n), count, In(*in[0]), Out(*out[0]));
      return GAUNT_OK;
    };
    RegisterBatch(batch);
  }
  for (const uint32_t n : {3, 6, 10}) {
    const bool unrolled = n <= basis::kMaxUnrolledGradient;
    BatchBenchmark batch = BasisBenchmark("gradient", n, "bands");
    batch.operations =
        OperationsOf("basis_gradient", std::to_string(n), unrolled ? "unrolled" : "bands");
    batch.outputs = {n * n, n * n, n * n};
    batch.call = [n](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_basis_gradient(n, count, in[0], out[0], out[1], out[2]);
    };
    RegisterBatch(batch);
  }
  RegisterBaseline(3, "factored", BasisFactored3);
  RegisterBaseline(6, "factored", BasisFactored6);
  RegisterBaseline(3, "engine", BasisEngine3);
  RegisterBaseline(6, "engine", BasisEngine6);

  BatchBenchmark normalize;
  normalize.name = "basis/directions_normalize/n1";
  normalize.operations = OperationsOf("directions_normalize", "-", "-");
  normalize.inputs = {3};
  normalize.outputs = {3};
  normalize.make = MakeDirection;
  normalize.call = [](size_t count, const BatchBenchmark::Views& in,
                      const BatchBenchmark::Views& out) {
    return gaunt_directions_normalize(count, in[0], out[0]);
  };
  RegisterBatch(normalize);
}

}  // namespace gaunt::bench
