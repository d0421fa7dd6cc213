// SPDX-License-Identifier: MIT
#include <cmath>

#include "bench/rotate_baseline.h"
#include "bench/rotate_drift.h"
#include "bench/support.h"
#include "rotate/rotate_reference.h"

namespace gaunt::bench {
namespace {

// Rotations that differ from item to item: half of them of any kind, a quarter within some 1e-2 and a
// quarter within some 1e-5 rad of a turn about z, where Euler angles fail.
void MakeQuaternion(size_t item, float* quaternion) {
  const double tilt = item % 4 == 1 ? 1e-3 : item % 4 == 3 ? 1e-6 : 1.0;
  for (int k = 0; k < 4; ++k) {
    const double x = std::sin((1.3 + k) * static_cast<double>(item + 1));
    quaternion[k] = static_cast<float>(k < 2 ? tilt * x : x);
  }
}

void MakeMatrix(size_t item, float* out) {
  float quaternion[4];
  MakeQuaternion(item, quaternion);
  const double exact[4] = {quaternion[0], quaternion[1], quaternion[2], quaternion[3]};
  double matrix[9];
  rotate::MatrixReference(exact, matrix);
  for (int k = 0; k < 9; ++k) out[k] = static_cast<float>(matrix[k]);
}

// In [-1, 1].
void MakeCoefficients(size_t item, size_t planes, float* out) {
  for (size_t p = 0; p < planes; ++p) {
    out[p] = static_cast<float>(std::sin(static_cast<double>((item + 1) * (7 * p + 1))));
  }
}

struct RotateCase {
  uint32_t n, channels;

  size_t planes() const { return channels * n * n; }
  std::string variant() const { return channels == 1 ? "mono" : "rgb"; }
  std::string order() const { return std::to_string(n); }

  Reference ByQuaternion() const {
    return [*this](const std::vector<const double*>& in, double* out) {
      double matrix[9];
      rotate::MatrixReference(in[0], matrix);
      rotate::RotateReference(static_cast<int>(n), channels, matrix, in[1], out);
    };
  }
  Reference ByMatrix() const {
    return [*this](const std::vector<const double*>& in, double* out) {
      rotate::RotateReference(static_cast<int>(n), channels, in[0], in[1], out);
    };
  }
  auto MakeInputs(bool matrices) const {
    return [*this, matrices](size_t item, size_t side, float* out) {
      if (side == 1) return MakeCoefficients(item, planes(), out);
      matrices ? MakeMatrix(item, out) : MakeQuaternion(item, out);
    };
  }
};

// One rotation for each item, or for all of them. Labels are of one channel only: these are charted.
void RegisterRotate(const RotateCase& rotate, const std::string& op, const std::string& counted,
                    bool matrices, bool one, const std::string& label) {
  BatchBenchmark batch;
  batch.name = "rotate/" + op + "_" + rotate.variant() + "/n" + rotate.order();
  batch.operations = OperationsOf(counted, rotate.order(), rotate.variant());
  batch.inputs = {matrices ? size_t{9} : size_t{4}, rotate.planes()};
  batch.outputs = {rotate.planes()};
  batch.make = rotate.MakeInputs(matrices);
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return (matrices ? gaunt_rotate_matrix : gaunt_rotate)(rotate.n, rotate.channels, count, in[0],
                                                           in[1], out[0]);
  };
  batch.reference = matrices ? rotate.ByMatrix() : rotate.ByQuaternion();
  if (one) batch.broadcast = {0};
  if (rotate.channels == 1) batch.label = label;
  batch.large = rotate.channels == 1 && (rotate.n == 3 || rotate.n == 6) && !matrices;
  RegisterBatch(batch);
}

void RegisterBaseline(const RotateCase& rotate, const std::string& op, const std::string& baseline,
                      RotateBaseline loop, const std::string& label) {
  ScalarBenchmark scalar;
  scalar.name = "rotate/" + op + "_mono/n" + rotate.order();
  scalar.baseline = baseline;
  scalar.inputs = {4, rotate.planes()};
  scalar.output = rotate.planes();
  scalar.call = [=](size_t count, const std::vector<const float*>& in, float* out) {
    loop(count, in[0], in[1], out);
  };
  if (op == "one") scalar.broadcast = {0};
  scalar.make = rotate.MakeInputs(false);
  scalar.reference = rotate.ByQuaternion();
  scalar.label = label;
  RegisterScalar(scalar);
}

}  // namespace

GAUNT_BENCHMARKS(rotate) {
  for (const uint32_t n : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16}) {
    for (const uint32_t channels : {1u, 3u}) {
      if (channels == 3 && n > 6) continue;
      const RotateCase rotate = {n, channels};
      RegisterRotate(rotate, "quaternion", "rotate", false, false, "one for each: quaternion");
      RegisterRotate(rotate, "matrix", "rotate_matrix", true, false, "one for each: matrix");
      RegisterRotate(rotate, "one", "rotate_broadcast", false, true, "one for all: plan");
    }
  }
  for (int n = kMinBaselineOrder; n <= kMaxBaselineOrder; ++n) {
    const RotateCase rotate = {static_cast<uint32_t>(n), 1};
    RegisterBaseline(rotate, "quaternion", "factored", Factored(n),
                     "one for each: scalar, as the kernels");
    RegisterBaseline(rotate, "quaternion", "zxzxz", Zxzxz(n), "one for each: scalar Z-X-Z-X-Z");
    RegisterBaseline(rotate, "quaternion", "blocks", Blocks(n),
                     "one for each: scalar block matrices");
    RegisterBaseline(rotate, "one", "blocks", BlocksOnce(n), "one for all: scalar block matrices");
  }
  RegisterRotateDrift();
}

}  // namespace gaunt::bench
