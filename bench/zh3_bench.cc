// SPDX-License-Identifier: MIT
#include "bench/support.h"
#include "bench/zh3_baseline.h"
#include "zh3/zh3_reference.h"

namespace gaunt::bench {
namespace {

using Views = BatchBenchmark::Views;
using Call = std::function<gaunt_status(size_t count, const Views& in, const Views& out)>;
using Scalar = std::function<void(size_t count, const std::vector<const float*>& in, float* out)>;

// Light with a direction: order 2 or 3 by the number of planes, k2, or a normal.
void Make(size_t planes, size_t item, size_t side, float* out) {
  if (planes < 12) return MakeDirection(item, side, out);
  MakeNoise(item, side, planes, out);
  for (size_t p = 0; p < planes; p += planes / 3) out[p] = 1.0f + 0.5f * out[p];
}

struct Job {
  std::string op;  // "irradiance/n3"
  std::string counted, order, variant;
  std::vector<size_t> inputs, outputs;
  Call call;
  std::vector<size_t> broadcast = {};
  Scalar scalar = nullptr;
  Reference reference = nullptr;
  std::string label = "";  // of the job
};

void Register(const Job& job) {
  const auto make = [inputs = job.inputs](size_t item, size_t side, float* out) {
    Make(inputs[side], item, side, out);
  };
  BatchBenchmark batch;
  batch.name = "zh3/" + job.op;
  batch.operations = OperationsOf(job.counted, job.order, job.variant);
  batch.inputs = job.inputs;
  batch.outputs = job.outputs;
  batch.call = job.call;
  batch.make = make;
  batch.broadcast = job.broadcast;
  batch.reference = job.reference;
  if (!job.label.empty()) batch.label = job.label + ": kernel";
  RegisterBatch(batch);
  if (job.scalar == nullptr) return;
  ScalarBenchmark scalar;
  scalar.name = batch.name;
  scalar.baseline = "engine";
  scalar.inputs = job.inputs;
  scalar.output = job.outputs[0];
  scalar.call = job.scalar;
  scalar.make = make;
  scalar.reference = job.reference;
  if (!job.label.empty()) scalar.label = job.label + ": scalar loop";
  RegisterScalar(scalar);
}

void RegisterMode(uint32_t mode) {
  const bool shared = mode == GAUNT_ZH3_AXIS_LUMINANCE;
  const std::string variant = shared ? "luminance" : "channel";
  const auto name = [&](const std::string& op, const std::string& order) {
    return op + "_" + variant + "/" + order;
  };
  const auto scalar = [&](const Scalar& loop) { return shared ? loop : nullptr; };
  Register({name("solve", "n3"),
            "zh3_solve",
            "3",
            variant,
            {27},
            {3},
            [=](size_t count, const Views& in, const Views& out) {
              return gaunt_zh3_solve(mode, count, in[0], out[0], nullptr);
            },
            {},
            scalar([](size_t count, const std::vector<const float*>& in, float* out) {
              Zh3EngineSolve(count, in[0], out);
            })});
  Register({name("refit", "n3"),
            "zh3_refit",
            "3",
            variant,
            {27},
            {12, 3},
            [=](size_t count, const Views& in, const Views& out) {
              return gaunt_zh3_refit(mode, count, in[0], out[0], out[1]);
            }});
  Register({name("hallucinate", "n2"),
            "zh3_hallucinate",
            "2",
            variant,
            {12},
            {3},
            [=](size_t count, const Views& in, const Views& out) {
              return gaunt_zh3_hallucinate(GAUNT_ZH3_MODEL_CURVE, mode, count, in[0], out[0]);
            },
            {},
            scalar([](size_t count, const std::vector<const float*>& in, float* out) {
              Zh3EngineHallucinate(count, in[0], out);
            })});
  Register({name("expand", "n3"),
            "zh3_expand",
            "3",
            variant,
            {12, 3},
            {27},
            [=](size_t count, const Views& in, const Views& out) {
              return gaunt_zh3_expand(mode, count, in[0], in[1], out[0]);
            }});
  const Call irradiance = [=](size_t count, const Views& in, const Views& out) {
    return gaunt_zh3_irradiance(mode, count, in[0], in[1], in[2], out[0]);
  };
  const Reference reference = [=](const std::vector<const double*>& in, double* out) {
    zh3::IrradianceReference(shared, in[0], in[1], in[2], out);
  };
  Register({name("irradiance", "n3"),
            "zh3_irradiance",
            "3",
            variant,
            {12, 3, 3},
            {3},
            irradiance,
            {},
            scalar([](size_t count, const std::vector<const float*>& in, float* out) {
              Zh3EngineIrradiance(count, in[0], in[1], in[2], out);
            }),
            reference,
            shared ? "irradiance of ZH3" : ""});
  Register({name("irradiance_one_probe", "n3"),
            "zh3_irradiance_one_probe",
            "3",
            variant,
            {12, 3, 3},
            {3},
            irradiance,
            {0, 1}});
}

}  // namespace

GAUNT_BENCHMARKS(zh3) {
  RegisterMode(GAUNT_ZH3_AXIS_LUMINANCE);
  RegisterMode(GAUNT_ZH3_AXIS_CHANNEL);
  const Call geomerics = [](size_t count, const Views& in, const Views& out) {
    return gaunt_geomerics_irradiance(count, in[0], in[1], out[0]);
  };
  const Reference reference = [](const std::vector<const double*>& in, double* out) {
    zh3::GeomericsReference(in[0], in[1], out);
  };
  Register({"geomerics/n2",
            "geomerics_irradiance",
            "2",
            "rgb",
            {12, 3},
            {3},
            geomerics,
            {},
            [](size_t count, const std::vector<const float*>& in, float* out) {
              GeomericsEngine(count, in[0], in[1], out);
            },
            reference,
            "irradiance of Geomerics' lobe"});
  Register({"geomerics_one_probe/n2",
            "geomerics_irradiance_one_probe",
            "2",
            "rgb",
            {12, 3},
            {3},
            geomerics,
            {0}});
}

}  // namespace gaunt::bench
