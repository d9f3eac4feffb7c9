// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/aabb_tree.hpp"

#include "surface_patch.hpp"

#include <vector>

namespace wcam::toolpath {

/// Rounds the corners of sampled curves on a part by parabolas that touch both sides and stay
/// within `bound` of the corner; the new points lie on the surface. A distance to another curve
/// changes by at most the bound, since no point moves farther.
class CornerSmoothing {
public:
  CornerSmoothing(const SurfacePatch& patch, double bound);

  /// @param corners points of the contour to be rounded
  /// @return how many were rounded; the rest lie too near to each other or to an edge of the part
  std::size_t apply(Contour& contour, const std::vector<Vec3>& corners) const;

private:
  [[nodiscard]] bool roundOne(Contour& contour, std::size_t index) const;
  [[nodiscard]] std::optional<ContourPoint> onSurface(const Vec3& p, double reach) const;

  const SurfacePatch* patch_;
  geometry::AabbTree tree_;
  double bound_;
};

}  // namespace wcam::toolpath
