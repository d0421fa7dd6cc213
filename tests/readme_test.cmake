# SPDX-License-Identifier: MIT
# The README shows examples/hello.c, the job of examples/frame.cpp and the table of bench/results, line
# for line. Run with -DREADME= -DEXAMPLE= -DFRAME= -DTABLE= (the script) -DRESULTS=.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(REPLACE "/* SPDX-License-Identifier: MIT */\n" "" example "${example}")
file(READ ${FRAME} frame)
string(REGEX MATCH "  gaunt_frame_job job.*gaunt::FrameLight[^\n]*\n" job "${frame}")
if(job STREQUAL "")
  message(FATAL_ERROR "${FRAME} has no job")
endif()
execute_process(COMMAND ${TABLE} ${RESULTS} OUTPUT_VARIABLE table COMMAND_ERROR_IS_FATAL ANY)
foreach(part IN ITEMS example job table)
  string(FIND "${readme}" "${${part}}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the README does not show the ${part} as it is:\n${${part}}")
  endif()
endforeach()
