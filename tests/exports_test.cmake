# SPDX-License-Identifier: MIT
# Symbols of the shared library are those of capi/exports.txt, and it needs nothing beyond Highway and
# the C and C++ runtimes. Run with -DNM= -DREADELF= -DLIBRARY= -DEXPORTS=.
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^ \n]+\n" names "${output}")
list(TRANSFORM names STRIP)
list(SORT names)
file(STRINGS ${EXPORTS} wanted)
if(NOT names STREQUAL wanted)
  message(FATAL_ERROR "exported symbols\n  ${names}\ndiffer from exports.txt\n  ${wanted}")
endif()
execute_process(COMMAND ${READELF} -d ${LIBRARY} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED[^\n]*" needed "${output}")
foreach(entry ${needed})
  if(NOT entry MATCHES "lib(hwy|stdc\\+\\+|c\\+\\+|gcc_s|m|c)\\.so|ld-linux|lib(asan|ubsan|tsan)")
    message(FATAL_ERROR "the library needs ${entry}")
  endif()
endforeach()
