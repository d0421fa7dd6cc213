// SPDX-License-Identifier: MIT
// Products by the Gaunt coefficients themselves: which terms there are, and in what order straight
// code computes them.
#ifndef GAUNT_PRODUCT_METHODS_SPARSE_PLAN_H_
#define GAUNT_PRODUCT_METHODS_SPARSE_PLAN_H_

#include <array>
#include <cstddef>

#include "product/tensor.h"
#include "simd/order.h"

namespace gaunt::product::methods {

constexpr double GauntOf(int i, int j, int k) {
  const int a = BandOf(i), b = BandOf(j), c = BandOf(k);
  return Gaunt(a, i - CoefficientIndex(a, 0), b, j - CoefficientIndex(b, 0), c,
               k - CoefficientIndex(c, 0));
}

// Gaunt coefficients of i <= j <= k below n^2.
template <int n>
class Tensor {
 public:
  static constexpr int kSize = NumCoefficients(n);

  constexpr Tensor() {
    for (int k = 0, at = 0; k < kSize; ++k) {
      for (int j = 0; j <= k; ++j) {
        for (int i = 0; i <= j; ++i, ++at) {
          values_[at] = GauntOf(i, j, k);
          if (values_[at] != 0.0) ++triples_;
        }
      }
    }
  }

  constexpr int triples() const { return triples_; }  // that are not 0

  // visit(i, j, k, value) of those that are not 0.
  template <class Visit>
  constexpr void ForEach(const Visit& visit) const {
    for (int k = 0, at = 0; k < kSize; ++k) {
      for (int j = 0; j <= k; ++j) {
        for (int i = 0; i <= j; ++i, ++at) {
          if (values_[at] != 0.0) visit(i, j, k, values_[at]);
        }
      }
    }
  }

 private:
  double values_[kSize * (kSize + 1) * (kSize + 2) / 6] = {};
  int triples_ = 0;
};
template <int n>
inline constexpr Tensor<n> kTensor;

// A coefficient k that couples to a pair.
struct Completion {
  int k = 0;
  double factor = 0.0;
  bool is_first = false;  // that adds to output k
};

// A pair i <= j, with completions k: t = f_i g_j + f_j g_i, or f_i g_i, and output k += factor t.
struct Pair {
  int i = 0, j = 0, first = 0, completions = 0;
  bool is_first_i = false, is_first_j = false;  // that adds to output i, and to j
};

// Each output is the sum of its terms.
template <int n>
class OutputPlan {
  static constexpr int kSize = NumCoefficients(n);

 public:
  static constexpr bool kFactors = false;

  constexpr OutputPlan() {
    int left[kSize][kSize] = {};
    kTensor<n>.ForEach([&](int i, int j, int k, double) {
      ++left[j][k];
      if (j != k) ++left[i][j];
      if (i != j) ++left[i][k];
    });
    for (int j = 0, first = 0; j < kSize; ++j) {
      for (int i = 0; i <= j; ++i) {
        if (left[i][j] == 0) continue;
        Pair& pair = plan_[pairs_++];
        pair.i = i, pair.j = j, pair.first = first;
        first += left[i][j];
      }
    }
    // Where in the plan a pair is.
    int at[kSize][kSize] = {};
    for (int p = 0; p < pairs_; ++p) at[plan_[p].i][plan_[p].j] = p;
    const auto add = [&](int i, int j, int k, double value) {
      Pair& pair = plan_[at[i][j]];
      completions_[pair.first + pair.completions++] = {k, value, false};
    };
    kTensor<n>.ForEach([&](int i, int j, int k, double value) {
      add(j, k, i, value);
      if (j != k) add(i, j, k, value);
      if (i != j) add(i, k, j, value);
    });
    bool begun[kSize] = {};
    for (Completion& completion : completions_) {
      completion.is_first = !begun[completion.k];
      begun[completion.k] = true;
    }
  }

  constexpr int pairs() const { return pairs_; }
  constexpr Pair PairOf(int p) const { return plan_[p]; }
  constexpr Completion CompletionOf(int p, int c) const { return completions_[plan_[p].first + c]; }

 private:
  int pairs_ = 0;
  Pair plan_[kSize * (kSize + 1) / 2] = {};
  Completion completions_[3 * kTensor<n>.triples()] = {};
};
template <int n>
inline constexpr OutputPlan<n> kOutputPlan;

// Every triple is computed once, for all of its outputs: a pair also adds to its own ones, with f' =
// sum of factor f_k, g' likewise, output i += f' g_j + g' f_j, output j += f' g_i + g' f_i.
// Pair after pair takes all triples that are left and that it is part of, those first which need the
// fewest operations per triple. The counts are those of Snyder, "Code Generation and Factoring for
// Fast Evaluation of Low-order Spherical Harmonic Products and Squares", MSR-TR-2006-53.
template <int n>
class PairPlan {
  static constexpr int kSize = NumCoefficients(n);
  static constexpr int kTriples = kTensor<n>.triples();

