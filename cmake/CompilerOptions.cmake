# Compiler settings every target of this project shares, as the interface
# target geodesic_options.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

add_library(geodesic_options INTERFACE)
target_compile_features(geodesic_options INTERFACE cxx_std_20)
# No fused multiply-add: a field has the same bits on every x86-64 and arm64.
# Square roots set no errno, and nobody looks at floating-point flags: values
# stay the same, the code around them gets shorter.
target_compile_options(geodesic_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers
  -ffp-contract=off -fno-math-errno -fno-trapping-math)

if(GEODESIC_SANITIZE)
  add_compile_options(-fsanitize=${GEODESIC_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${GEODESIC_SANITIZE})
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()
