// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/collisions.hpp"

#include <optional>

namespace wcam::motion::detail {

struct TiltRange {
  double lateral = 0.0;  ///< greatest, either side, rad
  double lead = 0.0;
};

/// Rotation about the point's travel direction after one about the direction across.
Eigen::Matrix3d tiltRotation(const toolpath::PathPoint& point, const Tilt& tilt);

/// Tilts of the torch at one point, absolute: against the axis that the path had before any.
class ExitSearch {
public:
  /// @param tool where the torch stands with the tilt `applied`
  ExitSearch(const collision::CellCollision& collision,
             const toolpath::PathPoint& point,
             const collision::ToolState& tool,
             const Tilt& applied);

  /// The smallest tilt that frees the torch, in whole degrees; lateral ones first, towards `side`
  /// (±1) before the other.
  [[nodiscard]] std::optional<Tilt> smallest(const TiltRange& range, double side) const;

  /// The tool with another tilt; the TCP stays.
  [[nodiscard]] collision::ToolState turned(const Tilt& tilt) const;

private:
  [[nodiscard]] std::optional<Tilt> firstFree(const std::vector<Tilt>& candidates) const;

  const collision::CellCollision& collision_;
  const toolpath::PathPoint& point_;
  collision::ToolState upright_;  ///< without tilt
};

}  // namespace wcam::motion::detail
