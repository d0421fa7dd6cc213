// SPDX-License-Identifier: MIT
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(rotate) {
  for (const uint32_t channels : {1u, 3u}) {
    const std::string variant = channels == 1 ? "mono" : "rgb";
    BatchBenchmark batch;
    batch.name = "rotate/quaternion_" + variant + "/n3";
    batch.operations = OperationsOf("rotate", "3", variant);
    batch.inputs = {4, channels * 9};
    batch.outputs = {channels * 9};
    batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_rotate(3, channels, count, in[0], in[1], out[0]);
    };
    RegisterBatch(batch);
    batch.name = "rotate/matrix_" + variant + "/n3";
    batch.operations = OperationsOf("rotate_matrix", "3", variant);
    batch.inputs = {9, channels * 9};
    batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                     const BatchBenchmark::Views& out) {
      return gaunt_rotate_matrix(3, channels, count, in[0], in[1], out[0]);
    };
    RegisterBatch(batch);
  }
}

}  // namespace gaunt::bench
