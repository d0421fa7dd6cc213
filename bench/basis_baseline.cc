// SPDX-License-Identifier: MIT
#include "bench/basis_baseline.h"

#include "basis/basis-inl.h"

namespace gaunt::bench {
namespace {

struct Scalar {
  float value;
};
inline Scalar Mul(Scalar a, Scalar b) { return {a.value * b.value}; }
inline Scalar MulAdd(Scalar a, Scalar b, Scalar c) { return {a.value * b.value + c.value}; }
inline Scalar MulSub(Scalar a, Scalar b, Scalar c) { return {a.value * b.value - c.value}; }

struct ScalarLanes {
  using V = Scalar;
  Scalar operator()(double c) const { return {static_cast<float>(c)}; }
};
struct ScalarIn {
  const float* item;
  Scalar operator()(size_t p) const { return {item[p]}; }
};
struct ScalarOut {
  float* item;
  void operator()(size_t p, Scalar v) const { item[p] = v.value; }
};

template <int n>
void BasisScalar(size_t count, const float* directions, float* out) {
  for (size_t i = 0; i < count; ++i) {
    basis::HWY_NAMESPACE::Eval<n>()(ScalarLanes(), ScalarIn{directions + 3 * i},
                                    ScalarOut{out + n * n * i});
  }
}

}  // namespace

void BasisScalar3(size_t count, const float* directions, float* out) {
  BasisScalar<3>(count, directions, out);
}
void BasisScalar6(size_t count, const float* directions, float* out) {
  BasisScalar<6>(count, directions, out);
}

}  // namespace gaunt::bench
