// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gaunt/gaunt.h"
#include "product/product_reference.h"
#include "product/tensor.h"
#include "tests/product_items.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kMaxOrder = GAUNT_MAX_PRODUCT_ORDER;

Operation ProductOperation(const Orders& n, uint32_t channels) {
  const size_t a = n.a * n.a, b = n.b * n.b, out = n.out * n.out;
  Operation operation;
  operation.name = "product/" + Name(n) + "/channels" + std::to_string(channels);
  operation.inputs = {channels * a, channels * b};
  operation.outputs = {channels * out};
  operation.call = [=](size_t count, const Operation::Views& i, const Operation::Views& o) {
    return gaunt_product(n.a, n.b, n.out, channels, count, i[0], i[1], o[0]);
  };
  operation.make = [=](Random& random, size_t side, float* planes) {
    random.Fill(planes, channels * (side == 0 ? a : b), -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& i, Operation::Item& o) {
    for (uint32_t c = 0; c < channels; ++c) {
      product::ProductReference(static_cast<int>(n.a), static_cast<int>(n.b),
                                static_cast<int>(n.out), i[0].data() + c * a, i[1].data() + c * b,
                                o[0].data() + c * out);
    }
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item&, size_t, size_t p) {
    const size_t c = p / out;
    return ProductTolerance(n.a, n.b) * Norm(i[0].data() + c * a, a) * Norm(i[1].data() + c * b, b);
  };
  if (n.out == n.a) operation.in_place.push_back(0);
  if (n.out == n.b) operation.in_place.push_back(1);
  return operation;
}

Operation SquareOperation(uint32_t n, uint32_t n_out, uint32_t channels) {
  const Operation product = ProductOperation({n, n, n_out}, channels);
  Operation operation = product;
  operation.name = "product_square/" + std::to_string(n) + "to" + std::to_string(n_out) +
                   "/channels" + std::to_string(channels);
  operation.inputs.pop_back();
  operation.call = [=](size_t count, const Operation::Views& i, const Operation::Views& o) {
    return gaunt_product_square(n, n_out, channels, count, i[0], o[0]);
  };
  operation.reference = [=](const Operation::Item& i, Operation::Item& o) {
    product.reference({i[0], i[0]}, o);
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item& wanted, size_t side,
                            size_t p) {
    return product.tolerance({i[0], i[0]}, wanted, side, p);
  };
  operation.in_place.clear();
  if (n_out == n) operation.in_place.push_back(0);
  return operation;
}

// Whatever has a kernel of its own may be here; the rest is a sample.
const std::vector<Orders> kMixedOrders = {
    {6, 6, 3},  {6, 6, 4},   {2, 6, 6}, {3, 6, 6}, {6, 3, 6},   {6, 2, 6},   {4, 6, 6},
    {2, 3, 3},  {2, 4, 4},   {3, 4, 4}, {3, 5, 5}, {5, 3, 5},   {5, 5, 3},   {1, 5, 5},
    {5, 1, 5},  {1, 10, 10}, {2, 2, 3}, {3, 2, 1}, {3, 3, 5},   {6, 6, 1},   {6, 6, 2},
    {6, 6, 11}, {7, 3, 5},   {3, 9, 4}, {8, 8, 4}, {10, 10, 1}, {10, 10, 19}};
const std::vector<Orders> kMixedOrdersInChannels = {{6, 6, 3}, {2, 6, 6}, {6, 3, 6}, {7, 3, 5}};

class Product : public TargetTest {};

TEST_P(Product, MatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= kMaxOrder; ++n) TestBatches(ProductOperation({n, n, n}, 1));
}

TEST_P(Product, ChannelsMatchTheDefinitionInEveryLayout) {
  for (const uint32_t n : {1u, 2u, 3u, 4u, 6u, 7u}) TestBatches(ProductOperation({n, n, n}, 3));
  for (const uint32_t n : {2u, 3u}) TestBatches(ProductOperation({n, n, n}, 4));
  TestBatches(ProductOperation({3, 3, 3}, 2));
}

TEST_P(Product, MixedOrdersMatchTheDefinitionInEveryLayout) {
  for (const Orders& n : kMixedOrders) TestBatches(ProductOperation(n, 1));
  for (const Orders& n : kMixedOrdersInChannels) TestBatches(ProductOperation(n, 3));
}

