# geodesic_test(<name> SOURCES <file>... [LIBRARIES <target>...]
#               [HEADERS <precompiled headers>])
#
# A GoogleTest program; each TEST becomes a ctest case. Test meshes that live
# outside the project are found through the environment variable
# GEODESIC_TEST_MESHES (default: ../shared/meshes beside the project).
function(geodesic_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS" "SOURCES;LIBRARIES")
  if(NOT arg_HEADERS)
    set(arg_HEADERS geodesic_test_headers)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_precompile_headers(${name} REUSE_FROM ${arg_HEADERS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE geodesic_options ${arg_LIBRARIES}
                        GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  # The instances of parameterized tests have names of their own.
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 300)
endfunction()
