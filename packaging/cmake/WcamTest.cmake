# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
find_package(GTest REQUIRED)
include(GoogleTest)

# What is measured is in the engine: the tests themselves need not be fast, but be built fast.
set(wcam_test_options "$<$<CONFIG:Release>:-O1>")

# What every test includes, compiled once: half of the time of a test file goes into these headers.
if(WCAM_PRECOMPILE)
  add_executable(wcam_test_precompiled EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/tests/support/precompiled.cpp")
  target_compile_options(wcam_test_precompiled PRIVATE ${wcam_test_options})
  target_link_libraries(wcam_test_precompiled PRIVATE wcam_options Eigen3::Eigen GTest::gtest GTest::gmock)
  target_precompile_headers(wcam_test_precompiled PRIVATE
    <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry>
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <numbers> <optional> <random> <set>
    <sstream> <stop_token> <string> <string_view> <variant> <vector>)
endif()

# wcam_add_test(name LABEL unit SOURCES ... [LIBRARIES ...])
#
# One test program per module, linked to the engine. Tests find files through the macros WCAM_TEST_DATA
# (tests/data), WCAM_RESOURCES (resources) and WCAM_BUILD (the build tree).
function(wcam_add_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE wcam::engine wcam_options GTest::gtest_main GTest::gmock ${arg_LIBRARIES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/support")
  target_compile_definitions(${name} PRIVATE
    WCAM_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    WCAM_RESOURCES="${PROJECT_SOURCE_DIR}/resources"
    WCAM_BUILD="${PROJECT_BINARY_DIR}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  target_compile_options(${name} PRIVATE ${wcam_test_options})
  if(WCAM_PRECOMPILE)
    target_precompile_headers(${name} REUSE_FROM wcam_test_precompiled)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX "${name}." PROPERTIES LABELS "${arg_LABEL}" TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()
