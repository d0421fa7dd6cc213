# SPDX-License-Identifier: MIT
# gaunt_family(<name> [part...]): one feature, whose files share a stem. All of them must be there.
# Parts are further sources of the library, src/<name>/<part>.cc. They may have counts and benchmarks
# of their own, src/<name>/<part>_count.cc and bench/<name>_<part>_bench.cc.
function(gaunt_family name)
  foreach(file
      src/${name}/${name}.h src/${name}/${name}-inl.h src/${name}/${name}.cc
      src/${name}/${name}_reference.h src/${name}/${name}_reference.cc
      src/${name}/${name}_count.cc
      capi/${name}.cc tests/${name}_test.cc bench/${name}_bench.cc)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
      message(FATAL_ERROR "family ${name} lacks ${file}")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY gaunt_families ${name})
  target_sources(gaunt_objects PRIVATE src/${name}/${name}.cc capi/${name}.cc)
  foreach(part ${ARGN})
    target_sources(gaunt_objects PRIVATE src/${name}/${part}.cc)
    if(EXISTS ${PROJECT_SOURCE_DIR}/src/${name}/${part}_count.cc)
      target_sources(gaunt_count PRIVATE src/${name}/${part}_count.cc)
    endif()
    if(GAUNT_BENCH AND EXISTS ${PROJECT_SOURCE_DIR}/bench/${name}_${part}_bench.cc)
      target_sources(gaunt_bench PRIVATE bench/${name}_${part}_bench.cc)
    endif()
  endforeach()
  target_sources(gaunt_reference PRIVATE src/${name}/${name}_reference.cc)
  target_sources(gaunt_count PRIVATE src/${name}/${name}_count.cc)
  if(GAUNT_TESTS)
    file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}_*_test.cc)
    gaunt_test(${name}_test tests/${name}_test.cc ${parts})
  endif()
  if(GAUNT_BENCH)
    target_sources(gaunt_bench PRIVATE bench/${name}_bench.cc)
  endif()
endfunction()

# families.h: GAUNT_FOR_EACH_FAMILY(visit), from the calls above.
function(gaunt_families_header)
  get_property(families GLOBAL PROPERTY gaunt_families)
  list(TRANSFORM families REPLACE "(.+)" "visit(\\1)")
  list(JOIN families " " visits)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/families.h
    CONTENT "#define GAUNT_FOR_EACH_FAMILY(visit) @visits@\n" @ONLY)
  target_include_directories(gaunt_count PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()
