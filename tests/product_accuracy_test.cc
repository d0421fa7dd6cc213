// SPDX-License-Identifier: MIT
// Accuracy of products: in the mean, at worst, and where they cancel, shrink or grow. Results have
// the measured errors as properties, in units of 1e-9: --gtest_output=json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "basis/basis_reference.h"
#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "product/tensor.h"
#include "tests/product_items.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kMaxOrder = GAUNT_MAX_PRODUCT_ORDER;

// As gaunt.h states it: the root mean square of |error| / |product|.
constexpr double MeanTolerance(uint32_t n) { return n <= 6 ? 1.2e-7 : 1.5e-7; }

// The sum over the tensor's non-zeros, in floats.
Floats NaiveProduct(uint32_t n, const Floats& a, const Floats& b) {
  struct Entry {
    size_t i, j, k;
    float value;
  };
  static std::map<uint32_t, std::vector<Entry>> tensors;
  std::vector<Entry>& tensor = tensors[n];
  const int bands = static_cast<int>(n);
  const auto visit = [&](const auto& function) {
    for (int l = 0; l < bands; ++l) {
      for (int m = -l; m <= l; ++m) function(l, m, static_cast<size_t>(l * (l + 1) + m));
    }
  };
  if (tensor.empty()) {
    visit([&](int l1, int m1, size_t i) {
      visit([&](int l2, int m2, size_t j) {
        visit([&](int l3, int m3, size_t k) {
          const double value = product::Gaunt(l1, m1, l2, m2, l3, m3);
          if (value != 0.0) tensor.push_back({i, j, k, static_cast<float>(value)});
        });
      });
    });
  }
  Floats out(a.size());
  for (size_t first = 0; first < a.size(); first += n * n) {
    for (const Entry& e : tensor) {
      out[first + e.k] += e.value * (a[first + e.i] * b[first + e.j]);
    }
  }
  return out;
}

// Of item `i`: error and exact product.
std::vector<double> ErrorOf(const Orders& n, const Floats& a, const Floats& b, const Floats& out,
                            size_t i, std::vector<double>* exact) {
  *exact = ExactProduct(n, a.data() + i * n.a * n.a, b.data() + i * n.b * n.b);
  std::vector<double> error(exact->size());
  for (size_t k = 0; k < error.size(); ++k) {
    error[k] = double{out[i * error.size() + k]} - (*exact)[k];
  }
  return error;
}

