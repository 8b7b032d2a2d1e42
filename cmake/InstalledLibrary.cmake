# geodesic_install_library(<core or client> TARGETS <target>... LIBS <flag>...
#                          REQUIRES <pkg-config package>...)
#
# Installs a library with its headers and those of types, and what finds it: its targets
# in the CMake package `geodesic`, and a file of pkg-config that tells the
# libraries behind it, since it is static.
include(CMakePackageConfigHelpers)

function(geodesic_install_library component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TARGETS;LIBS;REQUIRES")
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/geodesic)
  set_target_properties(geodesic_${component}
    PROPERTIES EXPORT_NAME ${component})
  install(TARGETS ${arg_TARGETS} EXPORT geodesic_${component}
    COMPONENT ${component})
  install(DIRECTORY include/ ${PROJECT_SOURCE_DIR}/types/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${component})
  install(EXPORT geodesic_${component} NAMESPACE geodesic::
    FILE geodesic_${component}Targets.cmake
    DESTINATION ${folder} COMPONENT ${component})
  configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/geodesicConfig.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/geodesicConfig.cmake
    INSTALL_DESTINATION ${folder})
  write_basic_package_version_file(
    ${CMAKE_CURRENT_BINARY_DIR}/geodesicConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/geodesicConfig.cmake
                ${CMAKE_CURRENT_BINARY_DIR}/geodesicConfigVersion.cmake
    DESTINATION ${folder} COMPONENT ${component})

  list(TRANSFORM arg_TARGETS PREPEND -l)
  list(JOIN arg_TARGETS " " libraries)
  list(JOIN arg_LIBS " " others)
  list(JOIN arg_REQUIRES " " requires)
  # Relative to the file, so that the prefix may be moved.
  file(RELATIVE_PATH up
    /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  file(CONFIGURE OUTPUT geodesic_${component}.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@up@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: geodesic_@component@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Requires: @requires@
Libs: -L${libdir} @libraries@ @others@
Cflags: -I${includedir}
]])
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/geodesic_${component}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component})
endfunction()
