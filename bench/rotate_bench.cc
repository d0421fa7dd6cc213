// SPDX-License-Identifier: MIT
#include <cmath>

#include "bench/rotate_drift.h"
#include "bench/support.h"
#include "rotate/rotate_reference.h"

namespace gaunt::bench {
namespace {

// Rotations that differ from item to item, and coefficients in [-1, 1].
void MakeRotation(size_t item, double* quaternion) {
  for (int k = 0; k < 4; ++k) quaternion[k] = std::sin((1.3 + k) * static_cast<double>(item + 1));
}
void MakeCoefficients(size_t item, size_t planes, float* out) {
  for (size_t p = 0; p < planes; ++p) {
    out[p] = static_cast<float>(std::sin(static_cast<double>((item + 1) * (7 * p + 1))));
  }
}

void RegisterRotate(uint32_t n, uint32_t channels) {
  const bool mono = channels == 1;
  const std::string variant = mono ? "mono" : "rgb", order = std::to_string(n);
  const size_t planes = channels * n * n;
  const auto rotate_reference = [=](const double* matrix, const double* in, double* out) {
    for (size_t at = 0; at < planes; at += n * n) {
      rotate::RotateReference(static_cast<int>(n), matrix, in + at, out + at);
    }
  };

  BatchBenchmark batch;
  batch.name = "rotate/quaternion_" + variant + "/n" + order;
  batch.operations = OperationsOf("rotate", order, variant);
  batch.inputs = {4, planes};
  batch.outputs = {planes};
  batch.make = [=](size_t item, size_t side, float* out) {
    if (side == 1) return MakeCoefficients(item, planes, out);
    double quaternion[4];
    MakeRotation(item, quaternion);
    for (int k = 0; k < 4; ++k) out[k] = static_cast<float>(quaternion[k]);
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_rotate(n, channels, count, in[0], in[1], out[0]);
  };
  batch.reference = [=](const std::vector<const double*>& in, double* out) {
    double matrix[9];
    rotate::MatrixReference(in[0], matrix);
    rotate_reference(matrix, in[1], out);
  };
  if (mono) batch.label = "quaternion for each";
  RegisterBatch(batch);

  batch.name = "rotate/matrix_" + variant + "/n" + order;
  batch.operations = OperationsOf("rotate_matrix", order, variant);
  batch.inputs = {9, planes};
  batch.make = [=](size_t item, size_t side, float* out) {
    if (side == 1) return MakeCoefficients(item, planes, out);
    double quaternion[4], matrix[9];
    MakeRotation(item, quaternion);
    rotate::MatrixReference(quaternion, matrix);
    for (int k = 0; k < 9; ++k) out[k] = static_cast<float>(matrix[k]);
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_rotate_matrix(n, channels, count, in[0], in[1], out[0]);
  };
  batch.reference = [=](const std::vector<const double*>& in, double* out) {
    rotate_reference(in[0], in[1], out);
  };
  if (mono) batch.label = "matrix for each";
  RegisterBatch(batch);
}

}  // namespace

GAUNT_BENCHMARKS(rotate) {
  for (const uint32_t channels : {1u, 3u}) RegisterRotate(3, channels);
  RegisterRotateDrift();
}

}  // namespace gaunt::bench
