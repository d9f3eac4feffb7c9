# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
# See CMakeLists.txt beside this file.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}")
  endif()
endfunction()

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=${SANITIZE}")
endif()

# Configures and builds a project out of tree against the installation.
function(build source folder)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${folder}" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_BUILD_TYPE=${TYPE}" "-DCMAKE_CXX_FLAGS=${flags}"
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run("${CMAKE_COMMAND}" --build "${folder}")
endfunction()

set(prefix "${WORK}/été 1/prefix")
set(moved "${WORK}/été 2/elsewhere")
file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

# What users copy: the installed example, away from this tree.
file(COPY "${prefix}/${DATADIR}/wcam/examples/example_post" DESTINATION "${WORK}/own project")
build("${WORK}/own project/example_post" "${WORK}/own project/build")
build("${SOURCE}/tests/sdk/check" "${WORK}/check")

set(plugin "${WORK}/own project/build/wcam-plugins/org.example.post.csv")
foreach(file "${plugin}.so" "${plugin}.json")
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "missing: ${file}")
  endif()
endforeach()
run("${WORK}/check/sdk_check" "${plugin}.so" "${prefix}/${LIBDIR}" "${prefix}/${DATADIR}/wcam")

file(MAKE_DIRECTORY "${WORK}/été 2")
file(RENAME "${prefix}" "${moved}")
set(ENV{LD_LIBRARY_PATH} "${moved}/${LIBDIR}:$ENV{LD_LIBRARY_PATH}")
run("${WORK}/check/sdk_check" "${plugin}.so" "${moved}/${LIBDIR}" "${moved}/${DATADIR}/wcam")
unset(ENV{LD_LIBRARY_PATH})
if(EXISTS "${moved}/${BINDIR}/camcli")
  run("${moved}/${BINDIR}/camcli" --version)
endif()
file(REMOVE_RECURSE "${WORK}")
