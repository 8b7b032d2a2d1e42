# geodesic_test(<name> SOURCES <file>... [LIBRARIES <target>...])
#
# A GoogleTest program; each TEST becomes a ctest case. Test meshes that live
# outside the project are found through the environment variable
# GEODESIC_TEST_MESHES (default: ../shared/meshes beside the project).
function(geodesic_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE geodesic_options ${arg_LIBRARIES}
                        GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    GEODESIC_DEFAULT_TEST_MESHES="${PROJECT_SOURCE_DIR}/../shared/meshes")
  # The instances of parameterized tests have names of their own.
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 300)
endfunction()
