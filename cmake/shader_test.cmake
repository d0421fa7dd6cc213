# SPDX-License-Identifier: MIT
# The shader includes, compiled for all that they promise to be, and run without a GPU.
include(CMakeDependentOption)

find_path(EGL_INCLUDE_DIR EGL/egl.h)
find_path(GLES_INCLUDE_DIR GLES3/gl31.h)
find_library(EGL_LIBRARY EGL)
find_library(GLES_LIBRARY GLESv2)
find_program(GLSLANG_VALIDATOR glslangValidator)
find_program(SPIRV_CROSS spirv-cross)
mark_as_advanced(EGL_INCLUDE_DIR GLES_INCLUDE_DIR EGL_LIBRARY GLES_LIBRARY GLSLANG_VALIDATOR
  SPIRV_CROSS)
cmake_dependent_option(GAUNT_SHADER_TEST "Run the shader includes on Mesa's software renderer" ON
  "EGL_INCLUDE_DIR;GLES_INCLUDE_DIR;EGL_LIBRARY;GLES_LIBRARY;GLSLANG_VALIDATOR;SPIRV_CROSS" OFF)
if(NOT GAUNT_SHADER_TEST)
  message(STATUS "shader test: skipped, needs EGL, OpenGL ES, glslangValidator and spirv-cross")
  return()
endif()

set(shader_source ${PROJECT_SOURCE_DIR}/tests/shader)
set(shader_binary ${PROJECT_BINARY_DIR}/shader)
set(glsl_header ${PROJECT_SOURCE_DIR}/include/gaunt/gaunt.glsl)
set(hlsl_header ${PROJECT_SOURCE_DIR}/include/gaunt/gaunt.hlsl)
file(MAKE_DIRECTORY ${shader_binary})

# gaunt_glsl(<source> <output> <version>): spliced, and compiled as a check.
function(gaunt_glsl source output version)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DVERSION=${version}" -DSOURCE=${source} -DHEADER=${glsl_header}
      -DOUTPUT=${output} -P ${shader_source}/splice.cmake
    COMMAND ${GLSLANG_VALIDATOR} ${output}
    DEPENDS ${source} ${glsl_header} ${shader_source}/splice.cmake VERBATIM)
endfunction()

# gaunt_hlsl(<source> <output> <stage>): SPIR-V.
function(gaunt_hlsl source output stage)
  add_custom_command(OUTPUT ${output}
    COMMAND ${GLSLANG_VALIDATOR} -D -S ${stage} -e main -V -I${PROJECT_SOURCE_DIR}/include ${source}
      -o ${output}
    DEPENDS ${source} ${hlsl_header} VERBATIM)
endfunction()

foreach(kernel evaluate zh3 probe)
  set(stem ${shader_binary}/${kernel})
  gaunt_glsl(${shader_source}/${kernel}.comp ${stem}.glsl.comp "310 es")
  gaunt_glsl(${shader_source}/${kernel}.comp ${stem}.desktop.comp "430")
  gaunt_hlsl(${shader_source}/${kernel}.hlsl ${stem}.spv comp)
  add_custom_command(OUTPUT ${stem}.hlsl.comp
    COMMAND ${SPIRV_CROSS} --es --version 310 ${stem}.spv --output ${stem}.hlsl.comp
    DEPENDS ${stem}.spv VERBATIM)
  list(APPEND shaders ${stem}.glsl.comp ${stem}.desktop.comp ${stem}.hlsl.comp)
endforeach()
set(stem ${shader_binary}/surface)
gaunt_glsl(${shader_source}/surface.frag ${stem}.glsl.frag "300 es")
gaunt_glsl(${shader_source}/surface.frag ${stem}.desktop.frag "330")
gaunt_hlsl(${shader_source}/surface.hlsl ${stem}.spv frag)
add_custom_target(gaunt_shaders DEPENDS ${shaders} ${stem}.glsl.frag ${stem}.desktop.frag
  ${stem}.spv)

gaunt_test(shader_test tests/shader_test.cc tests/support/compute.cc)
add_dependencies(shader_test gaunt_shaders)
target_include_directories(shader_test PRIVATE ${EGL_INCLUDE_DIR} ${GLES_INCLUDE_DIR})
target_link_libraries(shader_test PRIVATE ${EGL_LIBRARY} ${GLES_LIBRARY})
target_compile_definitions(shader_test PRIVATE GAUNT_SHADER_DIR="${shader_binary}"
  GAUNT_INCLUDE_DIR="${PROJECT_SOURCE_DIR}/include/gaunt")
