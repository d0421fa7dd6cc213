// SPDX-License-Identifier: MIT
#include "bench/evaluate_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {
namespace {

using EvaluateFunction = gaunt_status (*)(uint32_t, uint32_t, size_t, const gaunt_view*,
                                          const gaunt_view*, const gaunt_view*);

// RGB functions and directions, as many of either or one of them for all.
void RegisterEvaluate(const std::string& op, EvaluateFunction function, uint32_t n,
                      const Operations& operations, const std::vector<size_t>& broadcast) {
  const size_t planes = 3 * n * n;
  BatchBenchmark batch;
  batch.name = "evaluate/" + op + "/n" + std::to_string(n);
  batch.operations = operations;
  batch.inputs = {planes, 3};
  batch.outputs = {3};
  batch.broadcast = broadcast;
  batch.make = [=](size_t item, size_t side, float* out) {
    if (side == 1) return MakeDirection(item, side, out);
    for (size_t p = 0; p < planes; ++p)
      out[p] = static_cast<float>((item * 7 + p * 13) % 29) / 29.0f;
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return function(n, 3, count, in[0], in[1], out[0]);
  };
  RegisterBatch(batch);
}

void RegisterIrradianceBaselines() {
  ScalarBenchmark scalar;
  scalar.name = "evaluate/irradiance_one_probe/n3";
  scalar.baseline = "engine";
  scalar.inputs = {3};
  scalar.output = 3;
  scalar.make = MakeDirection;
  scalar.call = [](size_t count, const std::vector<const float*>& in, float* out) {
    IrradianceEngineOneProbe(count, in[0], out);
  };
  RegisterScalar(scalar);
}

}  // namespace

GAUNT_BENCHMARKS(evaluate) {
  for (const uint32_t n : {3, 5, 6, 10}) {
    RegisterEvaluate("irradiance", gaunt_irradiance_evaluate, n,
                     OperationsOf("irradiance_evaluate", std::to_string(n), "rgb"), {});
    RegisterEvaluate("sh", gaunt_sh_evaluate, n,
                     OperationsOf("sh_evaluate", std::to_string(n), "rgb"), {});
  }
  RegisterEvaluate("irradiance_one_probe", gaunt_irradiance_evaluate, 3,
                   OperationsOf("evaluate_broadcast", "3", "rgb"), {0});
  RegisterEvaluate("irradiance_one_probe", gaunt_irradiance_evaluate, 5,
                   OperationsOf("irradiance_evaluate", "5", "rgb"), {0});
  RegisterIrradianceBaselines();

  BatchBenchmark batch;
  batch.name = "evaluate/constants/n3";
  batch.operations = OperationsOf("irradiance_constants", "3", "rgb");
  batch.inputs = {27};
  batch.outputs = {28};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_irradiance_constants(3, count, in[0], out[0]);
  };
  RegisterBatch(batch);

  batch.name = "evaluate/matrix/n3";
  batch.operations = OperationsOf("irradiance_matrix", "3", "rgb");
  batch.outputs = {48};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_irradiance_matrix(3, 3, count, in[0], out[0]);
  };
  RegisterBatch(batch);

  batch.name = "evaluate/dot/n3";
  batch.operations = OperationsOf("sh_dot", "3", "rgb");
  batch.inputs = {27, 27};
  batch.outputs = {3};
  batch.call = [](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_sh_dot(3, 3, count, in[0], in[1], out[0]);
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
