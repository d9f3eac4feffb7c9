# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
find_package(GTest REQUIRED)
include(GoogleTest)

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
  gtest_discover_tests(${name} TEST_PREFIX "${name}." PROPERTIES LABELS "${arg_LABEL}" TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()
