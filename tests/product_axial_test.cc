// SPDX-License-Identifier: MIT
// Products with functions that are symmetric about an axis.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "product/product_reference.h"
#include "rotate/rotate_reference.h"
#include "tests/product_items.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"
#include "zonal/zonal_reference.h"

namespace gaunt::test {
namespace {

// As gaunt.h states them: relative to the norm of the coefficients, and to that of the zonal
// function's.
double ZonalTolerance() { return 1.5e-7; }
double FixedTolerance() { return 1.2e-7; }
double AxisTolerance(uint32_t n) { return 3e-7 + 4e-8 * n * n; }

using Doubles = std::vector<double>;
using Reference = std::function<void(const double* in, double* out)>;

// A rotation that takes z to the axis: the shortest one, from -z where the axis is below.
void AxisRotation(const double axis[3], double matrix[9]) {
  const double length =
      std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
  const double upward[4] = {-y, x, 0.0, 1.0 + z};
  // A half turn about x, and then from -z.
  const double downward[4] = {1.0 - z, 0.0, x, -y};
  rotate::MatrixReference(z >= 0.0 ? upward : downward, matrix);
}

// Rotates the axis to z, multiplies about z, and rotates back.
void AboutAxis(uint32_t n, uint32_t n_out, const double axis[3], const Reference& about_z,
               const double* in, double* out) {
  double matrix[9], inverse[9];
  AxisRotation(axis, matrix);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) inverse[3 * row + column] = matrix[3 * column + row];
  }
  Doubles turned(n * n), product(n_out * n_out);
  rotate::RotateReference(static_cast<int>(n), 1, inverse, in, turned.data());
  about_z(turned.data(), product.data());
  rotate::RotateReference(static_cast<int>(n_out), 1, matrix, product.data(), out);
}

// The zonal function as any other.
Doubles Expanded(uint32_t n, const double* zonal) {
  Doubles f(n * n);
  for (uint32_t l = 0; l < n; ++l) f[l * (l + 1)] = zonal[l];
  return f;
}

void ZonalProduct(const Orders& n, const double* zonal, const double* b, double* out) {
  product::ProductReference(static_cast<int>(n.a), static_cast<int>(n.b), static_cast<int>(n.out),
                            Expanded(n.a, zonal).data(), b, out);
}

void ZonalAxisProduct(const Orders& n, const double* zonal, const double* axis, const double* b,
                      double* out) {
  Doubles turned(n.a * n.a);
  zonal::RotateReference(static_cast<int>(n.a), zonal, axis, turned.data());
  product::ProductReference(static_cast<int>(n.a), static_cast<int>(n.b), static_cast<int>(n.out),
                            turned.data(), b, out);
}

// Axes of every tenth item or so are at a pole, and as many are near one.
void MakeAxis(Random& random, float* axis) {
  random.Direction(axis);
  const double choice = random.Uniform();
  if (choice > 0.2) return;
  const float side = axis[2] < 0.0f ? -1.0f : 1.0f;
  const float distance = choice < 0.1 ? 0.0f : choice < 0.15 ? 1e-20f : 1e-4f;
  axis[0] *= distance, axis[1] *= distance, axis[2] = side;
}

enum class Axis { kZ, kEach };

