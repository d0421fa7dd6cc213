// SPDX-License-Identifier: MIT
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(light) {
  BatchBenchmark batch;
  batch.name = "light/direction/n3";
  batch.operations = OperationsOf("light_direction", "3", "rgb");
  batch.inputs = {27};
  batch.outputs = {3};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_light_direction(3, 3, count, in[0], nullptr, out[0]);
  };
  RegisterBatch(batch);
  batch.name = "light/extract/n3";
  batch.operations = OperationsOf("light_extract", "3", "rgb_irradiance");
  batch.inputs = {27, 3};
  batch.outputs = {3, 3};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_light_extract(3, 3, 1, GAUNT_SENSE_IRRADIANCE, count, in[0], in[1], out[0],
                               out[1]);
  };
  RegisterBatch(batch);
}

}  // namespace gaunt::bench
