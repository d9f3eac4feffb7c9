// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"

#include <array>

namespace wcam::cell {

/// Values of the positioner's axes that turn a direction of the table to a target direction.
struct PositionerSolution {
  std::array<double, 2> joints{};  ///< controller values in (−π, π]; unused axes are 0
  double residual = 0.0;           ///< angle left between the direction and the target, rad
};

/// The two ways of the general two-rotation problem; equal where they coincide.
struct PositionerResult {
  std::array<PositionerSolution, 2> solutions;
  int count = 1;
};

/// Turns the direction `b` of the table (unit, table frame) to `target` (unit, base frame), exactly
/// where the axes can, else as near as they can. Any directions of the axes, not only right angles
/// (Chalvin C.24–C.25 generalised). What a degenerate case leaves open keeps its `seed` value: the
/// second axis when b lies along it, the first one when the target lies along the first.
/// @param seed controller values of the positioner's axes
PositionerResult alignAxis(const Chain& positioner,
                           const Vec3& b,
                           const Vec3& target,
                           const std::array<double, 2>& seed);

/// The direction of the part (unit, part frame) to the world's vertical.
PositionerResult alignToVertical(const Cell& cell,
                                 const Vec3& upInPart,
                                 const std::array<double, 2>& seed);

}  // namespace wcam::cell
