// SPDX-License-Identifier: MIT
// Products with functions that are symmetric about an axis.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "product/product_reference.h"
#include "rotate/rotate_reference.h"
#include "tests/product_items.h"
#include "tests/support/buffer.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"
#include "zonal/zonal_reference.h"

namespace gaunt::test {
namespace {

// As gaunt.h states them: relative to the norm of the coefficients, and to that of the zonal
// function's.
constexpr double ZTolerance(uint32_t n) { return n <= 6 ? 2e-7 : 3e-7; }
constexpr double AxisTolerance(uint32_t n) { return 2e-7 + 1e-7 * n; }

using Doubles = std::vector<double>;

// A rotation that takes z to the axis: the shortest one, from -z where the axis is below.
void AxisRotation(const double axis[3], double matrix[9]) {
  const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
  const double upward[4] = {-y, x, 0.0, 1.0 + z};
  // A half turn about x, and then from -z.
  const double downward[4] = {1.0 - z, 0.0, x, -y};
  rotate::MatrixReference(z >= 0.0 ? upward : downward, matrix);
}

// The integral of `in`, times a power of the cosine, over the half space of the axis, by nodes that
// lie about it.
void HalfSpaceProduct(uint32_t n, int power, const double axis[3], const double* in, double* out) {
  const double turn = 2.0 * std::acos(-1.0) / (2 * n - 1);
  Doubles nodes, weights, y(n * n);
  rotate::GaussLegendre(static_cast<int>(n), &nodes, &weights);
  double matrix[9];
  AxisRotation(axis, matrix);
  std::fill(out, out + n * n, 0.0);
  for (size_t row = 0; row < n; ++row) {
    const double z = 0.5 + 0.5 * nodes[row], r = std::sqrt((1.0 - z) * (1.0 + z));
    for (uint32_t column = 0; column < 2 * n - 1; ++column) {
      const double local[3] = {r * std::cos(turn * column), r * std::sin(turn * column), z};
      double direction[3] = {};
      for (int i = 0; i < 9; ++i) direction[i / 3] += matrix[i] * local[i % 3];
      basis::EvalReference(static_cast<int>(n), direction, y.data());
      const double value = std::inner_product(y.begin(), y.end(), in, 0.0) *
                           (power == 0 ? 1.0 : z) * 0.5 * weights[row] * turn;
      for (size_t i = 0; i < y.size(); ++i) out[i] += value * y[i];
    }
  }
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
    const uint32_t most = std::max({n.a, n.b, n.out});
    return (each ? AxisTolerance(most) : ZTolerance(most)) * Norm(i[0].data() + c * n.a, n.a) *
           Norm(i[1].data() + c * b, b);
  };
  if (n.out == n.b) operation.in_place = {1};
  return operation;
}

struct Fixed {
  std::string name;
  decltype(&gaunt_product_hemisphere) function;
  decltype(&gaunt_product_hemisphere_axis) axis_function;
  void (*reference)(int order, const double* in, double* out);
  int power;  // of the cosine
};
const Fixed kFixed[] = {
    {"hemisphere", gaunt_product_hemisphere, gaunt_product_hemisphere_axis,
     product::HemisphereReference, 0},
    {"cosine", gaunt_product_cosine, gaunt_product_cosine_axis, product::CosineReference, 1}};

Operation FixedOperation(const Fixed& fixed, uint32_t n, uint32_t channels, Axis axis) {
  const size_t planes = n * n;
  const bool each = axis == Axis::kEach;
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
      each ? HalfSpaceProduct(n, fixed.power, i[1].data(), in, out)
           : fixed.reference(static_cast<int>(n), in, out);
    }
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item&, size_t, size_t p) {
    return (each ? AxisTolerance(n) : ZTolerance(n)) *
           Norm(i[0].data() + p / planes * planes, planes);
  };
  operation.in_place = {0};
  return operation;
}

