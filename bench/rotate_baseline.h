// SPDX-License-Identifier: MIT
// Rotation in scalar code, one channel, interleaved items, compiled like a user's code.
#ifndef GAUNT_BENCH_ROTATE_BASELINE_H_
#define GAUNT_BENCH_ROTATE_BASELINE_H_

#include <cstddef>

namespace gaunt::bench {

// Orders that there are baselines of.
inline constexpr int kMinBaselineOrder = 2;
inline constexpr int kMaxBaselineOrder = 8;

using RotateBaseline = void (*)(size_t count, const float* quaternions, const float* in,
                                float* out);

// What engines have: the matrix of each quaternion, Euler angles from its entries, and turns about z
// with constant quarter turns between them, every band written out (Z-X-Z-X-Z).
RotateBaseline Zxzxz(int order);
// What snippets have: the block matrices of each quaternion, by the recurrence of Ivanic and
// Ruedenberg (1996, corrected 1998), and matrix times vector.
RotateBaseline Blocks(int order);
// The same with the block matrices of the first quaternion for all items.
RotateBaseline BlocksOnce(int order);
// The kernel's own arithmetic, one item at a time.
RotateBaseline Factored(int order);

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_ROTATE_BASELINE_H_
