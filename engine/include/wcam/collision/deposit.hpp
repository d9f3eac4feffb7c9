// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/toolpath.hpp"

#include <cstdint>
#include <vector>

namespace wcam::collision {

/// A piece of a bead between two points: everything within `radius` of the segment, part frame, mm.
/// Its top lies at the path, as the torch has left it.
struct DepositRod {
  geometry::Vec3 a = geometry::Vec3::Zero();
  geometry::Vec3 b = geometry::Vec3::Zero();
  double radius = 0.0;
  /// It is there when at least so many points of the toolpath are deposited (CellState::deposited).
  std::uint32_t order = 0;
};

/// What a toolpath deposits, in order (Diourté M33: cylinders of the bead's diameter along the
/// path): the radius is half the greater of width and height, the axis that much below the path
/// against the build direction. Moves with the arc off deposit nothing.
std::vector<DepositRod> depositRods(const toolpath::Toolpath& path);

}  // namespace wcam::collision