// Every kernel: those of one order each, those of zonal functions of each order, and few bands of
// high ones.
const std::vector<Orders> kZonalOrders = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5},
                                          {6, 6, 6}, {7, 7, 7}, {8, 8, 8}, {9, 9, 9}, {1, 3, 2},
                                          {2, 3, 4}, {3, 6, 6}, {4, 6, 2}, {5, 2, 6}, {6, 3, 3},
                                          {7, 3, 7}, {8, 5, 4}, {9, 1, 9}, {10, 4, 3}};

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

TEST_P(ProductAxial, RejectsOrdersAndFactorsInPlace) {
  const auto zonal = [](uint32_t a, uint32_t b, uint32_t out, uint32_t channels) {
    return gaunt_product_zonal(a, b, out, channels, 0, nullptr, nullptr, nullptr);
  };
  const auto zonal_axis = [](uint32_t a, uint32_t b, uint32_t out, uint32_t channels) {
    return gaunt_product_zonal_axis(a, b, out, channels, 0, nullptr, nullptr, nullptr, nullptr);
  };
  for (const Orders& n :
       {Orders{0, 3, 3}, {3, 0, 3}, {3, 3, 0}, {11, 3, 3}, {3, 11, 3}, {3, 4, 7}}) {
    EXPECT_EQ(zonal(n.a, n.b, n.out, 1), GAUNT_ERROR_ORDER) << Name(n);
    EXPECT_EQ(zonal_axis(n.a, n.b, n.out, 1), GAUNT_ERROR_ORDER) << Name(n);
  }
  EXPECT_EQ(zonal(10, 10, 19, 1), GAUNT_OK);
  EXPECT_EQ(zonal_axis(10, 10, 16, 1), GAUNT_OK);
  EXPECT_EQ(zonal_axis(10, 10, 17, 1), GAUNT_ERROR_ORDER);
  for (const uint32_t channels : {0u, 5u}) {
    EXPECT_EQ(zonal(3, 3, 3, channels), GAUNT_ERROR_RANGE);
    EXPECT_EQ(zonal_axis(3, 3, 3, channels), GAUNT_ERROR_RANGE);
  }
  for (const Fixed& fixed : kFixed) {
    for (const uint32_t n : {0u, 11u}) {
      EXPECT_EQ(fixed.function(n, 1, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
      EXPECT_EQ(fixed.axis_function(n, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
    }
    for (const uint32_t channels : {0u, 5u}) {
      EXPECT_EQ(fixed.function(3, channels, 0, nullptr, nullptr), GAUNT_ERROR_RANGE);
      EXPECT_EQ(fixed.axis_function(3, channels, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    }
  }
  // A view that has as many planes as the output is still no place for it.
  float z[1] = {0.5f}, f[1] = {2.0f};
  gaunt_view vz, vf;
  gaunt_view_interleaved(z, 1, &vz);
  gaunt_view_interleaved(f, 1, &vf);
  EXPECT_EQ(gaunt_product_zonal(1, 1, 1, 1, 1, &vz, &vf, &vz), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(z[0], 0.5f);
}

// One item of each argument.
Floats OneItem(const Operation& operation, const std::vector<const float*>& in) {
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
          ExpectNear(OneItem(operation, inputs), wanted[0],
                     operation.tolerance(item, wanted, 0, 0));
        }
      }
    }
  }
}

Floats ZonalOf(const Orders& n, const Floats& zonal, const Floats& b) {
  return OneItem(ZonalOperation(n, 1, Axis::kZ), {zonal.data(), b.data()});
}
Floats ZonalOf(const Orders& n, const Floats& zonal, const Floats& axis, const Floats& b) {
  return OneItem(ZonalOperation(n, 1, Axis::kEach), {zonal.data(), b.data(), axis.data()});
}
Floats FixedOf(const Fixed& fixed, uint32_t n, const Floats& in) {
  return OneItem(FixedOperation(fixed, n, 1, Axis::kZ), {in.data()});
}
Floats FixedOf(const Fixed& fixed, uint32_t n, const Floats& axis, const Floats& in) {
  return OneItem(FixedOperation(fixed, n, 1, Axis::kEach), {in.data(), axis.data()});
}

Floats Unit(size_t size, size_t i) {
  Floats unit(size);
  unit[i] = 1.0f;
  return unit;
}

// The entries themselves, and exact zeros: by the kernels of their own orders and by that of any.
TEST_P(ProductAxial, FixedOnesHaveTheGoldenMatrices) {
  const char* const files[] = {"hemimult_order6.csv", "cosmult_order6.csv"};
  for (size_t f = 0; f < 2; ++f) {
    std::map<std::pair<size_t, size_t>, double> golden;
    for (const auto& row : ReadGolden(files[f])) {
      golden[{std::stoul(row[0]), std::stoul(row[1])}] = std::stod(row[2]);
    }
    ASSERT_EQ(golden.size(), f == 0 ? 106u : 126u);
    for (const uint32_t n : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 10u}) {
      const size_t known = std::min(n * n, 36u);
      for (size_t j = 0; j < known; ++j) {
        const Floats column = FixedOf(kFixed[f], n, Unit(n * n, j));
        for (size_t i = 0; i < known; ++i) {
          const auto entry = golden.find({i, j});
          const double wanted = entry == golden.end() ? 0.0 : entry->second;
          ASSERT_NEAR(column[i], wanted, 6e-8 * std::abs(wanted))
              << files[f] << " at order " << n << ": " << i << " " << j;
        }
      }
    }
  }
}

// As the manual says: what has been cut off to order n loses by being multiplied again. The
// eigenvalue 1/2 of the last coefficient is the farthest from 0 and 1.
TEST_P(ProductAxial, TheHemisphereIsNoProjectionOnceItIsCutOff) {
  Random random(31);
  for (const uint32_t n : {2u, 6u, 8u}) {
    const auto change = [&](const Floats& in) {
      const Floats once = FixedOf(kFixed[0], n, in), twice = FixedOf(kFixed[0], n, once);
      Floats difference(in.size());
      for (size_t i = 0; i < in.size(); ++i) difference[i] = twice[i] - once[i];
      return Norm(difference) / Norm(in);
    };
    EXPECT_EQ(change(Unit(n * n, n * n - 1)), 0.25);
    for (int trial = 0; trial < 20; ++trial) {
      EXPECT_LE(change(RandomItems(random, n * n)), 0.25 + 2.0 * ZTolerance(n));
    }
  }
}

TEST_P(ProductAxial, ZonalIsAProductOfTheFunctionExpanded) {
  Random random(32);
  for (const Orders& n : {Orders{3, 3, 3}, {6, 6, 6}, {3, 6, 6}, {7, 5, 9}, {10, 10, 10}}) {
    const Floats zonal = RandomItems(random, n.a), b = RandomItems(random, n.b * n.b);
    Floats expanded(n.a * n.a);
    for (uint32_t l = 0; l < n.a; ++l) expanded[l * (l + 1)] = zonal[l];
    const Floats product = ProductOf(n, expanded, b);
    const double tolerance = ZTolerance(std::max({n.a, n.b, n.out})) + ProductTolerance(n.a, n.b);
    ExpectNear(ZonalOf(n, zonal, b), Doubles(product.begin(), product.end()),
               tolerance * Norm(zonal) * Norm(b));
  }
}

// On the axis itself, and at every distance from it, on both sides.
TEST_P(ProductAxial, AxesMayBeAtPolesAndNearThem) {
  Random random(34);
  for (const uint32_t n : {2u, 3u, 6u, 7u}) {
    const Orders orders = {n, n, n};
    const Floats zonal = RandomItems(random, n), in = RandomItems(random, n * n);
    for (const float side : {1.0f, -1.0f}) {
      for (int exponent = 0; exponent <= 46; exponent += exponent < 10 ? 1 : 4) {
        const float angle = random.Between(0.0, 6.28);
        const float distance =
            exponent == 46 ? 0.0f : std::pow(10.0f, static_cast<float>(-exponent));
        const float x = distance * std::cos(angle), y = distance * std::sin(angle);
        const Floats axis = {x, y, side * std::sqrt(std::max(0.0f, 1.0f - x * x - y * y))};
        SCOPED_TRACE(std::to_string(n) + " at " + std::to_string(side) + " 1e-" +
                     std::to_string(exponent));
        const Doubles a(axis.begin(), axis.end()), z(zonal.begin(), zonal.end()),
            b(in.begin(), in.end());
        Doubles wanted(n * n);
        ZonalAxisProduct(orders, z.data(), a.data(), b.data(), wanted.data());
        ExpectNear(ZonalOf(orders, zonal, axis, in), wanted,
                   AxisTolerance(n) * Norm(zonal) * Norm(in));
        for (const Fixed& fixed : kFixed) {
          HalfSpaceProduct(n, fixed.power, a.data(), b.data(), wanted.data());
          ExpectNear(FixedOf(fixed, n, axis, in), wanted, AxisTolerance(n) * Norm(in));
        }
      }
    }
    // The same as about z.
    const Floats up = {0.0f, 0.0f, 1.0f};
    const Floats product = ZonalOf(orders, zonal, in);
    ExpectNear(ZonalOf(orders, zonal, up, in), Doubles(product.begin(), product.end()),
               AxisTolerance(n) * Norm(zonal) * Norm(in));
  }
}

// Both halves make up the whole; the cosine and its opposite, a product with the cosine itself.
TEST_P(ProductAxial, OppositeAxesMakeUpTheWhole) {
  Random random(35);
  const float kCosine = static_cast<float>(std::sqrt(4.0 * std::acos(-1.0) / 3.0));
  for (const uint32_t n : {1u, 2u, 4u, 6u, 8u, 10u}) {
    const Floats in = RandomItems(random, n * n);
    Floats axis(3);
    random.Direction(axis.data());
    const Floats opposite = {-axis[0], -axis[1], -axis[2]};
    const double tolerance = 2.0 * AxisTolerance(n) * Norm(in);
    const Floats upper = FixedOf(kFixed[0], n, axis, in),
                 lower = FixedOf(kFixed[0], n, opposite, in);
    const Floats above = FixedOf(kFixed[1], n, axis, in),
                 below = FixedOf(kFixed[1], n, opposite, in);
    const Floats cosine = ZonalOf({2, n, n}, {0.0f, kCosine}, axis, in);
    for (size_t i = 0; i < in.size(); ++i) {
      ASSERT_NEAR(upper[i] + lower[i], in[i], tolerance) << n << " " << i;
      ASSERT_NEAR(above[i] - below[i], cosine[i], 2.0 * tolerance) << n << " " << i;
    }
  }
}

// Errors are relative to the factors, whatever is left of them: lobes that a hemisphere cuts off,
// factors that cancel, and bands that differ by a million.
TEST_P(ProductAxial, WhatCancelsStaysWithinTheTolerance) {
  Random random(36);
  for (const uint32_t n : {2u, 4u, 6u, 8u, 10u}) {
    const Orders orders = {n, n, n};
    std::vector<Floats> inputs;
    Floats lobe(n * n), decaying = RandomItems(random, n * n), growing = decaying, signs = decaying;
    Doubles y(n * n);
    const double down[3] = {0.1, -0.2, -1.0};
    basis::EvalReference(static_cast<int>(n), down, y.data());
    lobe.assign(y.begin(), y.end());
    for (size_t i = 0; i < decaying.size(); ++i) {
      const double l = std::floor(std::sqrt(static_cast<double>(i)));
      const float range = static_cast<float>(std::pow(10.0, 6.0 * l / (n - 1.0)));
      decaying[i] /= range;
      growing[i] *= range;
      signs[i] = signs[i] < 0.0f ? -1.0f : 1.0f;
    }
    Floats axis(3);
    random.Direction(axis.data());
    const Doubles a(axis.begin(), axis.end());
    Floats zonal(n), sharp(n);
    for (uint32_t l = 0; l < n; ++l) {
      // A delta at +z, which the lobe all but misses; and bands that grow.
      zonal[l] = static_cast<float>(std::sqrt(2.0 * l + 1.0));
      sharp[l] = static_cast<float>(std::pow(10.0, 6.0 * l / (n - 1.0)));
    }
    for (const Floats& in : {lobe, decaying, growing, signs}) {
      const Doubles b(in.begin(), in.end());
      Doubles wanted(n * n);
      for (const Fixed& fixed : kFixed) {
        fixed.reference(static_cast<int>(n), b.data(), wanted.data());
        ExpectNear(FixedOf(fixed, n, in), wanted, ZTolerance(n) * Norm(in));
      }
      for (const Floats& factor : {zonal, sharp}) {
        const Doubles z(factor.begin(), factor.end());
        const double norms = Norm(factor) * Norm(in);
        ZonalProduct(orders, z.data(), b.data(), wanted.data());
        ExpectNear(ZonalOf(orders, factor, in), wanted, ZTolerance(n) * norms);
        ZonalAxisProduct(orders, z.data(), a.data(), b.data(), wanted.data());
        ExpectNear(ZonalOf(orders, factor, axis, in), wanted, AxisTolerance(n) * norms);
      }
    }
  }
}

// Signs found by climbing to larger errors: each flip that enlarges the error is kept.
TEST_P(ProductAxial, TheWorstSignsAreWithinTheTolerance) {
  Random random(37);
  // Of the errors of one item, relative to the tolerance; `climbing` is the input whose signs flip.
  const auto expect_within = [&](const Operation& operation, size_t climbing) {
    SCOPED_TRACE(operation.name);
    std::vector<Floats> in;
    for (size_t side = 0; side < operation.inputs.size(); ++side) {
      in.emplace_back(operation.inputs[side]);
      operation.make(random, side, in[side].data());
    }
    const auto error = [&] {
      Operation::Item exact, wanted = {Doubles(operation.outputs[0])};
      std::vector<const float*> inputs;
      for (const Floats& side : in) {
        exact.emplace_back(side.begin(), side.end());
        inputs.push_back(side.data());
      }
      operation.reference(exact, wanted);
      const Floats out = OneItem(operation, inputs);
      double largest = 0.0;
      for (size_t i = 0; i < out.size(); ++i) {
        largest = std::max(largest, std::abs(out[i] - wanted[0][i]));
      }
      return largest / operation.tolerance(exact, wanted, 0, 0);
    };
    Floats& signs = in[climbing];
    for (float& value : signs) value = value < 0.0f ? -1.0f : 1.0f;
    double worst = error();
    for (int step = 0; step < 150; ++step) {
      const size_t i = random.Bits() % signs.size();
      signs[i] = -signs[i];
      const double now = error();
      if (now < worst) signs[i] = -signs[i];
      worst = std::max(worst, now);
    }
    EXPECT_LE(worst, 1.0);
  };
  for (const uint32_t n : {2u, 3u, 6u, 8u}) {
    for (const Axis axis : {Axis::kZ, Axis::kEach}) {
      expect_within(ZonalOperation({n, n, n}, 1, axis), 1);
      for (const Fixed& fixed : kFixed) expect_within(FixedOperation(fixed, n, 1, axis), 0);
    }
  }
}

// No threshold depends on the scale of a factor: powers of two change no digit.
TEST_P(ProductAxial, PowersOfTwoScaleExactly) {
  Random random(38);
  for (const uint32_t n : {3u, 6u, 9u}) {
    const Floats zonal = RandomItems(random, n), in = RandomItems(random, n * n);
    Floats axis(3);
    random.Direction(axis.data());
    const auto scaled = [](Floats values, float scale) {
      for (float& value : values) value *= scale;
      return values;
    };
    for (const float scale : {0x1p-40f, 0x1p40f}) {
      EXPECT_EQ(ZonalOf({n, n, n}, scaled(zonal, scale), axis, scaled(in, 4.0f)),
                scaled(ZonalOf({n, n, n}, zonal, axis, in), scale * 4.0f));
      for (const Fixed& fixed : kFixed) {
        EXPECT_EQ(FixedOf(fixed, n, axis, scaled(in, scale)),
                  scaled(FixedOf(fixed, n, axis, in), scale));
      }
    }
  }
}

// Outputs that are streamed past the caches are the same, to the bit and to the edge, whether a
// product is turned where it is written or not.
TEST_P(ProductAxial, LargeOutputsAreTheSame) {
  for (const Orders& n : {Orders{3, 3, 3}, {2, 3, 4}}) {
    const size_t planes = n.out * n.out;
    const size_t count = (size_t{33} << 20) / (planes * sizeof(float)) + 21;
    for (const Layout layout : {Layout::kTiled, Layout::kInterleaved}) {
      SCOPED_TRACE(Name(layout) + " " + Name(n));
      Buffer zonal(layout, count, n.a), axes(layout, count, 3), b(layout, count, n.b * n.b);
      Buffer out(layout, count, planes, Start::kLine);
      Random random(39);
      Floats z(n.a), axis(3), in(n.b * n.b);
      for (size_t i = 0; i < count; ++i) {
        random.Direction(axis.data());
        for (size_t p = 0; p < 3; ++p) axes.Set(i, p, axis[p]);
        for (size_t p = 0; p < n.a; ++p) zonal.Set(i, p, random.Between(-1.0, 1.0));
        for (size_t p = 0; p < n.b * n.b; ++p) b.Set(i, p, random.Between(-1.0, 1.0));
      }
      for (const bool each : {false, true}) {
        const gaunt_status status =
            each ? gaunt_product_zonal_axis(n.a, n.b, n.out, 1, count, zonal.view(), axes.view(),
                                            b.view(), out.view())
                 : gaunt_product_zonal(n.a, n.b, n.out, 1, count, zonal.view(), b.view(),
                                       out.view());
        ASSERT_EQ(status, GAUNT_OK);
        ASSERT_TRUE(out.CanariesIntact());
        for (size_t i = 0; i < count; i += i + 50 < count ? 997 : 1) {
          for (size_t p = 0; p < n.a; ++p) z[p] = zonal.Get(i, p);
          for (size_t p = 0; p < 3; ++p) axis[p] = axes.Get(i, p);
          for (size_t p = 0; p < in.size(); ++p) in[p] = b.Get(i, p);
          const Floats one = each ? ZonalOf(n, z, axis, in) : ZonalOf(n, z, in);
          for (size_t p = 0; p < planes; ++p) ASSERT_EQ(out.Get(i, p), one[p]) << i << " " << p;
        }
      }
    }
  }
}

TEST(ProductAxialBits, AreTheSameOnTargetsOfAClass) {
  for (const Axis axis : {Axis::kZ, Axis::kEach}) {
    for (const Orders& n : kZonalOrders) TestSameBits(ZonalOperation(n, 1, axis));
    for (const Orders& n : {Orders{6, 6, 6}, {3, 4, 4}}) TestSameBits(ZonalOperation(n, 3, axis));
    for (const Fixed& fixed : kFixed) {
      for (uint32_t n = 1; n <= 8; ++n) TestSameBits(FixedOperation(fixed, n, 1, axis));
    }
  }
}

GAUNT_INSTANTIATE_TARGETS(ProductAxial);

}  // namespace
}  // namespace gaunt::test
