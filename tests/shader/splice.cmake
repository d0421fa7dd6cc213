# SPDX-License-Identifier: MIT
# GLSL has no #include: writes SOURCE to OUTPUT with a #version line in front and gaunt.glsl in the
# place of the line that includes it. Run with -DVERSION= -DSOURCE= -DHEADER= -DOUTPUT=.
file(READ ${SOURCE} source)
file(READ ${HEADER} header)
string(REPLACE "#include \"gaunt/gaunt.glsl\"\n" "${header}" spliced "${source}")
if(spliced STREQUAL source)
  message(FATAL_ERROR "${SOURCE} does not include gaunt.glsl")
endif()
file(WRITE ${OUTPUT} "#version ${VERSION}\n${spliced}")
