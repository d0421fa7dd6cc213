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
  # At test time: an emulated CPU decides which targets there are.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
endfunction()

gaunt_test(base_test tests/base_test.cc)
gaunt_test(points_test tests/points_test.cc)
target_link_libraries(points_test PRIVATE gaunt_points)

# The C API through the shared library, from C99.
add_executable(capi_abi_test tests/capi_abi_test.c)
set_target_properties(capi_abi_test PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF)
target_compile_options(capi_abi_test PRIVATE -Wall -Wextra -pedantic-errors)
target_link_libraries(capi_abi_test PRIVATE gaunt)
add_test(NAME Capi.Abi COMMAND capi_abi_test)

find_program(READELF readelf)
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_NM AND READELF)
  add_test(NAME Capi.Exports COMMAND ${CMAKE_COMMAND}
    -DNM=${CMAKE_NM} -DREADELF=${READELF} -DLIBRARY=$<TARGET_FILE:gaunt>
    -DEXPORTS=${PROJECT_SOURCE_DIR}/capi/exports.txt
    -P ${PROJECT_SOURCE_DIR}/tests/exports_test.cmake)
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    # Code that is unrolled too far fills the instruction cache.
    add_test(NAME Sizes COMMAND ${PROJECT_SOURCE_DIR}/tools/sizes.sh $<TARGET_FILE:gaunt_static>
      product 640)
  endif()
endif()

# Examples, as a user compiles them.
add_executable(hello examples/hello.c)
target_link_libraries(hello PRIVATE gaunt)
add_test(NAME Examples.Hello COMMAND hello)
add_executable(frame_example examples/frame.cpp)
target_link_libraries(frame_example PRIVATE gaunt)
add_test(NAME Examples.Frame COMMAND frame_example)
add_test(NAME Examples.Readme COMMAND ${CMAKE_COMMAND} -DREADME=${PROJECT_SOURCE_DIR}/README.md
  -DEXAMPLE=${PROJECT_SOURCE_DIR}/examples/hello.c
  -DFRAME=${PROJECT_SOURCE_DIR}/examples/frame.cpp
  -DTABLE=${PROJECT_SOURCE_DIR}/bench/results/table.sh
  -DRESULTS=${PROJECT_SOURCE_DIR}/bench/results/epyc-zen4/gcc12.json
  -P ${PROJECT_SOURCE_DIR}/tests/readme_test.cmake)

# The command, real images, and the installed package, where they are built.
if(GAUNT_TOOLS)
  gaunt_test(splats_test tests/splats_test.cc)
  target_link_libraries(splats_test PRIVATE gaunt_splats)
  gaunt_test(volume_test tests/volume_test.cc)
  target_link_libraries(volume_test PRIVATE gaunt_volume)
  # In one process: it reads the images once.
  add_executable(panorama_test tests/panorama_test.cc tests/support/panorama.cc)
  gaunt_compile_internal(panorama_test)
  target_link_libraries(panorama_test PRIVATE gaunt_test_support gaunt_formats OpenImageIO::OpenImageIO)
  add_test(NAME Panorama COMMAND panorama_test)
  gaunt_test(chart_test tests/chart_test.cc)
  target_link_libraries(chart_test PRIVATE gaunt_chart)
  add_test(NAME Command COMMAND ${PROJECT_SOURCE_DIR}/tests/command_test.sh
    $<TARGET_FILE:gaunt_command>)
  if(PROJECT_IS_TOP_LEVEL)
    add_test(NAME Install COMMAND ${PROJECT_SOURCE_DIR}/tests/install_test.sh
      ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
  endif()
endif()
if(GAUNT_BENCH)
  # One short pass of each benchmark of the best target: they still run.
  add_test(NAME Bench COMMAND gaunt_bench --benchmark_min_time=0.001
    --benchmark_filter=/1000/|frame/2000_objects_2048)
endif()

include(cmake/shader_test.cmake)
