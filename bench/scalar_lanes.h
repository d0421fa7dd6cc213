// SPDX-License-Identifier: MIT
// One lane in plain C++: the kernels' arithmetic as a scalar loop, for comparison.
#ifndef GAUNT_BENCH_SCALAR_LANES_H_
#define GAUNT_BENCH_SCALAR_LANES_H_

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gaunt::bench {

struct Scalar {
  float value;
};
inline Scalar Mul(Scalar a, Scalar b) { return {a.value * b.value}; }
inline Scalar Add(Scalar a, Scalar b) { return {a.value + b.value}; }
inline Scalar Sub(Scalar a, Scalar b) { return {a.value - b.value}; }
inline Scalar Neg(Scalar a) { return {-a.value}; }
inline Scalar MulAdd(Scalar a, Scalar b, Scalar c) { return {a.value * b.value + c.value}; }
inline Scalar MulSub(Scalar a, Scalar b, Scalar c) { return {a.value * b.value - c.value}; }
inline Scalar NegMulAdd(Scalar a, Scalar b, Scalar c) { return {c.value - a.value * b.value}; }
inline Scalar Div(Scalar a, Scalar b) { return {a.value / b.value}; }
inline Scalar Sqrt(Scalar a) { return {std::sqrt(a.value)}; }
inline Scalar Abs(Scalar a) { return {std::abs(a.value)}; }
inline Scalar Max(Scalar a, Scalar b) { return {a.value > b.value ? a.value : b.value}; }
inline Scalar And(Scalar a, Scalar b) {
  uint32_t x, y;
  std::memcpy(&x, &a.value, sizeof(x));
  std::memcpy(&y, &b.value, sizeof(y));
  x &= y;
  std::memcpy(&a.value, &x, sizeof(x));
  return a;
}
inline Scalar TwiceReciprocalOfPower(Scalar a) {
  uint32_t bits;
  std::memcpy(&bits, &a.value, sizeof(bits));
  bits = 0x7F800000u - bits;
  std::memcpy(&a.value, &bits, sizeof(bits));
  return a;
}
inline bool Lt(Scalar a, Scalar b) { return a.value < b.value; }
inline bool Gt(Scalar a, Scalar b) { return a.value > b.value; }
inline Scalar IfThenElse(bool which, Scalar a, Scalar b) { return which ? a : b; }
inline Scalar IfThenZeroElse(bool which, Scalar a) { return which ? Scalar{0.0f} : a; }

struct ScalarIn {
  const float* item;
  ScalarIn From(size_t p) const { return {item + p}; }
  Scalar operator()(size_t p) const { return {item[p]}; }
};
struct ScalarOut {
  float* item;
  ScalarOut From(size_t p) const { return {item + p}; }
  void operator()(size_t p, Scalar v) const { item[p] = v.value; }
};

struct ScalarLanes {
  using V = Scalar;
  Scalar operator()(double c) const { return {static_cast<float>(c)}; }
  ScalarIn Floats(const void* data) const { return {static_cast<const float*>(data)}; }

  template <int kCount>
  struct Slots {
    Scalar slot[kCount];
    Scalar operator()(size_t p) const { return slot[p]; }
    void operator()(size_t p, Scalar v) { slot[p] = v; }
  };
};

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_SCALAR_LANES_H_
