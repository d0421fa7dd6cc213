// SPDX-License-Identifier: MIT
#include <string>

#include "ambient_cube/ambient_cube_reference.h"
#include "bench/ambient_cube_baseline.h"
#include "bench/support.h"

namespace gaunt::bench {
namespace {

using Views = BatchBenchmark::Views;
using Scalar = decltype(ScalarBenchmark::call);

constexpr size_t kPlanes = GAUNT_AMBIENT_CUBE_PLANES;

void Register(const BatchBenchmark& batch, const Scalar& loop = nullptr) {
  RegisterBatch(batch);
  if (loop == nullptr) return;
  ScalarBenchmark scalar;
  scalar.name = batch.name;
  scalar.baseline = "engine";
  scalar.inputs = batch.inputs;
  scalar.output = batch.outputs[0];
  scalar.broadcast = batch.broadcast;
  scalar.call = loop;
  scalar.make = batch.make;
  scalar.reference = batch.reference;
  RegisterScalar(scalar);
}

// By a function (order, channel's coefficients, faces) of the reference.
template <class Function>
Reference ToCubes(uint32_t n, const Function& function) {
  return [=](const std::vector<const double*>& in, double* out) {
    for (size_t c = 0; c < 3; ++c) {
      double faces[6];
      function(static_cast<int>(n), in[0] + c * n * n, faces);
      for (size_t face = 0; face < 6; ++face) out[3 * face + c] = faces[face];
    }
  };
}

// The faces of one channel after the other.
template <class Function>
void ForEachChannel(const double* cube, const Function& function) {
  for (size_t c = 0; c < 3; ++c) {
    double faces[6];
    for (size_t face = 0; face < 6; ++face) faces[face] = cube[3 * face + c];
    function(c, faces);
  }
}

void RegisterProject(uint32_t n, uint32_t mode) {
  const bool sampled = mode == GAUNT_AMBIENT_CUBE_SAMPLED;
  const std::string variant = sampled ? "sampled" : "least_squares", order = std::to_string(n);
  BatchBenchmark batch;
  batch.name = "ambient_cube/project_" + variant + "/n" + order;
  batch.operations = OperationsOf("ambient_cube_project", order, variant);
  batch.inputs = {3 * n * n};
  batch.outputs = {kPlanes};
  batch.call = [=](size_t count, const Views& in, const Views& out) {
    return gaunt_ambient_cube_project(n, mode, count, in[0], out[0]);
  };
  batch.reference = sampled ? ToCubes(n, &ambient_cube::SampledReference)
                            : ToCubes(n, &ambient_cube::ClosestReference);
  if (!sampled || n != 3) return Register(batch);
  Register(batch, [](size_t count, const std::vector<const float*>& in, float* out) {
    AmbientCubeEngineSample(count, in[0], out);
  });
}

void RegisterToSh(uint32_t n) {
  const std::string order = std::to_string(n);
  BatchBenchmark batch;
  batch.name = "ambient_cube/to_sh/n" + order;
  batch.operations = OperationsOf("ambient_cube_to_sh", order, "rgb");
  batch.inputs = {kPlanes};
  batch.outputs = {3 * n * n};
  batch.call = [=](size_t count, const Views& in, const Views& out) {
    return gaunt_ambient_cube_to_sh(n, count, in[0], out[0]);
  };
  batch.reference = [=](const std::vector<const double*>& in, double* out) {
    ForEachChannel(in[0], [&](size_t c, const double* faces) {
      ambient_cube::ToShReference(static_cast<int>(n), faces, out + c * n * n);
    });
  };
  if (n != 3) return Register(batch);
  Register(batch, [](size_t count, const std::vector<const float*>& in, float* out) {
    AmbientCubeEngineToSh(count, in[0], out);
  });
}

void RegisterEvaluate(bool one_cube) {
  BatchBenchmark batch;
  batch.name = one_cube ? "ambient_cube/evaluate_one_cube/n1" : "ambient_cube/evaluate/n1";
  batch.operations = OperationsOf("ambient_cube_evaluate", "-", "rgb");
  batch.inputs = {kPlanes, 3};
  batch.outputs = {3};
  batch.call = [](size_t count, const Views& in, const Views& out) {
    return gaunt_ambient_cube_evaluate(count, in[0], in[1], out[0]);
  };
  batch.make = [](size_t item, size_t side, float* out) {
    side == 0 ? MakeNoise(item, side, kPlanes, out) : MakeDirection(item, side, out);
  };
  batch.reference = [](const std::vector<const double*>& in, double* out) {
    ForEachChannel(in[0], [&](size_t c, const double* faces) {
      out[c] = ambient_cube::EvaluateReference(faces, in[1]);
    });
  };
  if (one_cube) batch.broadcast = {0};
  const auto loop = one_cube ? &AmbientCubeEngineEvaluateOne : &AmbientCubeEngineEvaluate;
  Register(batch, [=](size_t count, const std::vector<const float*>& in, float* out) {
    loop(count, in[0], in[1], out);
  });
}

}  // namespace

GAUNT_BENCHMARKS(ambient_cube) {
  for (const uint32_t n : {3u, 5u}) {
    for (const uint32_t mode : {GAUNT_AMBIENT_CUBE_LEAST_SQUARES, GAUNT_AMBIENT_CUBE_SAMPLED}) {
      RegisterProject(n, mode);
    }
  }
  RegisterToSh(3);
  RegisterEvaluate(false);
  RegisterEvaluate(true);
}

}  // namespace gaunt::bench
