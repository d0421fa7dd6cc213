# SPDX-License-Identifier: MIT
# The scalar loops of the frame job, as a user's compiler makes them: contraction as it
# comes, and -O3 in every build.
add_library(gaunt_frame_baseline STATIC EXCLUDE_FROM_ALL
  bench/frame_baseline.cc)
target_include_directories(gaunt_frame_baseline PUBLIC ${PROJECT_SOURCE_DIR})
target_include_directories(gaunt_frame_baseline PRIVATE
  ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
target_link_libraries(gaunt_frame_baseline PRIVATE gaunt_warnings PUBLIC gaunt_reference)
string(REGEX MATCH "^[0-9]+" compiler_major "${CMAKE_CXX_COMPILER_VERSION}")
target_compile_definitions(gaunt_frame_baseline PUBLIC
  GAUNT_BASELINE_COMPILER="${CMAKE_CXX_COMPILER_ID} ${compiler_major} -O3")
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set_source_files_properties(bench/frame_baseline.cc PROPERTIES COMPILE_OPTIONS -O3)
endif()
