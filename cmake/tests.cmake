# SPDX-License-Identifier: MIT
# Tests: one program per family, each of which runs every SIMD target that the machine has.
include(GoogleTest)

add_library(gaunt_test_support STATIC
  tests/support/buffer.cc tests/support/golden.cc tests/support/operation.cc)
gaunt_compile_internal(gaunt_test_support)
target_link_libraries(gaunt_test_support PUBLIC gaunt_static gaunt_reference gaunt_count GTest::gtest
  GTest::gtest_main)
target_compile_definitions(gaunt_test_support PUBLIC
  GAUNT_GOLDEN_DIR="${PROJECT_SOURCE_DIR}/tests/golden")

function(gaunt_test name)
  add_executable(${name} ${ARGN})
  gaunt_compile_internal(${name})
  target_link_libraries(${name} PRIVATE gaunt_test_support)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60)
endfunction()
