// SPDX-License-Identifier: MIT
// Tables of 20-digit values in tests/golden.
#ifndef GAUNT_TESTS_SUPPORT_GOLDEN_H_
#define GAUNT_TESTS_SUPPORT_GOLDEN_H_

#include <string>
#include <vector>

namespace gaunt::test {

// Cells of a comma-separated file, without its header line. Ends the program if it is missing.
std::vector<std::vector<std::string>> ReadGolden(const std::string& file);

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_GOLDEN_H_