TEST_P(Product, SquareMatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= kMaxOrder; ++n) TestBatches(SquareOperation(n, n, 1));
  for (const uint32_t n : {1u, 3u, 6u, 7u}) TestBatches(SquareOperation(n, n, 3));
  TestBatches(SquareOperation(3, 3, 4));
  TestBatches(SquareOperation(6, 3, 1));
  TestBatches(SquareOperation(6, 11, 1));
  TestBatches(SquareOperation(4, 7, 3));
  TestBatches(SquareOperation(10, 4, 1));
}

TEST_P(Product, RejectsWrongArguments) {
  for (const Orders& n : {Orders{3, 3, 3}, {6, 6, 6}, {6, 6, 3}, {2, 6, 6}, {8, 7, 9}}) {
    TestErrors(ProductOperation(n, 3));
  }
  for (const auto& [n, n_out] : {std::pair{3u, 3u}, {6u, 11u}, {7u, 2u}}) {
    TestErrors(SquareOperation(n, n_out, 3));
  }
  const auto product = [](uint32_t n_a, uint32_t n_b, uint32_t n_out, uint32_t channels = 1) {
    return gaunt_product(n_a, n_b, n_out, channels, 0, nullptr, nullptr, nullptr);
  };
  const auto square = [](uint32_t n, uint32_t n_out, uint32_t channels = 1) {
    return gaunt_product_square(n, n_out, channels, 0, nullptr, nullptr);
  };
  for (const uint32_t bad : {0u, 11u, UINT32_MAX}) {
    EXPECT_EQ(product(bad, 3, 3), GAUNT_ERROR_ORDER);
    EXPECT_EQ(product(3, bad, 3), GAUNT_ERROR_ORDER);
    EXPECT_EQ(product(3, 3, bad), GAUNT_ERROR_ORDER);
    EXPECT_EQ(square(bad, 3), GAUNT_ERROR_ORDER);
    EXPECT_EQ(square(3, bad), GAUNT_ERROR_ORDER);
  }
  for (uint32_t n_a = 1; n_a <= kMaxOrder; ++n_a) {
    for (uint32_t n_b = 1; n_b <= kMaxOrder; ++n_b) {
      EXPECT_EQ(product(n_a, n_b, n_a + n_b - 1), GAUNT_OK);
      EXPECT_EQ(product(n_a, n_b, n_a + n_b), GAUNT_ERROR_ORDER);
    }
    EXPECT_EQ(square(n_a, 2 * n_a - 1), GAUNT_OK);
    EXPECT_EQ(square(n_a, 2 * n_a), GAUNT_ERROR_ORDER);
  }
  for (const uint32_t bad : {0u, 5u}) {
    EXPECT_EQ(product(3, 3, 3, bad), GAUNT_ERROR_RANGE);
    EXPECT_EQ(square(3, 3, bad), GAUNT_ERROR_RANGE);
  }
}

