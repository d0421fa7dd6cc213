// SPDX-License-Identifier: MIT
// Tests that run once per SIMD target of this machine: Suite.Test/AVX2 and so on.
#ifndef GAUNT_TESTS_SUPPORT_TARGETS_H_
#define GAUNT_TESTS_SUPPORT_TARGETS_H_

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::test {

inline std::vector<std::string> SupportedTargets() {
  std::vector<std::string> targets;
  for (uint32_t i = 0; gaunt_target_supported(i) != nullptr; ++i) {
    targets.push_back(gaunt_target_supported(i));
  }
  return targets;
}

// Targets with fused multiply-add give equal bits; so do the others.
inline bool HasFma(const std::string& target) {
  return target.rfind("AVX", 0) == 0 || target.rfind("NEON", 0) == 0 || target.rfind("SVE", 0) == 0;
}

class TargetTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    ASSERT_EQ(gaunt_target_select(GetParam().c_str()), GAUNT_OK);
    ASSERT_EQ(gaunt_target_name(), GetParam());
  }
  void TearDown() override { gaunt_target_select(nullptr); }
};

#define GAUNT_INSTANTIATE_TARGETS(Suite)                                                  \
  INSTANTIATE_TEST_SUITE_P(, Suite, testing::ValuesIn(::gaunt::test::SupportedTargets()), \
                           [](const auto& target) { return target.param; })

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_TARGETS_H_
