# SPDX-License-Identifier: MIT
# The C in the README is examples/hello.c, line for line. Run with -DREADME= -DEXAMPLE=.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(REPLACE "/* SPDX-License-Identifier: MIT */\n" "" example "${example}")
string(FIND "${readme}" "${example}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "the README does not show ${EXAMPLE} as it is")
endif()