Operation ZonalOperation(const Orders& n, uint32_t channels, Axis axis) {
  const size_t b = n.b * n.b, out = n.out * n.out;
  const bool each = axis == Axis::kEach;
  Operation operation;
  operation.name = (each ? "product_zonal_axis/" : "product_zonal/") + Name(n) + "/channels" +
                   std::to_string(channels);
  operation.inputs = {channels * n.a, channels * b};
  operation.outputs = {channels * out};
  if (each) operation.inputs.push_back(3);
  operation.call = [=](size_t count, const Operation::Views& i, const Operation::Views& o) {
    return each ? gaunt_product_zonal_axis(n.a, n.b, n.out, channels, count, i[0], i[2], i[1], o[0])
                : gaunt_product_zonal(n.a, n.b, n.out, channels, count, i[0], i[1], o[0]);
  };
  operation.make = [=](Random& random, size_t side, float* planes) {
    if (side == 2) return MakeAxis(random, planes);
    random.Fill(planes, channels * (side == 0 ? n.a : b), -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& i, Operation::Item& o) {
    for (uint32_t c = 0; c < channels; ++c) {
      const double* const zonal = i[0].data() + c * n.a;
      const double* const in = i[1].data() + c * b;
      double* const to = o[0].data() + c * out;
      each ? ZonalAxisProduct(n, zonal, i[2].data(), in, to) : ZonalProduct(n, zonal, in, to);
    }
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item&, size_t, size_t p) {
    const size_t c = p / out;
    return (each ? AxisTolerance(std::max(n.b, n.out)) : ZonalTolerance()) *
           Norm(i[0].data() + c * n.a, n.a) * Norm(i[1].data() + c * b, b);
  };
  if (n.out == n.b) operation.in_place = {1};
  return operation;
}

struct Fixed {
  std::string name;
  decltype(&gaunt_product_hemisphere) function;
  decltype(&gaunt_product_hemisphere_axis) axis_function;
  void (*reference)(int order, const double* in, double* out);
};
const Fixed kFixed[] = {{"hemisphere", gaunt_product_hemisphere, gaunt_product_hemisphere_axis,
                         product::HemisphereReference},
                        {"cosine", gaunt_product_cosine, gaunt_product_cosine_axis,
                         product::CosineReference}};

Operation FixedOperation(const Fixed& fixed, uint32_t n, uint32_t channels, Axis axis) {
  const size_t planes = n * n;
  const bool each = axis == Axis::kEach;
  const auto about_z = [=](const double* in, double* out) {
    fixed.reference(static_cast<int>(n), in, out);
  };
  Operation operation;
  operation.name = "product_" + fixed.name + (each ? "_axis/n" : "/n") + std::to_string(n) +
                   "/channels" + std::to_string(channels);
  operation.inputs = {channels * planes};
  operation.outputs = {channels * planes};
  if (each) operation.inputs.push_back(3);
  operation.call = [=](size_t count, const Operation::Views& i, const Operation::Views& o) {
    return each ? fixed.axis_function(n, channels, count, i[1], i[0], o[0])
                : fixed.function(n, channels, count, i[0], o[0]);
  };
  operation.make = [=](Random& random, size_t side, float* to) {
    if (side == 1) return MakeAxis(random, to);
    random.Fill(to, channels * planes, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& i, Operation::Item& o) {
    for (uint32_t c = 0; c < channels; ++c) {
      const double* const in = i[0].data() + c * planes;
      double* const out = o[0].data() + c * planes;
      each ? AboutAxis(n, n, i[1].data(), about_z, in, out) : about_z(in, out);
    }
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item&, size_t, size_t p) {
    return (each ? AxisTolerance(n) : FixedTolerance()) *
           Norm(i[0].data() + p / planes * planes, planes);
  };
  operation.in_place = {0};
  return operation;
}

// Every kernel: those of one order each, those of zonal functions of each order, and few bands of
// high ones.
const std::vector<Orders> kZonalOrders = {
    {1, 1, 1},  {2, 2, 2},   {3, 3, 3},   {4, 4, 4},  {5, 5, 5},  {6, 6, 6}, {7, 7, 7},
    {8, 8, 8},  {9, 9, 9},   {1, 3, 2},   {2, 3, 4},  {3, 6, 6},  {4, 6, 2}, {5, 2, 6},
    {6, 3, 3},  {7, 3, 7},   {8, 5, 4},   {9, 1, 9},  {10, 4, 3}};

class ProductAxial : public TargetTest {};

TEST_P(ProductAxial, ZonalMatchesTheDefinitionInEveryLayout) {
  for (const Orders& n : kZonalOrders) TestBatches(ZonalOperation(n, 1, Axis::kZ));
  for (const Orders& n : {Orders{1, 1, 1}, {3, 3, 3}, {6, 6, 6}, {7, 7, 7}, {3, 4, 4}, {4, 3, 5}}) {
    for (const uint32_t channels : {3u, 4u}) TestBatches(ZonalOperation(n, channels, Axis::kZ));
  }
}

TEST_P(ProductAxial, ZonalAxisMatchesTheDefinitionInEveryLayout) {
  for (const Orders& n : kZonalOrders) TestBatches(ZonalOperation(n, 1, Axis::kEach));
  for (const Orders& n : {Orders{1, 1, 1}, {3, 3, 3}, {6, 6, 6}, {7, 7, 7}, {3, 4, 4}, {4, 3, 5}}) {
    for (const uint32_t channels : {3u, 4u}) TestBatches(ZonalOperation(n, channels, Axis::kEach));
  }
}

TEST_P(ProductAxial, FixedOnesMatchTheDefinitionInEveryLayout) {
  for (const Fixed& fixed : kFixed) {
    for (uint32_t n = 1; n <= 8; ++n) TestBatches(FixedOperation(fixed, n, 1, Axis::kZ));
    for (const uint32_t n : {1u, 2u, 3u, 6u, 7u}) {
      for (const uint32_t channels : {3u, 4u}) {
        TestBatches(FixedOperation(fixed, n, channels, Axis::kZ));
      }
    }
  }
}

TEST_P(ProductAxial, FixedOnesAboutAxesMatchTheDefinitionInEveryLayout) {
  for (const Fixed& fixed : kFixed) {
    for (uint32_t n = 1; n <= 7; ++n) TestBatches(FixedOperation(fixed, n, 1, Axis::kEach));
    for (const uint32_t n : {1u, 3u, 6u, 7u}) {
      for (const uint32_t channels : {3u, 4u}) {
        TestBatches(FixedOperation(fixed, n, channels, Axis::kEach));
      }
    }
  }
}

TEST_P(ProductAxial, RejectsWrongArguments) {
  for (const Axis axis : {Axis::kZ, Axis::kEach}) {
    for (const Orders& n : {Orders{3, 3, 3}, {3, 4, 5}, {7, 7, 7}}) {
      TestErrors(ZonalOperation(n, 3, axis));
    }
    for (const Fixed& fixed : kFixed) {
      for (const uint32_t n : {1u, 6u, 7u}) TestErrors(FixedOperation(fixed, n, 3, axis));
    }
  }
}

// One item of each argument.
Floats Run(const Operation& operation, const std::vector<const float*>& in) {
  Floats out(operation.outputs[0]);
  std::vector<gaunt_view> views(in.size());
  Operation::Views inputs;
  for (size_t side = 0; side < in.size(); ++side) {
    gaunt_view_interleaved(const_cast<float*>(in[side]), operation.inputs[side], &views[side]);
    inputs.push_back(&views[side]);
  }
  gaunt_view to;
  gaunt_view_interleaved(out.data(), out.size(), &to);
  EXPECT_EQ(operation.call(1, inputs, {&to}), GAUNT_OK);
  return out;
}

void ExpectNear(const Floats& a, const Doubles& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], tolerance) << "coefficient " << i;
}

