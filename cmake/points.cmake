# SPDX-License-Identifier: MIT
# The generator of point sets, for tools and tests only. Its bits rely on contraction being off.
add_library(gaunt_points STATIC EXCLUDE_FROM_ALL
  src/points/point_set.cc src/points/descent.cc src/points/repulsion.cc src/points/design.cc)
gaunt_compile_internal(gaunt_points)
target_link_libraries(gaunt_points PUBLIC gaunt_reference)
