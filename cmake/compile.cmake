# SPDX-License-Identifier: MIT
# How the project's own code is compiled.

add_library(gaunt_warnings INTERFACE)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(gaunt_warnings INTERFACE -Wall -Wextra -Wshadow -Wno-psabi)
endif()

# Flags that decide about bits. Contraction is off: kernels say themselves where they fuse, so that
# every compiler and every target with fused multiply-add gives the same results.
function(gaunt_compile_numerics target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -ffp-contract=off)
  endif()
  if(GAUNT_ALL_TARGETS)
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ALL_ATTAINABLE)
  endif()
endfunction()

# Objects of the library itself.
function(gaunt_compile_library target)
  gaunt_compile_numerics(${target})
  target_include_directories(${target} PRIVATE
    ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/capi)
  target_link_libraries(${target} PRIVATE hwy::hwy gaunt_warnings)
  target_compile_definitions(${target} PRIVATE GAUNT_BUILDING)
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
  endif()
endfunction()

# Code that sees the library's insides: references, counts, tests, benchmarks, tools.
function(gaunt_compile_internal target)
  gaunt_compile_numerics(${target})
  target_include_directories(${target} PUBLIC
    ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC hwy::hwy PRIVATE gaunt_warnings)
endfunction()
