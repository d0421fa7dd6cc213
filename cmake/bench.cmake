# SPDX-License-Identifier: MIT
# Benchmarks: one program; each family adds its file.
add_executable(gaunt_bench bench/main.cc bench/limits.cc bench/support.cc bench/planes.cc
  bench/accuracy.cc bench/series.cc bench/rotate_drift.cc bench/product_stability.cc)
gaunt_compile_internal(gaunt_bench)
target_include_directories(gaunt_bench PRIVATE ${PROJECT_BINARY_DIR}/generated tools/gaunt)
target_link_libraries(gaunt_bench PRIVATE gaunt_static gaunt_reference gaunt_count
  gaunt_frame_baseline benchmark::benchmark)

# Scalar loops as a user's compiler makes them.
add_library(gaunt_scalar_baselines OBJECT
  bench/ambient_cube_baseline.cc bench/basis_baseline.cc bench/evaluate_baseline.cc
  bench/grid_baseline.cc bench/project_baseline.cc bench/product_axial_baseline.cc
  bench/product_baseline.cc bench/rotate_baseline.cc bench/tetra_baseline.cc
  bench/zh3_baseline.cc bench/zonal_baseline.cc)
target_include_directories(gaunt_scalar_baselines PRIVATE ${PROJECT_SOURCE_DIR} src include)
target_link_libraries(gaunt_scalar_baselines PRIVATE hwy::hwy gaunt_warnings)
target_link_libraries(gaunt_bench PRIVATE gaunt_scalar_baselines)

# The frame's scalar loops once more, by the best compiler for them and for this very CPU.
find_program(CLANGXX NAMES clang++ clang++-19 clang++-16 clang++-14)
if(CLANGXX)
  set(native ${PROJECT_BINARY_DIR}/frame_baseline_clang_native.o)
  add_custom_command(OUTPUT ${native}
    COMMAND ${CLANGXX} -std=c++17 -O3 -march=native -I${PROJECT_SOURCE_DIR}
      -DGAUNT_BASELINE_NAMESPACE=baseline_clang_native
      -c ${PROJECT_SOURCE_DIR}/bench/frame_baseline.cc -o ${native}
    DEPENDS bench/frame_baseline.cc bench/frame_baseline.h VERBATIM)
  target_sources(gaunt_bench PRIVATE ${native})
  set_source_files_properties(${native} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  target_compile_definitions(gaunt_bench PRIVATE GAUNT_HAVE_CLANG_NATIVE)
endif()
target_sources(gaunt_bench PRIVATE tools/gaunt/frame/job.cc)
