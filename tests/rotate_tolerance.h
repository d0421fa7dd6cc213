// SPDX-License-Identifier: MIT
// What gaunt.h states of rotation, for coefficients in [-1, 1].
#ifndef GAUNT_TESTS_ROTATE_TOLERANCE_H_
#define GAUNT_TESTS_ROTATE_TOLERANCE_H_

#include <cstdint>

namespace gaunt::test {

constexpr double RotateTolerance(uint32_t n) { return n <= 6 ? 2e-6 : 3e-7 * n; }
// One quaternion for 256 items or more.
constexpr double RotateOneTolerance(uint32_t n) { return n <= 6 ? 5e-7 : 1.2e-6; }

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_ROTATE_TOLERANCE_H_
