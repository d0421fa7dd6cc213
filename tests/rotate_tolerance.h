// SPDX-License-Identifier: MIT
// What gaunt.h states of rotation, for coefficients in [-1, 1].
#ifndef GAUNT_TESTS_ROTATE_TOLERANCE_H_
#define GAUNT_TESTS_ROTATE_TOLERANCE_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::test {

constexpr double RotateTolerance(uint32_t n) { return n <= 6 ? 2.5e-6 : 4.5e-7 * n; }
// One quaternion for all of as many items as have a plan.
constexpr double RotateOneTolerance(uint32_t n) { return n <= 6 ? 8e-7 : 2e-6; }
constexpr size_t LeastPlannedItems(uint32_t n) { return n <= 3 ? 512 : 256; }

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_ROTATE_TOLERANCE_H_
