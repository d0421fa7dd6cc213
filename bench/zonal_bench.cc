// SPDX-License-Identifier: MIT
#include "bench/support.h"
#include "bench/zonal_baseline.h"
#include "zonal/zonal_reference.h"

namespace gaunt::bench {
namespace {

void MakeFactors(size_t item, size_t planes, float* out) {
  for (size_t p = 0; p < planes; ++p) out[p] = static_cast<float>((item * 7 + p * 13) % 29) / 29.0f;
}

std::string Variant(uint32_t channels) { return channels == 1 ? "mono" : "rgb"; }

// `counted` is the row of operations.
BatchBenchmark RotateBenchmark(const std::string& op, const std::string& counted, uint32_t n,
                               uint32_t channels) {
  BatchBenchmark batch;
  batch.name = "zonal/" + op + "_" + Variant(channels) + "/n" + std::to_string(n);
  batch.operations = OperationsOf(counted, std::to_string(n), Variant(channels));
  batch.inputs = {size_t{channels} * n, 3};
  batch.outputs = {size_t{channels} * n * n};
  batch.make = [=](size_t item, size_t side, float* out) {
    if (side == 1) return MakeDirection(item, side, out);
    MakeFactors(item, channels * n, out);
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_zonal_rotate(n, channels, count, in[0], in[1], out[0]);
  };
  if (channels == 1) {  // what is charted
    batch.reference = [n](const std::vector<const double*>& in, double* out) {
      zonal::RotateReference(static_cast<int>(n), in[0], in[1], out);
    };
    batch.label = "each to its direction: kernel";
  }
  return batch;
}

void RegisterRotate(uint32_t n, uint32_t channels) {
  const BatchBenchmark rotate = RotateBenchmark("rotate", "zonal_rotate", n, channels);
  RegisterBatch(rotate);
  BatchBenchmark add = RotateBenchmark("rotate_add", "zonal_rotate_add", n, channels);
  add.reads_output = true;
  add.reference = nullptr;
  add.label.clear();
  add.call = [=](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views& out) {
    return gaunt_zonal_rotate_add(n, channels, count, in[0], in[1], out[0]);
  };
  RegisterBatch(add);
  if (n > 6) return;
  ScalarBenchmark engine;
  engine.name = rotate.name;
  engine.baseline = "engine";
  engine.inputs = rotate.inputs;
  engine.output = rotate.outputs[0];
  engine.call = [=](size_t count, const std::vector<const float*>& in, float* out) {
    ZonalEngine(static_cast<int>(n), static_cast<int>(channels), count, in[0], in[1], out);
  };
  engine.make = rotate.make;
  engine.reference = rotate.reference;
  if (channels == 1) engine.label = "each to its direction: scalar basis times bands";
  RegisterScalar(engine);
}

void RegisterOneForAll(uint32_t n) {
  BatchBenchmark batch = RotateBenchmark("rotate_one_zonal", "zonal_rotate", n, 3);
  batch.broadcast = {0};
  RegisterBatch(batch);
  batch = RotateBenchmark("rotate_one_direction", "zonal_one_direction", n, 3);
  batch.broadcast = {1};
  RegisterBatch(batch);
}

void RegisterConvolve(uint32_t n, bool one_kernel) {
  const std::string op = one_kernel ? "convolve_one_kernel" : "convolve";
  BatchBenchmark batch;
  batch.name = "zonal/" + op + "_rgb/n" + std::to_string(n);
  batch.operations =
      OperationsOf(one_kernel ? "zonal_one_kernel" : "zonal_convolve", std::to_string(n), "rgb");
  batch.inputs = {n, size_t{3} * n * n};
  batch.outputs = {size_t{3} * n * n};
  if (one_kernel) batch.broadcast = {0};
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_zonal_convolve(n, 3, count, in[0], in[1], out[0]);
  };
  RegisterBatch(batch);
}

}  // namespace

GAUNT_BENCHMARKS(zonal) {
  for (const uint32_t n : {2u, 3u, 4u, 5u, 6u, 7u, 8u, 10u}) {
    for (const uint32_t channels : {1u, 3u}) RegisterRotate(n, channels);
  }
  for (const uint32_t n : {3u, 6u}) {
    RegisterOneForAll(n);
    RegisterConvolve(n, false);
    RegisterConvolve(n, true);
  }
  RegisterConvolve(10, false);
}

}  // namespace gaunt::bench
