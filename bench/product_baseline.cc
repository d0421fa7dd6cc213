// SPDX-License-Identifier: MIT
#include "bench/product_baseline.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "bench/scalar_lanes.h"
#include "product/methods/sparse-inl.h"
#include "product/product.h"

namespace gaunt::bench {
namespace {

namespace kernels = product::methods::HWY_NAMESPACE;

struct Entry {
  int i, j, k;
  float value;
};

std::vector<Entry> MakeEntries(int order) {
  std::vector<Entry> entries;
  const int size = NumCoefficients(order);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < size; ++k) {
        const auto value = static_cast<float>(product::methods::GauntOf(i, j, k));
        if (value != 0.0f) entries.push_back({i, j, k, value});
      }
    }
  }
  return entries;
}

template <int n>
void Loop(size_t count, const float* a, const float* b, float* out) {
  for (size_t i = 0; i < count; ++i) {
    kernels::ByPairs<n>()(ScalarLanes(), ScalarIn{a + n * n * i}, ScalarIn{b + n * n * i},
                          ScalarOut{out + n * n * i});
  }
}

template <int... n>
constexpr auto MakeLoops(std::integer_sequence<int, n...>) {
  return std::array<ProductBaseline, sizeof...(n)>{&Loop<kMinPairsOrder + n>...};
}
constexpr auto kLoops =
    MakeLoops(std::make_integer_sequence<int, kMaxPairsOrder - kMinPairsOrder + 1>());

}  // namespace

void ProductByTable(int order, size_t count, const float* a, const float* b, float* out) {
  static std::array<std::vector<Entry>, product::kMaxOrder + 1> tables;
  std::vector<Entry>& entries = tables.at(static_cast<size_t>(order));
  if (entries.empty()) entries = MakeEntries(order);
  const int size = NumCoefficients(order);
  for (size_t item = 0; item < count; ++item, a += size, b += size, out += size) {
    std::fill(out, out + size, 0.0f);
    for (const Entry& entry : entries) out[entry.k] += entry.value * a[entry.i] * b[entry.j];
  }
}

ProductBaseline ProductByPairs(int order) {
  return kLoops.at(static_cast<size_t>(order - kMinPairsOrder));
}

void ProductByMatrix(int order, const float* matrix, size_t count, const float* in, float* out) {
  const int size = NumCoefficients(order);
  for (size_t item = 0; item < count; ++item, in += size, out += size) {
    for (int i = 0; i < size; ++i) {
      float sum = 0;
      for (int j = 0; j < size; ++j) sum += matrix[i * size + j] * in[j];
      out[i] = sum;
    }
  }
}

}  // namespace gaunt::bench
