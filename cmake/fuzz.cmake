# SPDX-License-Identifier: MIT
# Fuzzers, for clang and with the preset `fuzz`. Each test runs a million inputs, the same ones every time
# with the same compiler; `<name> <folder>` goes on for as long as one likes.
enable_testing()
set(GAUNT_FUZZ_RUNS 1000000 CACHE STRING "Inputs of each fuzzer's test")
add_custom_target(fuzz)

# Kernels that no fuzzer is for are compiled as they are: with sanitizers those of products take an hour.
get_target_property(sources gaunt_objects SOURCES)
list(FILTER sources EXCLUDE REGEX "^capi/|^src/probe/|^src/product/prepare[.]cc")
set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS -fno-sanitize=all)

function(gaunt_fuzz name)
  add_executable(${name} EXCLUDE_FROM_ALL tests/fuzz/${name}.cc)
  gaunt_compile_internal(${name})
  target_link_libraries(${name} PRIVATE gaunt_static ${ARGN})
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzz ${name})
  add_test(NAME Fuzz.${name} COMMAND ${name} -runs=${GAUNT_FUZZ_RUNS} -seed=1 -max_len=4096
    -len_control=0 -timeout=10 -verbosity=0 -print_funcs=0 -print_final_stats=1)
endfunction()

gaunt_fuzz(probe_decode_fuzz)
gaunt_fuzz(probe_encode_fuzz)
gaunt_fuzz(probe_file_fuzz gaunt_volume)
gaunt_fuzz(product_apply_fuzz)
