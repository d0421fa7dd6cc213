// SPDX-License-Identifier: MIT
// What the machine can do at most, measured in the same run as the kernels.
#ifndef GAUNT_BENCH_LIMITS_H_
#define GAUNT_BENCH_LIMITS_H_

#include <cstddef>

#include "simd/count.h"

namespace gaunt::bench {

// Nanoseconds per lane, with the chosen target's vectors and enough independent work to fill the
// pipes.
struct ArithmeticLimits {
  double fma;  // multiplications and fused multiply-adds
  double add;
  double div;  // the mean of a division and a square root
};

// Nanoseconds per byte, going over a working set; stores go past the caches where that is faster.
struct MemoryLimits {
  double load;
  double store;
  double copy;  // of a byte that is read and one that is written
};

// Of the chosen target; measured once per target.
const ArithmeticLimits& MeasureArithmetic();
// Of memory of the size of a working set, or up to 1.4 times smaller; measured once per target and
// size.
const MemoryLimits& MeasureMemory(size_t working_set);

// Nanoseconds that an item takes at least: the longest of its multiplications, its additions, its
// divisions and roots, the bytes it reads, the bytes it writes, and those that it reads while it
// writes as many.
double LimitOf(const Operations& operations, size_t bytes_read, size_t bytes_written,
               size_t working_set);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_LIMITS_H_
