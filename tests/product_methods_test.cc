// SPDX-License-Identifier: MIT
// The other ways to make products, which charts compare with the library's: they are products.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "product/methods/methods.h"
#include "product/product_reference.h"
#include "simd/count.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

namespace methods = product::methods;

constexpr size_t kItems = 37;  // whole groups of lanes, and a tail

double Norm(const std::vector<double>& values) {
  double squared = 0.0;
  for (const double value : values) squared += value * value;
  return std::sqrt(squared);
}

// Items of order n in [-1, 1].
struct Functions {
  size_t planes;
  std::vector<float> values;

  Functions(int n, uint64_t seed)
      : planes(static_cast<size_t>(NumCoefficients(n))), values(kItems * planes) {
    Random random(seed);
    random.Fill(values.data(), values.size(), -1.0, 1.0);
  }
  std::vector<double> Item(size_t i) const {
    const auto first = values.begin() + static_cast<ptrdiff_t>(i * planes);
    return {first, first + static_cast<ptrdiff_t>(planes)};
  }
  simd::InView view() const { return simd::InterleavedIn(values.data(), planes); }
};

class ProductMethods : public TargetTest {
 protected:
  // run(b, out) makes the products of a, or of its first item, and b.
  template <class Run>
  void ExpectProducts(const std::string& method, int n, bool one, const Run& run) {
    SCOPED_TRACE(method + " of order " + std::to_string(n));
    const Functions a(n, 1), b(n, 2);
    std::vector<float> out(b.values.size(), 7.0f);
    run(a, b, simd::InterleavedOut(out.data(), b.planes));
    std::vector<double> wanted(b.planes);
    for (size_t i = 0; i < kItems; ++i) {
      const std::vector<double> of_a = a.Item(one ? 0 : i), of_b = b.Item(i);
      product::ProductReference(n, n, n, of_a.data(), of_b.data(), wanted.data());
      for (size_t p = 0; p < b.planes; ++p) {
        ASSERT_NEAR(out[i * b.planes + p], wanted[p], 3e-7 * Norm(of_a) * Norm(of_b))
            << "item " << i << " plane " << p;
      }
    }
  }

  void ExpectProducts(const std::string& method, int n, methods::MethodFn multiply) {
    ExpectProducts(method, n, false,
                   [&](const Functions& a, const Functions& b, const simd::OutView& out) {
                     multiply(kItems, a.view(), b.view(), out);
                   });
  }
};

TEST_P(ProductMethods, BySumsOfTermsMatchTheDefinition) {
  const methods::sparse::Table& table = methods::sparse::Kernels();
  for (int n = methods::kMinOrder; n <= methods::sparse::kMaxOrder; ++n) {
    ExpectProducts("by output", n, table.by_output[n]);
    ExpectProducts("by pairs", n, table.by_pairs[n]);
  }
}

TEST_P(ProductMethods, OfEveryLevelMatchTheDefinition) {
  const methods::levels::Table& table = methods::levels::Kernels();
  for (int level = 0; level < methods::levels::kLevels; ++level) {
    for (int n = methods::kMinOrder; n <= methods::levels::kMaxOrder; ++n) {
      ExpectProducts("level " + std::to_string(level), n, table.product[level][n]);
    }
  }
}

TEST_P(ProductMethods, ByAMatrixMatchTheDefinition) {
  const methods::dense::Table& table = methods::dense::Kernels();
  for (int n = methods::kMinOrder; n <= product::kMaxOrder; ++n) {
    ExpectProducts("matrix", n, true,
                   [&](const Functions& a, const Functions& b, const simd::OutView& out) {
                     const std::vector<float> matrix =
                         methods::dense::MatrixOf(n, a.values.data());
                     table.apply[n](matrix.data(), kItems, b.view(), out);
                   });
  }
}

// The multiplications and the additions of the code that D3DX and DirectXMath have, as MSR-TR-2006-53
// states them for order 6.
TEST(ProductMethodCounts, OfPairsAreThePublishedOnes) {
  const uint64_t multiplies[] = {20, 120, 399, 1135, 2527};
  for (int n = 2; n <= 6; ++n) {
    const Operations operations = OperationsOf("product", std::to_string(n), "by_pairs");
    EXPECT_EQ(operations.Multiplies(), multiplies[n - 2]) << "order " << n;
    if (n == 6) {
      EXPECT_EQ(operations.fma + operations.add, 1995u);
    }
  }
}

GAUNT_INSTANTIATE_TARGETS(ProductMethods);

}  // namespace
}  // namespace gaunt::test
