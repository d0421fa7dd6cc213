# SPDX-License-Identifier: MIT
# libgaunt, shared and static, from the same objects.
foreach(library gaunt gaunt_static)
  target_sources(${library} PRIVATE $<TARGET_OBJECTS:gaunt_objects>)
  target_link_libraries(${library} PRIVATE hwy::hwy)
  target_include_directories(${library} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${library} PROPERTIES OUTPUT_NAME gaunt LINKER_LANGUAGE CXX)
endforeach()
set_target_properties(gaunt PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  EXPORT_NAME shared)
set_target_properties(gaunt_static PROPERTIES EXPORT_NAME gaunt)
target_compile_definitions(gaunt INTERFACE GAUNT_SHARED)

# Nothing but the C API leaves the shared library.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(export_map ${PROJECT_SOURCE_DIR}/capi/gaunt.map)
  target_link_options(gaunt PRIVATE -Wl,--version-script=${export_map} -Wl,--exclude-libs,ALL
    -Wl,--as-needed -Wl,--no-undefined)
  set_property(TARGET gaunt APPEND PROPERTY LINK_DEPENDS ${export_map})
endif()
