// SPDX-License-Identifier: MIT
#include "bench/product_axial_bench.h"

#include <cmath>
#include <string>
#include <vector>

#include "bench/product_axial_baseline.h"
#include "bench/support.h"
#include "product/product_reference.h"
#include "rotate/rotate_reference.h"
#include "zonal/zonal_reference.h"

namespace gaunt::bench {
namespace {

using Doubles = std::vector<double>;
using ItemInputs = std::vector<const double*>;

constexpr uint32_t kBaselineOrder = 6;

std::string NameOf(const std::string& op, uint32_t n) {
  return "product/" + op + "_mono/n" + std::to_string(n);
}

void RegisterBaseline(const BatchBenchmark& batch, const std::string& job,
                      void (*loop)(size_t count, const std::vector<const float*>& in, float* out)) {
  ScalarBenchmark scalar;
  scalar.name = batch.name;
  scalar.baseline = "sparse";
  scalar.inputs = batch.inputs;
  scalar.output = batch.outputs[0];
  scalar.call = loop;
  scalar.make = batch.make;
  scalar.reference = batch.reference;
  scalar.label = job + ": scalar loop over the non-zeros";
  RegisterScalar(scalar);
}

// The axes are the last input.
BatchBenchmark AxialBenchmark(const std::string& op, const std::string& job, uint32_t n,
                              const std::vector<size_t>& inputs) {
  BatchBenchmark batch;
  batch.name = NameOf(op, n);
  batch.operations = OperationsOf("product_" + op, std::to_string(n), "mono");
  batch.inputs = inputs;
  batch.outputs = {size_t{n} * n};
  batch.label = job + ": kernel";
  return batch;
}

BatchBenchmark WithAxes(BatchBenchmark batch) {
  const size_t side = batch.inputs.size();
  const std::vector<size_t> planes = batch.inputs;
  batch.inputs.push_back(3);
  batch.make = [=](size_t item, size_t s, float* out) {
    if (s == side) return MakeDirection(item, s, out);
    MakeNoise(item, s, planes[s], out);
  };
  return batch;
}

void RegisterZonal(uint32_t n) {
  const int order = static_cast<int>(n);
  BatchBenchmark batch = AxialBenchmark("zonal", "zonal", n, {n, size_t{n} * n});
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_product_zonal(n, n, n, 1, count, in[0], in[1], out[0]);
  };
  batch.reference = [=](const ItemInputs& in, double* out) {
    Doubles zonal(n * n);
    for (uint32_t l = 0; l < n; ++l) zonal[l * (l + 1)] = in[0][l];
    product::ProductReference(order, order, order, zonal.data(), in[1], out);
  };
  RegisterBatch(batch);
  if (n != kBaselineOrder) return;
  RegisterBaseline(batch, "zonal",
                   [](size_t count, const std::vector<const float*>& in, float* out) {
                     ZonalSparse(count, in[0], in[1], out);
                   });
}

void RegisterZonalAxis(uint32_t n) {
  const int order = static_cast<int>(n);
  BatchBenchmark batch =
      WithAxes(AxialBenchmark("zonal_axis", "zonal about axes", n, {n, size_t{n} * n}));
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_product_zonal_axis(n, n, n, 1, count, in[0], in[2], in[1], out[0]);
  };
  batch.reference = [=](const ItemInputs& in, double* out) {
    Doubles turned(n * n);
    zonal::RotateReference(order, in[0], in[2], turned.data());
    product::ProductReference(order, order, order, turned.data(), in[1], out);
  };
  RegisterBatch(batch);
}

// The hemisphere or the cosine.
struct Fixed {
  std::string name;
  decltype(&gaunt_product_hemisphere) function;
  decltype(&gaunt_product_hemisphere_axis) axis_function;
  void (*reference)(int order, const double* in, double* out);
};

// Turns the axis to z, multiplies, and turns back.
void FixedAxisReference(const Fixed& fixed, int order, const double* axis, const double* in,
                        double* out) {
  const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
  const double upward[4] = {-y, x, 0.0, 1.0 + z}, downward[4] = {y, -x, 0.0, 1.0 + z};
  double to_axis[9], to_z[9];
  rotate::MatrixReference(upward, to_axis);
  rotate::MatrixReference(downward, to_z);
  Doubles turned(static_cast<size_t>(order * order)), product = turned;
  rotate::RotateReference(order, 1, to_z, in, turned.data());
  fixed.reference(order, turned.data(), product.data());
  rotate::RotateReference(order, 1, to_axis, product.data(), out);
}

void RegisterFixed(const Fixed& fixed, uint32_t n) {
  const int order = static_cast<int>(n);
  BatchBenchmark batch = AxialBenchmark(fixed.name, fixed.name, n, {size_t{n} * n});
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return fixed.function(n, 1, count, in[0], out[0]);
  };
  batch.reference = [=](const ItemInputs& in, double* out) { fixed.reference(order, in[0], out); };
  RegisterBatch(batch);
  if (n == kBaselineOrder && fixed.function == &gaunt_product_hemisphere) {
    RegisterBaseline(batch, fixed.name,
                     [](size_t count, const std::vector<const float*>& in, float* out) {
                       HemisphereSparse(count, in[0], out);
                     });
  }
  BatchBenchmark about = WithAxes(
      AxialBenchmark(fixed.name + "_axis", fixed.name + " about axes", n, {size_t{n} * n}));
  about.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return fixed.axis_function(n, 1, count, in[1], in[0], out[0]);
  };
  about.reference = [=](const ItemInputs& in, double* out) {
    FixedAxisReference(fixed, order, in[1], in[0], out);
  };
  RegisterBatch(about);
}

}  // namespace

void RegisterAxialProducts() {
  for (const uint32_t n : {3u, 4u, 6u, 8u}) RegisterZonal(n);
  for (const uint32_t n : {3u, 6u}) {
    RegisterZonalAxis(n);
    RegisterFixed({"hemisphere", gaunt_product_hemisphere, gaunt_product_hemisphere_axis,
                   product::HemisphereReference},
                  n);
    RegisterFixed(
        {"cosine", gaunt_product_cosine, gaunt_product_cosine_axis, product::CosineReference}, n);
  }
}

}  // namespace gaunt::bench
