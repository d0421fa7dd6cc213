# SPDX-License-Identifier: MIT
# Dependencies: the system's packages first, FetchContent as the fallback.
include(FetchContent)

set(HWY_ENABLE_TESTS OFF CACHE INTERNAL "")
set(HWY_ENABLE_EXAMPLES OFF CACHE INTERNAL "")
set(HWY_ENABLE_CONTRIB OFF CACHE INTERNAL "")
set(HWY_ENABLE_INSTALL OFF CACHE INTERNAL "")
FetchContent_Declare(hwy
  GIT_REPOSITORY https://github.com/google/highway.git GIT_TAG 1.2.0
  FIND_PACKAGE_ARGS 1.0.3 CONFIG)
FetchContent_MakeAvailable(hwy)
if(TARGET hwy AND NOT TARGET hwy::hwy)
  add_library(hwy::hwy ALIAS hwy)
endif()

if(GAUNT_TESTS)
  FetchContent_Declare(googletest
    GIT_REPOSITORY https://github.com/google/googletest.git GIT_TAG v1.14.0
    FIND_PACKAGE_ARGS NAMES GTest)
  FetchContent_MakeAvailable(googletest)
endif()

if(GAUNT_BENCH)
  set(BENCHMARK_ENABLE_TESTING OFF CACHE INTERNAL "")
  FetchContent_Declare(benchmark
    GIT_REPOSITORY https://github.com/google/benchmark.git GIT_TAG v1.8.3
    FIND_PACKAGE_ARGS CONFIG)
  FetchContent_MakeAvailable(benchmark)
endif()

if(GAUNT_TOOLS)
  FetchContent_Declare(CLI11
    GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git GIT_TAG v2.3.2
    FIND_PACKAGE_ARGS CONFIG)
  FetchContent_Declare(fmt
    GIT_REPOSITORY https://github.com/fmtlib/fmt.git GIT_TAG 9.1.0
    FIND_PACKAGE_ARGS CONFIG)
  FetchContent_Declare(nlohmann_json
    GIT_REPOSITORY https://github.com/nlohmann/json.git GIT_TAG v3.11.2
    FIND_PACKAGE_ARGS CONFIG)
  set(ZLIB_BUILD_EXAMPLES OFF CACHE INTERNAL "")
  FetchContent_Declare(ZLIB
    GIT_REPOSITORY https://github.com/madler/zlib.git GIT_TAG v1.3.1
    FIND_PACKAGE_ARGS)
  FetchContent_MakeAvailable(CLI11 fmt nlohmann_json ZLIB)
  if(TARGET zlibstatic AND NOT TARGET ZLIB::ZLIB)
    # Its targets do not say where its headers are.
    target_include_directories(zlibstatic INTERFACE
      $<BUILD_INTERFACE:${zlib_SOURCE_DIR}> $<BUILD_INTERFACE:${zlib_BINARY_DIR}>)
    add_library(ZLIB::ZLIB ALIAS zlibstatic)
  endif()
  find_package(Threads REQUIRED)
  find_package(OpenImageIO 2.4 CONFIG REQUIRED)
  # Debian's package names a folder of OpenCV that is not there unless OpenCV is installed.
  get_target_property(include_dirs OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
  list(FILTER include_dirs EXCLUDE REGEX "opencv4")
  set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${include_dirs}")
endif()
