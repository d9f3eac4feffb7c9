# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later

# What nearly every file of the engine includes, compiled once: a third of the time of a file goes into these
# headers. A build with WCAM_PRECOMPILE=OFF shows an include that is missing.
option(WCAM_PRECOMPILE "Compile the headers that everything includes once" ON)
if(WCAM_PRECOMPILE)
  add_library(wcam_engine_precompiled OBJECT EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/packaging/cmake/precompiled.cpp")
  target_link_libraries(wcam_engine_precompiled PUBLIC Eigen3::Eigen PRIVATE wcam_options)
  target_precompile_headers(wcam_engine_precompiled PRIVATE
    <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory>
    <optional> <set> <span> <string> <string_view> <utility> <variant> <vector>)
endif()

# wcam_add_module(name SOURCES ... [DEPENDS modules...] [LIBRARIES private third parties...])
#
# An engine module is an object library wcam_<name>; all of them make libwcam-engine.so. DEPENDS names
# the modules it may include, which must stand before it in engine/CMakeLists.txt.
function(wcam_add_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_library(wcam_${name} OBJECT ${arg_SOURCES})
  target_include_directories(wcam_${name} PUBLIC "${PROJECT_SOURCE_DIR}/engine/include" PRIVATE "${PROJECT_SOURCE_DIR}/engine/${name}")
  target_link_libraries(wcam_${name} PUBLIC Eigen3::Eigen PRIVATE wcam_options ${arg_LIBRARIES})
  if(WCAM_PRECOMPILE)
    target_precompile_headers(wcam_${name} REUSE_FROM wcam_engine_precompiled)
  endif()
  foreach(dependency IN LISTS arg_DEPENDS)
    if(NOT TARGET wcam_${dependency})
      message(FATAL_ERROR "module ${name} depends on ${dependency}, which is not below it")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY WCAM_MODULES ${name})
  set_property(GLOBAL APPEND PROPERTY WCAM_ENGINE_LIBRARIES ${arg_LIBRARIES})
endfunction()
