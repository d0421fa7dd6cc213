# SPDX-License-Identifier: MIT
# find_package(gaunt): gaunt::gaunt (static) and gaunt::shared.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gaunt)
install(TARGETS gaunt gaunt_static EXPORT gaunt_targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/gaunt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT gaunt_targets NAMESPACE gaunt:: DESTINATION ${package_dir})
configure_package_config_file(cmake/gaunt-config.cmake.in
  ${PROJECT_BINARY_DIR}/gaunt-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gaunt-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gaunt-config.cmake
  ${PROJECT_BINARY_DIR}/gaunt-config-version.cmake DESTINATION ${package_dir})
if(GAUNT_TOOLS)
  install(TARGETS gaunt_command DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
