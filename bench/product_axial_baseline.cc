// SPDX-License-Identifier: MIT
#include "bench/product_axial_baseline.h"

#include <cstdlib>
#include <vector>

#include "product/axial_constants.h"
#include "product/tensor.h"

namespace gaunt::bench {
namespace {

constexpr int kOrder = 6;
constexpr size_t kPlanes = kOrder * kOrder;

struct Term {
  int zonal, in, out;  // planes
  float factor;
};

// visit(l, l_out, m, in, out) for the coefficients that a function about z makes of one another.
template <class Visit>
void ForEachPair(const Visit& visit) {
  for (int l = 0; l < kOrder; ++l) {
    for (int l_out = 0; l_out < kOrder; ++l_out) {
      for (int m = -l; m <= l; ++m) {
        if (std::abs(m) <= l_out) visit(l, l_out, m, l * (l + 1) + m, l_out * (l_out + 1) + m);
      }
    }
  }
}

std::vector<Term> ZonalTerms() {
  std::vector<Term> terms;
  ForEachPair([&](int l, int l_out, int m, int in, int out) {
    for (int band = 0; band < kOrder; ++band) {
      const double factor = product::Gaunt(band, 0, l, m, l_out, m);
      if (factor != 0.0) terms.push_back({band, in, out, static_cast<float>(factor)});
    }
  });
  return terms;
}

std::vector<Term> HemisphereTerms() {
  std::vector<Term> terms;
  ForEachPair([&](int l, int l_out, int m, int in, int out) {
    const double factor = product::axial::Hemisphere::Entry(l, l_out, std::abs(m));
    if (factor != 0.0) terms.push_back({0, in, out, static_cast<float>(factor)});
  });
  return terms;
}

}  // namespace

void ZonalSparse(size_t count, const float* zonal, const float* b, float* out) {
  static const std::vector<Term> terms = ZonalTerms();
  for (size_t i = 0; i < count; ++i, zonal += kOrder, b += kPlanes, out += kPlanes) {
    float sums[kPlanes] = {};
    for (const Term& t : terms) sums[t.out] += t.factor * zonal[t.zonal] * b[t.in];
    for (size_t p = 0; p < kPlanes; ++p) out[p] = sums[p];
  }
}

void HemisphereSparse(size_t count, const float* in, float* out) {
  static const std::vector<Term> terms = HemisphereTerms();
  for (size_t i = 0; i < count; ++i, in += kPlanes, out += kPlanes) {
    float sums[kPlanes] = {};
    for (const Term& t : terms) sums[t.out] += t.factor * in[t.in];
    for (size_t p = 0; p < kPlanes; ++p) out[p] = sums[p];
  }
}

}  // namespace gaunt::bench
