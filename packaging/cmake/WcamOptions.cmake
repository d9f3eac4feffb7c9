# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
# Build options, and the one interface target (wcam_options) that carries the compiler settings.

option(WCAM_BUILD_TESTS "Build the tests" ON)
option(WCAM_BUILD_BENCH "Build the benchmarks (need extra packages, see packaging/quickstart)" OFF)
set(WCAM_BUILD_GUI AUTO CACHE STRING "Build the front-end: ON, OFF, or AUTO where Qt 6 and VTK are found")
option(WCAM_BUILD_FUZZ "Build the libFuzzer targets (needs clang)" OFF)
set(WCAM_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined or thread")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The build tree mirrors the installed tree, so that plugins and resources are found the same way.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

add_library(wcam_options INTERFACE)
# Results must not depend on the processor: no contraction, no fast-math (DESIGN 12).
target_compile_options(wcam_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False positives of GCC 12 inside Eigen and libstdc++ at -O2 and above.
  target_compile_options(wcam_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow -Wno-restrict)
endif()
if(WCAM_SANITIZE)
  # A finding ends the program, so that no test passes over it.
  target_compile_options(wcam_options INTERFACE -fsanitize=${WCAM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_definitions(wcam_options INTERFACE WCAM_SANITIZED)
  if(WCAM_SANITIZE MATCHES "thread")
    target_compile_definitions(wcam_options INTERFACE WCAM_SANITIZED_THREADS)
  endif()
  target_link_options(wcam_options INTERFACE -fsanitize=${WCAM_SANITIZE})
endif()
if(WCAM_BUILD_FUZZ)
  # The engine reports its coverage to the fuzzer, which the fuzz targets link.
  target_compile_options(wcam_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
