// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace wcam::geometry {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
/// Rigid pose. A variable T_a_b is the pose of b in a: it maps b-coordinates to a-coordinates.
using Pose = Eigen::Isometry3d;

/// Axis-aligned box; empty until a point is added.
struct Box {
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }

  [[nodiscard]] bool empty() const { return !(min.x() <= max.x()); }

  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : (max - min).norm(); }
};

}  // namespace wcam::geometry