// All orders that there are, one item each.
TEST_P(ProductAxial, AllOrdersMatchTheDefinition) {
  Random random(3);
  for (uint32_t a = 1; a <= GAUNT_MAX_PRODUCT_ORDER; ++a) {
    for (uint32_t b = 1; b <= GAUNT_MAX_PRODUCT_ORDER; ++b) {
      for (const uint32_t out : {1u, std::max(1u, (a + b) / 3), b, std::min(b + 1, a + b - 1),
                                 std::max(1u, a + b - 2), a + b - 1}) {
        if (out > a + b - 1) continue;
        const Orders n = {a, b, out};
        SCOPED_TRACE(Name(n));
        Floats zonal = RandomItems(random, a), in = RandomItems(random, b * b), axis(3);
        random.Direction(axis.data());
        for (const Axis about : {Axis::kZ, Axis::kEach}) {
          if (about == Axis::kEach && out > GAUNT_MAX_ROTATE_ORDER) continue;
          const Operation operation = ZonalOperation(n, 1, about);
          const Operation::Item item = {Doubles(zonal.begin(), zonal.end()),
                                        Doubles(in.begin(), in.end()),
                                        Doubles(axis.begin(), axis.end())};
          Operation::Item wanted = {Doubles(out * out)};
          operation.reference(item, wanted);
          std::vector<const float*> inputs = {zonal.data(), in.data()};
          if (about == Axis::kEach) inputs.push_back(axis.data());
          ExpectNear(Run(operation, inputs), wanted[0], operation.tolerance(item, wanted, 0, 0));
        }
      }
    }
  }
}

GAUNT_INSTANTIATE_TARGETS(ProductAxial);

}  // namespace
}  // namespace gaunt::test
