# Compiler settings every target of this project shares, as the interface
# target geodesic_options.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# The solver alone is faster with -O3, and asks for it.
string(REPLACE -O3 -O2 CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")

add_library(geodesic_options INTERFACE)
target_compile_features(geodesic_options INTERFACE cxx_std_20)
# No fused multiply-add: a field has the same bits on every x86-64 and arm64.
# Square roots set no errno, and nobody looks at floating-point flags: values
# stay the same, the code around them gets shorter.
target_compile_options(geodesic_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers
  -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  # What a lock guards is used under that lock: server/locks/mutex.h.
  target_compile_options(geodesic_options INTERFACE
    -Wthread-safety -Werror=thread-safety)
endif()

if(GEODESIC_SANITIZE)
  add_compile_options(-fsanitize=${GEODESIC_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${GEODESIC_SANITIZE})
endif()

if(GEODESIC_BUILD_FUZZERS)
  # The code under test reports its coverage.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers hit the cache only if it may overlook when they were
  # made, and what was defined then. Folders of builds beside each other share
  # it, since paths in the project count from there.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    env CCACHE_SLOPPINESS=pch_defines,time_macros
        CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=true
        ${CCACHE_PROGRAM})
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # The cache reads what the preprocessor says of them.
  add_compile_options(-fpch-preprocess)
endif()
