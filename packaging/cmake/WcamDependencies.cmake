# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
# Third-party packages, all from Debian 12. packaging/quickstart installs them.

find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(CLI11 REQUIRED)
find_package(EXPAT REQUIRED)
find_package(ZLIB REQUIRED)
# Writes the packages of the tests.
find_library(WCAM_MINIZIP minizip REQUIRED)
find_package(OpenCASCADE REQUIRED)
find_package(CGAL REQUIRED)
find_package(fcl 0.7 CONFIG REQUIRED)
find_library(WCAM_MUPARSER muparser REQUIRED)
find_library(WCAM_SLEEF sleef REQUIRED)
# Clipper: its package has no CMake file. Boost.Polygon is header-only.
find_library(WCAM_CLIPPER polyclipping REQUIRED)
find_path(WCAM_CLIPPER_INCLUDE polyclipping/clipper.hpp REQUIRED)
find_package(Boost 1.74 REQUIRED)

# OpenCASCADE's targets carry no include directory.
add_library(wcam_occt INTERFACE)
target_include_directories(wcam_occt SYSTEM INTERFACE "${OpenCASCADE_INCLUDE_DIR}")

# The front-end. Components are always named: Debian's VTK has modules that would bring in Qt 5.
if(WCAM_BUILD_GUI)
  set(wcam_gui_required "")
  if(NOT WCAM_BUILD_GUI STREQUAL "AUTO")
    set(wcam_gui_required REQUIRED)
  endif()
  find_package(Qt6 6.4 ${wcam_gui_required} COMPONENTS Core Gui Widgets OpenGL OpenGLWidgets Svg LinguistTools)
  # What the benchmarks need as well: VTK's targets must be made in one place.
  set(wcam_vtk_bench "")
  if(WCAM_BUILD_BENCH)
    set(wcam_vtk_bench IOGeometry)
  endif()
  find_package(VTK 9.1 ${wcam_gui_required} COMPONENTS
    CommonCore CommonDataModel CommonMath FiltersCore FiltersSources IOImage RenderingAnnotation RenderingCore
    RenderingFreeType RenderingOpenGL2 ${wcam_vtk_bench})
  if(NOT Qt6_FOUND OR NOT VTK_FOUND)
    message(STATUS "the front-end is left out: Qt 6 or VTK is missing (packaging/quickstart gui installs them)")
    set(WCAM_BUILD_GUI OFF)
  endif()
endif()