// A view of more planes, or of fewer, is not the same view.
TEST_P(Product, IsInPlaceOnlyOfAFactorOfItsOrder) {
  constexpr size_t kCount = 3;
  Floats data(kCount * 25, 1.0f);
  const Floats before = data;
  const gaunt_view v = ViewOf(data, 5);
  for (const Orders& n : {Orders{3, 2, 4}, {4, 2, 3}, {2, 4, 3}, {3, 4, 2}, {3, 3, 5}}) {
    EXPECT_EQ(gaunt_product(n.a, n.b, n.out, 1, kCount, &v, &v, &v), GAUNT_ERROR_OVERLAP);
  }
  // In place of one factor, but the other is in the way.
  EXPECT_EQ(gaunt_product(3, 4, 4, 1, kCount, &v, &v, &v), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_product(4, 3, 4, 1, kCount, &v, &v, &v), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_product_square(3, 4, 1, kCount, &v, &v), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_product_square(4, 3, 1, kCount, &v, &v), GAUNT_ERROR_OVERLAP);
  gaunt_view next = v;
  next.data += 4;
  EXPECT_EQ(gaunt_product(4, 4, 4, 1, kCount, &v, &v, &next), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(data, before);
}

// Exact values of 1 .. 6 bands; what is not listed is 0.
std::map<std::array<int, 3>, double> GoldenTensor() {
  std::map<std::array<int, 3>, double> tensor;
  for (const auto& row : ReadGolden("gaunt_order6.csv")) {
    std::array<int, 3> ijk = {std::stoi(row[0]), std::stoi(row[1]), std::stoi(row[2])};
    do {
      tensor[ijk] = std::stod(row[3]);
    } while (std::next_permutation(ijk.begin(), ijk.end()));
  }
  return tensor;
}

double TensorEntry(int i, int j, int k) {
  const auto l = [](int p) { return static_cast<int>(std::sqrt(static_cast<double>(p))); };
  const auto m = [&](int p) { return p - l(p) * (l(p) + 1); };
  return product::Gaunt(l(i), m(i), l(j), m(j), l(k), m(k));
}

TEST(ProductTensor, MatchesGoldenValues) {
  constexpr int kCoefficients = 36;
  const auto golden = GoldenTensor();
  ASSERT_EQ(golden.size(), 2907u);
  std::vector<double> a(kCoefficients), b(kCoefficients), out(kCoefficients);
  for (int i = 0; i < kCoefficients; ++i) {
    for (int j = 0; j < kCoefficients; ++j) {
      a.assign(a.size(), 0.0), b.assign(b.size(), 0.0);
      a[static_cast<size_t>(i)] = b[static_cast<size_t>(j)] = 1.0;
      product::ProductReference(6, 6, 6, a.data(), b.data(), out.data());
      for (int k = 0; k < kCoefficients; ++k) {
        const auto entry = golden.find({i, j, k});
        const double wanted = entry == golden.end() ? 0.0 : entry->second;
        const double found = TensorEntry(i, j, k);
        ASSERT_EQ(found == 0.0, wanted == 0.0) << i << " " << j << " " << k;
        ASSERT_NEAR(found, wanted, 2e-15) << i << " " << j << " " << k;
        ASSERT_NEAR(out[static_cast<size_t>(k)], wanted, 1e-14) << i << " " << j << " " << k;
      }
    }
  }
}

// Each pair of basis functions as an item.
struct UnitPairs {
  Floats a, b;
  UnitPairs(size_t n_a, size_t n_b)
      : a(n_a * n_a * n_b * n_b * n_a * n_a), b(n_a * n_a * n_b * n_b * n_b * n_b) {
    for (size_t i = 0; i < n_a * n_a; ++i) {
      for (size_t j = 0; j < n_b * n_b; ++j) {
        const size_t item = i * n_b * n_b + j;
        a[item * n_a * n_a + i] = b[item * n_b * n_b + j] = 1.0f;
      }
    }
  }
};

TEST_P(Product, OfBasisFunctionsIsTheGoldenTensor) {
  const auto golden = GoldenTensor();
  std::vector<Orders> orders = {{6, 6, 3}, {6, 6, 4}, {2, 6, 6}, {3, 6, 6},
                                {6, 3, 6}, {4, 2, 5}, {1, 6, 6}, {5, 5, 3}};
  for (uint32_t n = 1; n <= 6; ++n) orders.push_back({n, n, n});
  for (const Orders& n : orders) {
    const UnitPairs pairs(n.a, n.b);
    const Floats out = ProductOf(n, pairs.a, pairs.b);
    for (size_t p = 0; p < out.size(); ++p) {
      const size_t k = p % (n.out * n.out), item = p / (n.out * n.out);
      const size_t i = item / (n.b * n.b), j = item % (n.b * n.b);
      const auto entry =
          golden.find({static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)});
      ASSERT_NEAR(out[p], entry == golden.end() ? 0.0 : entry->second, ProductTolerance(n.a, n.b))
          << Name(n) << ": " << i << " " << j << " " << k;
    }
  }
}

TEST_P(Product, OfBasisFunctionsIsTheTensorAtOrder10) {
  const Orders n = {10, 10, 10};
  const UnitPairs pairs(n.a, n.b);
  const Floats out = ProductOf(n, pairs.a, pairs.b);
  for (int p = 0; p < 1000000; ++p) {
    const int i = p / 10000, j = p / 100 % 100, k = p % 100;
    ASSERT_NEAR(out[static_cast<size_t>(p)], TensorEntry(i, j, k), ProductTolerance(10, 10))
        << i << " " << j << " " << k;
  }
}

