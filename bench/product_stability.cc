// SPDX-License-Identifier: MIT
#include "bench/product_stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bench/series.h"
#include "gaunt/gaunt.h"
#include "product/methods/methods.h"
#include "product/product_reference.h"
#include "tests/support/random.h"

namespace gaunt::bench {
namespace {

constexpr int kOrder = 6;
constexpr size_t kPlanes = kOrder * kOrder;
constexpr size_t kItems = 256;
constexpr std::array<size_t, 7> kRanges = {1, 10, 100, 1000, 10000, 100000, 1000000};

using Floats = std::vector<float>;
using Exact = std::array<double, kPlanes>;

// Bands of equal coefficients at random, which fall from 1 to 1/range.
Floats MakeFunctions(double range, uint64_t seed) {
  test::Random random(seed);
  Floats functions(kItems * kPlanes);
  for (size_t at = 0; at < functions.size(); ++at) {
    const int band = BandOf(static_cast<int>(at % kPlanes));
    const double size = std::pow(range, -static_cast<double>(band) / (kOrder - 1));
    functions[at] = static_cast<float>(size * (2.0 * random.Uniform() - 1.0));
  }
  return functions;
}

Exact ItemOf(const Floats& functions, size_t item) {
  Exact exact;
  std::copy_n(functions.begin() + static_cast<ptrdiff_t>(item * kPlanes), kPlanes, exact.begin());
  return exact;
}

void ByGrid(Floats& a, Floats& b, Floats& out) {
  gaunt_view view_a, view_b, view_out;
  gaunt_view_interleaved(a.data(), kPlanes, &view_a);
  gaunt_view_interleaved(b.data(), kPlanes, &view_b);
  gaunt_view_interleaved(out.data(), kPlanes, &view_out);
  gaunt_product(kOrder, kOrder, kOrder, 1, kItems, &view_a, &view_b, &view_out);
}

void ByOutput(Floats& a, Floats& b, Floats& out) {
  product::methods::sparse::Kernels().by_output[kOrder](
      kItems, simd::InterleavedIn(a.data(), kPlanes), simd::InterleavedIn(b.data(), kPlanes),
      simd::OutView(simd::InterleavedOut(out.data(), kPlanes)));
}

// Bands from `first` on, in the norm of what they should be; a root of the mean over items.
template <class Multiply>
double Error(const Multiply& multiply, double range, int first) {
  Floats a = MakeFunctions(range, 1), b = MakeFunctions(range, 2), out(kItems * kPlanes);
  multiply(a, b, out);
  double sum = 0.0;
  for (size_t item = 0; item < kItems; ++item) {
    Exact exact;
    product::ProductReference(kOrder, kOrder, kOrder, ItemOf(a, item).data(),
                              ItemOf(b, item).data(), exact.data());
    double error = 0.0, norm = 0.0;
    for (auto i = static_cast<size_t>(NumCoefficients(first)); i < kPlanes; ++i) {
      error += std::pow(out[item * kPlanes + i] - exact[i], 2);
      norm += std::pow(exact[i], 2);
    }
    sum += error / norm;
  }
  return std::sqrt(sum / kItems);
}

template <class Multiply>
void RegisterLines(const std::string& line, const std::string& label, const Multiply& multiply) {
  const auto add = [&](const std::string& measure, const std::string& words, int first) {
    RegisterSeries({"product/stability/" + line + "_" + measure,
                    label + ", " + words,
                    {kRanges.begin(), kRanges.end()},
                    [=] {
                      std::vector<double> errors;
                      for (const size_t range : kRanges) {
                        errors.push_back(Error(multiply, static_cast<double>(range), first));
                      }
                      return errors;
                    }});
  };
  add("norm", "all bands", 0);
  add("last", "last band", kOrder - 1);
}

}  // namespace

void RegisterProductStability() {
  DescribeSeries("product/stability",
                 "stability of products: order " + std::to_string(kOrder) +
                     ", root mean square over " + std::to_string(kItems) +
                     " items of errors relative to the norm of the bands",
                 "size of the first band over that of the last");
  RegisterLines("grid", "grid", ByGrid);
  RegisterLines("by_output", "sparse by output", ByOutput);
}

}  // namespace gaunt::bench
