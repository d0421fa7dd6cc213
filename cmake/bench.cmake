# SPDX-License-Identifier: MIT
# Benchmarks: one program; each family adds its file.
add_executable(gaunt_bench bench/main.cc bench/limits.cc)
gaunt_compile_internal(gaunt_bench)
target_link_libraries(gaunt_bench PRIVATE gaunt_static gaunt_reference gaunt_count
  benchmark::benchmark)
