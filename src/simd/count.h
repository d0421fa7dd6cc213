// SPDX-License-Identifier: MIT
// Counting lanes: the twin of lanes-inl.h that carries no values and counts what a kernel executes.
// A kernel template run on these yields its operations, so that no count is ever typed in by hand.
#ifndef GAUNT_SIMD_COUNT_H_
#define GAUNT_SIMD_COUNT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gaunt {

struct Operations {
  uint64_t mul = 0;
  uint64_t fma = 0;
  uint64_t add = 0;   // additions and subtractions
  uint64_t div = 0;   // divisions and square roots
  uint64_t load = 0;  // planes read and written through the accessors
  uint64_t store = 0;

  uint64_t Multiplies() const { return mul + fma; }
  uint64_t Ports() const { return mul + fma + add; }
};

inline Operations operator*(uint64_t times, const Operations& o) {
  return {times * o.mul, times * o.fma,  times * o.add,
          times * o.div, times * o.load, times * o.store};
}
inline Operations operator+(const Operations& a, const Operations& b) {
  return {a.mul + b.mul, a.fma + b.fma,   a.add + b.add,
          a.div + b.div, a.load + b.load, a.store + b.store};
}

inline Operations& CountedOperations() {
  static thread_local Operations operations;
  return operations;
}

// Stands for a vector of lanes.
struct Counted {};
// Stands for the result of a comparison, which is neither a multiplication nor an addition.
struct CountedMask {};

inline Counted Mul(Counted, Counted) { return ++CountedOperations().mul, Counted(); }
inline Counted Add(Counted, Counted) { return ++CountedOperations().add, Counted(); }
inline Counted Sub(Counted, Counted) { return ++CountedOperations().add, Counted(); }
inline Counted MulAdd(Counted, Counted, Counted) { return ++CountedOperations().fma, Counted(); }
inline Counted MulSub(Counted, Counted, Counted) { return ++CountedOperations().fma, Counted(); }
inline Counted NegMulAdd(Counted, Counted, Counted) { return ++CountedOperations().fma, Counted(); }
inline Counted Div(Counted, Counted) { return ++CountedOperations().div, Counted(); }
inline Counted Sqrt(Counted) { return ++CountedOperations().div, Counted(); }
inline Counted Neg(Counted) { return {}; }
inline Counted Abs(Counted) { return {}; }
inline Counted And(Counted, Counted) { return {}; }
inline Counted TwiceReciprocalOfPower(Counted) { return {}; }
inline Counted Exponent(Counted) { return {}; }
inline Counted TimesPowerOfTwo(Counted, Counted) { return {}; }
inline Counted Min(Counted, Counted) { return {}; }
inline Counted Max(Counted, Counted) { return {}; }
inline CountedMask Lt(Counted, Counted) { return {}; }
inline CountedMask Gt(Counted, Counted) { return {}; }
inline CountedMask And(CountedMask, CountedMask) { return {}; }
inline Counted IfThenElse(CountedMask, Counted, Counted) { return {}; }
inline Counted IfThenElseZero(CountedMask, Counted) { return {}; }
inline Counted IfThenZeroElse(CountedMask, Counted) { return {}; }

struct CountPlanes {
  CountPlanes From(size_t) const { return {}; }
  Counted operator()(size_t) const { return ++CountedOperations().load, Counted(); }
  void operator()(size_t, Counted) const { ++CountedOperations().store; }
  CountPlanes Read() const { return {}; }
  ptrdiff_t Offset(ptrdiff_t) const { return 0; }
  Counted At(ptrdiff_t) const { return ++CountedOperations().load, Counted(); }
  void At(ptrdiff_t, Counted) const { ++CountedOperations().store; }
};

struct CountLanes {
  using V = Counted;
  Counted operator()(double) const { return {}; }
  CountPlanes Floats(const void*) const { return {}; }
  template <int>
  struct Slots {
    Counted operator()(size_t) const { return {}; }
    void operator()(size_t, Counted) const {}
    Slots Planes() const { return {}; }
  };

  template <class In, class Out>
  void WideSum(const In& in, const uint8_t* source, const double*, int n, double constant,
               const Out& out, size_t p) const {
    Counted sum = Mul(Counted(), in(source[0]));
    for (int t = 1; t < n; ++t) sum = MulAdd(Counted(), in(source[t]), sum);
    out(p, constant != 0.0 ? Add(sum, Counted()) : sum);
  }
};

// Runs `kernel` on counting lanes with as many accessors as it takes.
template <typename Kernel, typename... Planes>
Operations CountKernel(const Kernel& kernel, const Planes&... planes) {
  CountedOperations() = Operations();
  kernel(CountLanes(), planes...);
  return CountedOperations();
}

// A row of `gaunt opcount`: what one item costs. Orders read "3", or "6x6->3" where they are mixed.
struct OperationRow {
  std::string op;
  std::string order;
  std::string variant;
  Operations operations;
};
using OperationRows = std::vector<OperationRow>;

// Orders to count where there is a loop for every one.
inline std::vector<int> CountedOrders() {
  return {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 24, 32, 48, 64};
}

// Rows of every family, each from its own <family>_count.cc.
OperationRows AllOperations();

// The row of an operation, for benchmarks; ends the program if there is none.
Operations OperationsOf(const std::string& op, const std::string& order,
                        const std::string& variant);

}  // namespace gaunt

#endif  // GAUNT_SIMD_COUNT_H_