// All 1000 triples of orders: what is cut off changes nothing of what is left.
TEST_P(Product, HasEveryOrder) {
  Random random(23);
  for (uint32_t n_a = 1; n_a <= kMaxOrder; ++n_a) {
    for (uint32_t n_b = 1; n_b <= kMaxOrder; ++n_b) {
      const Floats a = RandomItems(random, n_a * n_a), b = RandomItems(random, n_b * n_b);
      const double tolerance = ProductTolerance(n_a, n_b) * Norm(a) * Norm(b);
      const uint32_t all = n_a + n_b - 1;
      const std::vector<double> wanted = ExactProduct({n_a, n_b, all}, a.data(), b.data());
      const std::vector<double> wanted_square =
          ExactProduct({n_a, n_a, 2 * n_a - 1}, a.data(), a.data());
      for (uint32_t n_out = 1; n_out <= all; ++n_out) {
        const Orders n = {n_a, n_b, n_out};
        const Floats out = ProductOf(n, a, b);
        for (size_t k = 0; k < out.size(); ++k) {
          ASSERT_NEAR(out[k], wanted[k], tolerance) << Name(n) << ": " << k;
        }
        if (n_a != n_b) continue;
        const Floats square = SquareOf(n_a, n_out, a);
        const double norm = Norm(a);
        for (size_t k = 0; k < square.size(); ++k) {
          ASSERT_NEAR(square[k], wanted_square[k], ProductTolerance(n_a, n_a) * norm * norm)
              << Name(n) << ": " << k;
        }
      }
    }
  }
}

// One view as both factors, apart from the output and in place.
TEST_P(Product, TakesOneViewAsBothFactors) {
  Random random(31);
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    const size_t coefficients = n * n, count = 19;
    const Floats a = RandomItems(random, coefficients * count), copy = a;
    const Floats product = ProductOf({n, n, n}, a, copy), square = SquareOf(n, n, a);
    EXPECT_EQ(ProductOf({n, n, n}, a, a), product) << "order " << n;
    Floats in_place = a;
    const gaunt_view view = ViewOf(in_place, n);
    ASSERT_EQ(gaunt_product(n, n, n, 1, count, &view, &view, &view), GAUNT_OK);
    EXPECT_EQ(in_place, product) << "order " << n;
    for (size_t i = 0; i < count; ++i) {
      const double norm = Norm(a.data() + i * coefficients, coefficients);
      for (size_t k = i * coefficients; k < (i + 1) * coefficients; ++k) {
        ASSERT_NEAR(square[k], product[k], 2.0 * ProductTolerance(n, n) * norm * norm)
            << "order " << n;
      }
    }
  }
}

TEST_P(Product, WithAConstantScales) {
  Random random(37);
  const float one = static_cast<float>(std::sqrt(4.0 * kPi));  // of the coefficient y_00
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    const Floats f = RandomItems(random, n * n);
    const double norm = Norm(f);
    for (const uint32_t n_one : {1u, n}) {
      Floats constant(n_one * n_one);
      constant[0] = one;
      const double tolerance = ProductTolerance(n, n) * one * norm;
      const Floats left = ProductOf({n_one, n, n}, constant, f);
      const Floats right = ProductOf({n, n_one, n}, f, constant);
      for (size_t k = 0; k < f.size(); ++k) {
        ASSERT_NEAR(left[k], f[k], tolerance) << "order " << n;
        ASSERT_NEAR(right[k], f[k], tolerance) << "order " << n;
      }
    }
  }
}

TEST_P(Product, Commutes) {
  Random random(41);
  for (const Orders& n : kMixedOrders) {
    const Floats a = RandomItems(random, n.a * n.a), b = RandomItems(random, n.b * n.b);
    const double tolerance = 2.0 * ProductTolerance(n.a, n.b) * Norm(a) * Norm(b);
    const Floats ab = ProductOf(n, a, b), ba = ProductOf({n.b, n.a, n.out}, b, a);
    for (size_t k = 0; k < ab.size(); ++k) ASSERT_NEAR(ab[k], ba[k], tolerance) << Name(n);
  }
}

TEST(ProductBits, AreTheSameOnTargetsOfAClass) {
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    TestSameBits(ProductOperation({n, n, n}, 1));
    TestSameBits(SquareOperation(n, n, 1));
  }
  for (const Orders& n : kMixedOrders) TestSameBits(ProductOperation(n, 1));
  for (const uint32_t n : {3u, 6u}) TestSameBits(ProductOperation({n, n, n}, 3));
}

GAUNT_INSTANTIATE_TARGETS(Product);

}  // namespace
}  // namespace gaunt::test
