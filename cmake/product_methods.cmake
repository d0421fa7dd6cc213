# SPDX-License-Identifier: MIT
# Other ways to make products, for tests and benchmarks only, and the counts of their operations.
add_library(gaunt_product_methods STATIC EXCLUDE_FROM_ALL
  src/product/methods/sparse.cc src/product/methods/levels.cc src/product/methods/dense.cc
  src/product/methods/matrix_of.cc)
gaunt_compile_internal(gaunt_product_methods)
target_link_libraries(gaunt_product_methods PUBLIC gaunt_static)
target_sources(gaunt_count PRIVATE src/product/methods/methods_count.cc)
if(GAUNT_TESTS)
  target_link_libraries(product_test PRIVATE gaunt_product_methods)
endif()
if(GAUNT_BENCH)
  target_link_libraries(gaunt_bench PRIVATE gaunt_product_methods)
endif()

# Their tables are long to compute.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set_source_files_properties(src/product/methods/sparse.cc src/product/methods/methods_count.cc
    bench/product_baseline.cc PROPERTIES COMPILE_OPTIONS -fconstexpr-steps=500000000)
endif()
