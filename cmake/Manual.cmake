# geodesic_manual(<target> OUT <variable> SOURCES <file>... LIBRARIES <target>...)
#
# A program that writes a manual into a folder, whose path OUT gets. It runs
# whenever it was built. Man pages are compressed, as Debian wants them, without
# a time: every build gives the same bytes.
find_program(GZIP_PROGRAM gzip REQUIRED)

function(geodesic_manual target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "OUT" "SOURCES;LIBRARIES")
  add_executable(${target} ${arg_SOURCES})
  target_compile_definitions(${target}
    PRIVATE GEODESIC_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${target}
    PRIVATE geodesic_options geodesic_manual ${arg_LIBRARIES})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target})
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
    COMMAND ${target} ${folder}
    COMMAND sh -c "${GZIP_PROGRAM} -9n ${folder}/*.[18]"
    VERBATIM)
  set(${arg_OUT} ${folder} PARENT_SCOPE)
endfunction()