 public:
  static constexpr bool kFactors = true;

  constexpr PairPlan() {
    Search search;
    // Taking a pair only lessens what others have left: one pass for each number.
    for (int most = 2 * kSize; most > 0; --most) {
      for (int j = 0; j < kSize; ++j) {
        for (int i = 0; i <= j; ++i) {
          if (search.Worth(i, j) == most) Take(search, i, j);
        }
      }
    }
    bool begun[kSize] = {};
    for (int p = 0; p < pairs_; ++p) {
      Pair& pair = plan_[p];
      for (int c = pair.first; c < pair.first + pair.completions; ++c) {
        completions_[c].is_first = !begun[completions_[c].k];
        begun[completions_[c].k] = true;
      }
      if (!HasFactors(p)) continue;
      pair.is_first_i = !begun[pair.i];
      begun[pair.i] = true;
      pair.is_first_j = !begun[pair.j];
      begun[pair.j] = true;
    }
  }

  constexpr int pairs() const { return pairs_; }
  constexpr Pair PairOf(int p) const { return plan_[p]; }
  constexpr Completion CompletionOf(int p, int c) const { return completions_[plan_[p].first + c]; }
  // Of an output where the pair is one coefficient and so is its completion.
  constexpr bool IsCube(int p, int c) const {
    return plan_[p].i == plan_[p].j && CompletionOf(p, c).k == plan_[p].i;
  }
  // Whether any completion is not of that kind.
  constexpr bool HasFactors(int p) const { return FirstFactor(p) < plan_[p].completions; }
  constexpr int FirstFactor(int p) const {
    int c = 0;
    while (c < plan_[p].completions && IsCube(p, c)) ++c;
    return c;
  }

 private:
  struct Triple {
    int side[3] = {};
    double value = 0.0;
  };

  // Triples that are left, in a list for each pair that they are of.
  struct Search {
    Triple triples[kTriples] = {};
    bool taken[kTriples] = {};
    int left[kSize][kSize] = {};  // of each pair i <= j
    int head[kSize][kSize] = {};
    int next[3 * kTriples] = {};

    constexpr Search() {
      for (auto& row : head) {
        for (int& at : row) at = -1;
      }
      int t = 0;
      kTensor<n>.ForEach([&](int i, int j, int k, double value) {
        triples[t] = {{i, j, k}, value};
        Link(3 * t, j, k);
        if (i != j) Link(3 * t + 1, i, k);
        if (j != k) Link(3 * t + 2, i, j);
        ++t;
      });
    }
    constexpr void Link(int entry, int i, int j) {
      next[entry] = head[i][j];
      head[i][j] = entry;
      ++left[i][j];
    }
    // Twice those of a pair of one coefficient, which needs half of the operations.
    constexpr int Worth(int i, int j) const { return left[i][j] * (i == j ? 2 : 1); }
  };

  constexpr void Take(Search& search, int i, int j) {
    Pair& pair = plan_[pairs_++];
    pair.i = i, pair.j = j, pair.first = next_;
    for (int entry = search.head[i][j]; entry >= 0; entry = search.next[entry]) {
      const int t = entry / 3;
      if (search.taken[t]) continue;
      search.taken[t] = true;
      const int* const side = search.triples[t].side;
      // What is left of the triple without the pair.
      const int k = side[0] + side[1] + side[2] - i - j;
      // One of two equal sides would count twice.
      const bool is_half = i != j && (k == i || k == j);
      completions_[next_++] = {k, search.triples[t].value * (is_half ? 0.5 : 1.0), false};
      --search.left[side[1]][side[2]];
      if (side[0] != side[1]) --search.left[side[0]][side[2]];
      if (side[1] != side[2]) --search.left[side[0]][side[1]];
    }
    pair.completions = next_ - pair.first;
  }

  int pairs_ = 0, next_ = 0;
  Pair plan_[kSize * (kSize + 1) / 2] = {};
  Completion completions_[kTriples] = {};
};
template <int n>
inline constexpr PairPlan<n> kPairPlan;

}  // namespace gaunt::product::methods

#endif  // GAUNT_PRODUCT_METHODS_SPARSE_PLAN_H_
