# SPDX-License-Identifier: MIT
# The README shows examples/hello.c and the table of bench/results, line for line. Run with -DREADME=
# -DEXAMPLE= -DTABLE= (the script) -DRESULTS=.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(REPLACE "/* SPDX-License-Identifier: MIT */\n" "" example "${example}")
execute_process(COMMAND ${TABLE} ${RESULTS} OUTPUT_VARIABLE table COMMAND_ERROR_IS_FATAL ANY)
foreach(part IN ITEMS example table)
  string(FIND "${readme}" "${${part}}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the README does not show the ${part} as it is:\n${${part}}")
  endif()
endforeach()