// Root mean square of |error| / |product| over all items.
double MeanError(const Orders& n, const Floats& a, const Floats& b, const Floats& out) {
  const size_t count = a.size() / (n.a * n.a);
  double sum = 0.0;
  std::vector<double> exact;
  for (size_t i = 0; i < count; ++i) {
    const std::vector<double> error = ErrorOf(n, a, b, out, i, &exact);
    const double relative = Norm(error.data(), error.size()) / Norm(exact.data(), exact.size());
    sum += relative * relative;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

// Products by a prepared function each.
Floats PreparedOf(const Orders& n, Floats a, Floats b) {
  const size_t in_a = n.a * n.a, in_b = n.b * n.b, in_out = n.out * n.out, count = a.size() / in_a;
  Floats out(count * in_out);
  for (size_t i = 0; i < count; ++i) {
    const InView f = Interleaved(a.data() + i * in_a, in_a);
    const auto op = ProductPrepare(n.a, n.b, n.out, f);
    ProductApply(op.data(), op.size(), 1, 1, Interleaved(b.data() + i * in_b, in_b),
                 Interleaved(out.data() + i * in_out, in_out));
  }
  return out;
}

// Largest error of a coefficient, relative to the norms of both factors, of any item.
double WorstError(const Orders& n, const Floats& a, const Floats& b, const Floats& out,
                  std::vector<double>* each = nullptr) {
  const size_t count = a.size() / (n.a * n.a);
  double worst = 0.0;
  std::vector<double> exact;
  for (size_t i = 0; i < count; ++i) {
    const double norms =
        Norm(a.data() + i * n.a * n.a, n.a * n.a) * Norm(b.data() + i * n.b * n.b, n.b * n.b);
    double largest = 0.0;
    for (const double e : ErrorOf(n, a, b, out, i, &exact)) {
      largest = std::max(largest, std::abs(e));
    }
    if (each != nullptr) each->push_back(largest / norms);
    worst = std::max(worst, largest / norms);
  }
  return worst;
}

// Items whose bands shrink by 1 / (l+1)^2, as those of light do.
Floats DecayingItems(Random& random, uint32_t n, size_t count) {
  Floats items = RandomItems(random, count * n * n);
  for (size_t p = 0; p < items.size(); ++p) {
    const float l = std::floor(std::sqrt(static_cast<float>(p % (n * n))));
    items[p] /= (l + 1.0f) * (l + 1.0f);
  }
  return items;
}

// Deltas, all of whose bands add up in one direction.
Floats Lobe(uint32_t n, const float* direction) {
  const double d[3] = {direction[0], direction[1], direction[2]};
  std::vector<double> y(n * n);
  basis::EvalReference(static_cast<int>(n), d, y.data());
  return {y.begin(), y.end()};
}

class ProductAccuracy : public TargetTest {};

TEST_P(ProductAccuracy, IsGoodInTheMean) {
  Random random(6);
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    const size_t count = n <= 6 ? 3000 : 400;
    for (const bool decays : {false, true}) {
      const Floats a =
          decays ? DecayingItems(random, n, count) : RandomItems(random, count * n * n);
      const Floats b =
          decays ? DecayingItems(random, n, count) : RandomItems(random, count * n * n);
      const Orders orders = {n, n, n};
      const double error = MeanError(orders, a, b, ProductOf(orders, a, b));
      const double square = MeanError(orders, a, a, SquareOf(n, n, a));
      const Floats few_a(a.begin(), a.begin() + 200 * n * n),
          few_b(b.begin(), b.begin() + 200 * n * n);
      const double prepared = MeanError(orders, few_a, few_b, PreparedOf(orders, few_a, few_b));
      const double naive = MeanError(orders, a, b, NaiveProduct(n, a, b));
      EXPECT_LE(error, MeanTolerance(n)) << "order " << n;
      EXPECT_LE(square, MeanTolerance(n)) << "order " << n;
      EXPECT_LE(prepared, MeanTolerance(n)) << "order " << n;
      EXPECT_LE(error, 1.2 * naive) << "order " << n;
      const std::string name = "n" + std::to_string(n) + (decays ? "_decaying" : "_flat");
      RecordProperty(name, std::to_string(1e9 * error) + " square " + std::to_string(1e9 * square) +
                               " prepared " + std::to_string(1e9 * prepared) + " naive " +
                               std::to_string(1e9 * naive));
    }
  }
}

// Signs and sizes of coefficients are changed as long as the error grows.
TEST_P(ProductAccuracy, HoldsAgainstASearch) {
  const std::vector<Orders> orders = {{2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5},    {6, 6, 6},
                                      {7, 7, 7}, {8, 8, 8}, {9, 9, 9}, {10, 10, 10}, {6, 6, 3},
                                      {2, 6, 6}, {6, 3, 6}, {6, 6, 11}};
  for (const Orders& n : orders) {
    const size_t in_a = n.a * n.a, in_b = n.b * n.b;
    Random random(n.a + 20 * n.b + 400 * n.out);
    double worst = 0.0;
    for (int start = 0; start < 3; ++start) {
      float direction[3] = {0.0f, 0.0f, 1.0f};
      if (start == 1) random.Direction(direction);
      Floats a = start < 2 ? Lobe(n.a, direction) : Floats(in_a);
      Floats b = start < 2 ? Lobe(n.b, direction) : Floats(in_b);
      if (start == 2) {
        for (float& x : a) x = random.Uniform() < 0.5 ? -1.0f : 1.0f;
        for (float& x : b) x = random.Uniform() < 0.5 ? -1.0f : 1.0f;
      }
      double best = 0.0;
      const size_t changes = 32, steps = 3000 / (n.out * n.out);
      for (size_t step = 0; step < steps; ++step) {
        Floats many_a, many_b;
        for (size_t change = 0; change < changes; ++change) {
          Floats next_a = a, next_b = b;
          for (int edit = 0; edit < 3 && change != 0; ++edit) {
            const bool first = random.Uniform() < 0.5;
            Floats& item = first ? next_a : next_b;
            float& x = item[random.Bits() % item.size()];
            x = random.Uniform() < 0.3 ? -x : x * random.Between(0.5, 1.5);
          }
          many_a.insert(many_a.end(), next_a.begin(), next_a.end());
          many_b.insert(many_b.end(), next_b.begin(), next_b.end());
        }
        std::vector<double> errors;
        WorstError(n, many_a, many_b, ProductOf(n, many_a, many_b), &errors);
        const auto largest = std::max_element(errors.begin(), errors.end());
        best = std::max(best, *largest);
        const auto change = largest - errors.begin();
        const auto slice = [&](const Floats& items, size_t size) {
          const auto from = items.begin() + change * static_cast<ptrdiff_t>(size);
          return Floats(from, from + static_cast<ptrdiff_t>(size));
        };
        a = slice(many_a, in_a);
        b = slice(many_b, in_b);
      }
      worst = std::max(worst, best);
    }
    EXPECT_LE(worst, ProductTolerance(n.a, n.b)) << Name(n);
    RecordProperty("n" + Name(n), std::to_string(1e9 * worst));
  }
}

// One coefficient above all others: sums whose terms each lose half a last place, all the same way.
TEST_P(ProductAccuracy, HoldsWhereOneTermIsLarge) {
  for (uint32_t n_a = 1; n_a <= kMaxOrder; ++n_a) {
    for (uint32_t n_b = 1; n_b <= kMaxOrder; ++n_b) {
      for (uint32_t n_out = 1; n_out < n_a + n_b; n_out += n_out < 6 ? 1 : 3) {
        const Orders n = {n_a, n_b, n_out};
        for (size_t large = 0; large < 2; ++large) {
          Floats a(n_a * n_a, 0x1p-12f), b(n_b * n_b, 0x1p-12f);
          a[large % a.size()] = b[large % b.size()] = 1.0f;
          EXPECT_LE(WorstError(n, a, b, ProductOf(n, a, b)), ProductTolerance(n_a, n_b)) << Name(n);
          EXPECT_LE(WorstError(n, a, b, PreparedOf(n, a, b)), ProductTolerance(n_a, n_b))
              << Name(n);
          if (n_a == n_b) {
            EXPECT_LE(WorstError(n, a, a, SquareOf(n_a, n_out, a)), ProductTolerance(n_a, n_a))
                << Name(n);
          }
        }
      }
    }
  }
}

// Bands of very different sizes, and factors whose product loses its low bands or almost all.
TEST_P(ProductAccuracy, HoldsWhereSizesDifferAndTermsCancel) {
  constexpr size_t kCount = 50;
  Random random(9);
  for (uint32_t n = 2; n <= kMaxOrder; ++n) {
    const Orders orders = {n, n, n};
    const size_t coefficients = n * n;
    const auto band = [&](size_t p) {
      return std::floor(std::sqrt(static_cast<double>(p % coefficients))) / (n - 1.0);
    };
    Floats a = RandomItems(random, kCount * coefficients),
           b = RandomItems(random, kCount * coefficients);
    const auto expect = [&](const char* what, const Floats& x, const Floats& y) {
      const double worst = WorstError(orders, x, y, ProductOf(orders, x, y));
      EXPECT_LE(worst, ProductTolerance(n, n)) << what << ", order " << n;
    };
    // 1e6 from the first band to the last.
    Floats falling = a, rising = b;
    for (size_t p = 0; p < a.size(); ++p) {
      falling[p] *= static_cast<float>(std::pow(1e-6, band(p)));
      rising[p] *= static_cast<float>(std::pow(1e-6, 1.0 - band(p)));
    }
    expect("falling", falling, falling);
    expect("rising", rising, rising);
    expect("falling and rising", falling, rising);
    // (1 + e f) (1 - e f) = 1 - e^2 f^2: band by band, the terms of first order cancel.
    for (const float e : {1e-1f, 1e-3f, 1e-5f}) {
      Floats plus = a, minus = a;
      for (size_t p = 0; p < a.size(); ++p) {
        const float constant = p % coefficients == 0 ? 3.5449077f : 0.0f;
        plus[p] = constant + e * a[p];
        minus[p] = constant - e * a[p];
      }
      expect("1 + e and 1 - e", plus, minus);
    }
    // Lobes apart: functions whose product is small everywhere, of large parts that cancel.
    Floats lobes_a, lobes_b;
    for (size_t i = 0; i < kCount; ++i) {
      float d[3];
      random.Direction(d);
      const Floats lobe = Lobe(n, d);
      for (float& x : d) x = -x;
      const Floats opposite = Lobe(n, d);
      lobes_a.insert(lobes_a.end(), lobe.begin(), lobe.end());
      lobes_b.insert(lobes_b.end(), opposite.begin(), opposite.end());
    }
    expect("lobes apart", lobes_a, lobes_b);
    expect("lobes together", lobes_a, lobes_a);
    // The last bands alone, whose product has its energy in the bands that are cut off.
    Floats last_a = a, last_b = b;
    for (size_t p = 0; p < a.size(); ++p) {
      if (band(p) < 1.0) last_a[p] = last_b[p] = 0.0f;
    }
    expect("last bands", last_a, last_b);
  }
}

// Powers of two scale the result and nothing else, as far as gaunt.h says.
TEST_P(ProductAccuracy, ScalesWithItsFactors) {
  constexpr size_t kCount = 20;
  Random random(15);
  const std::vector<Orders> mixed = {{6, 6, 3}, {2, 6, 6}, {6, 3, 6}, {6, 6, 11}, {7, 3, 5}};
  std::vector<Orders> orders = mixed;
  for (uint32_t n = 1; n <= kMaxOrder; ++n) orders.push_back({n, n, n});
  for (const Orders& n : orders) {
    const Floats a = RandomItems(random, kCount * n.a * n.a),
                 b = RandomItems(random, kCount * n.b * n.b);
    const Floats one = ProductOf(n, a, b);
    const auto scaled = [](Floats items, double by) {
      for (float& x : items) x *= static_cast<float>(by);
      return items;
    };
    // 1.2e18 and 8.7e-19.
    EXPECT_EQ(ProductOf(n, scaled(a, 0x1p60), scaled(b, 0x1p-60)), one) << Name(n);
    EXPECT_EQ(ProductOf(n, scaled(a, 0x1p-60), scaled(b, 0x1p60)), one) << Name(n);
    // Norms whose product is some 1e34, as high as gaunt.h has it.
    EXPECT_EQ(ProductOf(n, scaled(a, 0x1p54), scaled(b, 0x1p54)), scaled(one, 0x1p108)) << Name(n);
    EXPECT_EQ(ProductOf(n, scaled(a, 0x1p116), scaled(b, 0x1p-8)), scaled(one, 0x1p108)) << Name(n);
    if (n.a == n.b) {
      EXPECT_EQ(SquareOf(n.a, n.out, scaled(a, 0x1p54)), scaled(SquareOf(n.a, n.out, a), 0x1p108))
          << Name(n);
    }
    // Here some of it is below the normal floats: 5e-45 a step.
    const Floats tiny = ProductOf(n, scaled(a, 0x1p-60), scaled(b, 0x1p-60));
    const double norms = Norm(a) * Norm(b);
    for (size_t k = 0; k < tiny.size(); ++k) {
      ASSERT_NEAR(tiny[k] * 0x1p120, one[k], 1e-6 * norms) << Name(n);
    }
  }
}

GAUNT_INSTANTIATE_TARGETS(ProductAccuracy);

}  // namespace
}  // namespace gaunt::test
