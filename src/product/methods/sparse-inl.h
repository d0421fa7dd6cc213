// SPDX-License-Identifier: MIT
// Products by the Gaunt coefficients themselves, as straight code.
#if defined(GAUNT_PRODUCT_METHODS_SPARSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_METHODS_SPARSE_INL_H_
#undef GAUNT_PRODUCT_METHODS_SPARSE_INL_H_
#else
#define GAUNT_PRODUCT_METHODS_SPARSE_INL_H_
#endif

#include <utility>

#include "product/methods/sparse_plan.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::methods::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Both factors, which are read often, in slots. Outputs are not in place.
template <int n, class K>
struct Factors {
  static constexpr int kSize = NumCoefficients(n);
  typename K::template Slots<kSize> f, g;

  template <class A, class B>
  GAUNT_LANES Factors(const A& a, const B& b) {
    Copy(a, b, std::make_integer_sequence<int, kSize>());
  }

  // f_i g_j + f_j g_i, or f_i g_i.
  template <int i, int j>
  GAUNT_LANES typename K::V Product() const {
    if constexpr (i == j) {
      return Mul(f(i), g(i));
    } else {
      return MulAdd(f(i), g(j), Mul(f(j), g(i)));
    }
  }

 private:
  template <class A, class B, int... i>
  GAUNT_LANES void Copy(const A& a, const B& b, std::integer_sequence<int, i...>) {
    ((f(i, a(i)), g(i, b(i))), ...);
  }
};

// By a plan for order n.
template <int n, class Plan, const Plan& kPlan>
class Sparse {
  static constexpr int kSize = NumCoefficients(n);

  template <class K>
  using Sums = typename K::template Slots<kSize>;

 public:
  template <class K, class A, class B, class Out>
  GAUNT_LANES void operator()(const K& k, const A& a, const B& b, const Out& out) const {
    const Factors<n, K> factors(a, b);
    Sums<K> sums;
    All<0, kPlan.pairs()>(k, factors, sums);
    Put(sums, out, std::make_integer_sequence<int, kSize>());
  }

 private:
  // In halves: compilers limit how deep templates nest, and how many terms are folded.
  template <int first, int count, class K>
  static GAUNT_LANES void All(const K& k, const Factors<n, K>& factors, Sums<K>& sums) {
    if constexpr (count == 1) {
      One<first>(k, factors, sums,
                 std::make_integer_sequence<int, kPlan.PairOf(first).completions>());
    } else {
      All<first, count / 2>(k, factors, sums);
      All<first + count / 2, count - count / 2>(k, factors, sums);
    }
  }
  template <class S, class Out, int... i>
  static GAUNT_LANES void Put(const S& sums, const Out& out, std::integer_sequence<int, i...>) {
    (out(i, sums(i)), ...);
  }

  template <int p, class K, int... c>
  static GAUNT_LANES void One(const K& k, const Factors<n, K>& factors, Sums<K>& sums,
                              std::integer_sequence<int, c...>) {
    using V = typename K::V;
    constexpr Pair kPair = kPlan.PairOf(p);
    const V product = factors.template Product<kPair.i, kPair.j>();
    (Complete<p, c>(k, product, sums), ...);
    if constexpr (HasFactors(p)) {
      constexpr int kLast = kPair.completions - 1;
      const V f = Factor<p, kLast>(k, factors.f), g = Factor<p, kLast>(k, factors.g);
      Add2<kPair.i, kPair.is_first_i>(f, factors.g(kPair.j), g, factors.f(kPair.j), sums);
      if constexpr (kPair.i != kPair.j) {
        Add2<kPair.j, kPair.is_first_j>(f, factors.g(kPair.i), g, factors.f(kPair.i), sums);
      }
    }
  }

  static constexpr bool HasFactors(int p) {
    if constexpr (Plan::kFactors) {
      return kPlan.HasFactors(p);
    } else {
      return false;
    }
  }

  template <int p, int c, class K, class S>
  static GAUNT_LANES void Complete(const K& k, typename K::V product, S& sums) {
    constexpr Completion kCompletion = kPlan.CompletionOf(p, c);
    constexpr int kOutput = kCompletion.k;
    if constexpr (kCompletion.is_first) {
      sums(kOutput, Mul(k(kCompletion.factor), product));
    } else {
      sums(kOutput, MulAdd(k(kCompletion.factor), product, sums(kOutput)));
    }
  }

  // The sum over completions up to c of factor times coefficient.
  template <int p, int c, class K, class S>
  static GAUNT_LANES typename K::V Factor(const K& k, const S& coefficients) {
    constexpr Completion kCompletion = kPlan.CompletionOf(p, c);
    if constexpr (kPlan.IsCube(p, c)) {
      return Factor<p, c - 1>(k, coefficients);
    } else if constexpr (c == kPlan.FirstFactor(p)) {
      return Mul(k(kCompletion.factor), coefficients(kCompletion.k));
    } else {
      return MulAdd(k(kCompletion.factor), coefficients(kCompletion.k),
                    Factor<p, c - 1>(k, coefficients));
    }
  }

  template <int output, bool is_first, class V, class S>
  static GAUNT_LANES void Add2(V a, V b, V c, V d, S& sums) {
    if constexpr (is_first) {
      sums(output, MulAdd(a, b, Mul(c, d)));
    } else {
      sums(output, MulAdd(a, b, MulAdd(c, d, sums(output))));
    }
  }
};

template <int n>
using ByOutput = Sparse<n, OutputPlan<n>, kOutputPlan<n>>;
template <int n>
using ByPairs = Sparse<n, PairPlan<n>, kPairPlan<n>>;

}  // namespace gaunt::product::methods::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_METHODS_SPARSE_INL_H_
