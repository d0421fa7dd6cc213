// SPDX-License-Identifier: MIT
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(evaluate) {
  const auto make = [](size_t item, size_t side, float* planes) {
    if (side == 1) return MakeDirection(item, side, planes);
    for (size_t p = 0; p < 27; ++p) {
      planes[p] = static_cast<float>((item * 7 + p * 13) % 29) / 29.0f;
    }
  };
  BatchBenchmark batch;
  batch.name = "evaluate/irradiance/n3";
  batch.operations = OperationsOf("irradiance_evaluate", "3", "rgb");
  batch.inputs = {27, 3};
  batch.outputs = {3};
  batch.make = make;
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_irradiance_evaluate(3, 3, count, in[0], in[1], out[0]);
  };
  RegisterBatch(batch);

  batch.name = "evaluate/sh/n3";
  batch.operations = OperationsOf("sh_evaluate", "3", "rgb");
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_sh_evaluate(3, 3, count, in[0], in[1], out[0]);
  };
  RegisterBatch(batch);

  batch = {};
  batch.name = "evaluate/constants/n3";
  batch.operations = OperationsOf("irradiance_constants", "3", "rgb");
  batch.inputs = {27};
  batch.outputs = {28};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_irradiance_constants(3, count, in[0], out[0]);
  };
  RegisterBatch(batch);

  batch.name = "evaluate/blend/n3";
  batch.operations = OperationsOf("sh_blend", "3", "rgb");
  batch.inputs = {27, 27, 1};
  batch.outputs = {27};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_sh_blend(3, 3, count, in[0], in[1], in[2], out[0]);
  };
  RegisterBatch(batch);
}

}  // namespace gaunt::bench
