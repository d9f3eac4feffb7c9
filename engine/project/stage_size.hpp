// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/collisions.hpp"
#include "wcam/program/program.hpp"
#include "wcam/toolpath/slice_field.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <cstddef>

namespace wcam::project {

/// Memory of a stage's result that grows with its points, as far as a cache must know; 0 for the
/// others.
template <class T>
std::size_t bytesOf(const T& /*value*/) {
  return 0;
}

inline std::size_t pointsOf(const toolpath::SlicedLayers& sliced) {
  std::size_t points = 0;
  for (const toolpath::SlicedLayer& layer : sliced.layers) {
    for (const toolpath::Contour& contour : layer.contours) {
      points += contour.points.size();
    }
  }
  return points;
}

inline std::size_t bytesOf(const toolpath::SlicedLayers& sliced) {
  return pointsOf(sliced) * sizeof(toolpath::ContourPoint);
}

inline std::size_t bytesOf(const toolpath::Toolpath& path) {
  return path.pointCount() * sizeof(toolpath::PathPoint);
}

inline std::size_t bytesOf(const motion::CheckedMotion& checked) {
  return checked.planned.motion.waypoints.size() * sizeof(motion::Waypoint) + bytesOf(checked.path);
}

inline std::size_t bytesOf(const program::Program& program) {
  return program.instructions.size() * sizeof(program::Instruction);
}

}  // namespace wcam::project
