// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/part_surface.hpp"

#include <array>
#include <vector>

namespace wcam::geometry {

/// A point of the part's surface.
struct ProjectedPoint {
  Vec3 p = Vec3::Zero();
  Vec3 n = Vec3::Zero();  ///< outward unit normal
  std::uint32_t triangle = 0;
};

/// Moves points that lie near a part onto it: onto the exact surface of CAD parts (Newton in (u,v)
/// from the nearest triangle), onto the nearest triangle of meshes, whose normals are smoothed
/// where facets meet at less than 40°. The part must outlive it.
class SurfaceProjector {
public:
  explicit SurfaceProjector(const PartSurface& part);

  /// Cost: O(log n) per point, parallel. @throws Error(InvalidArgument) for a part without
  /// triangles
  [[nodiscard]] std::vector<ProjectedPoint> project(const std::vector<Vec3>& points,
                                                    const JobContext& context = JobContext()) const;

private:
  [[nodiscard]] ProjectedPoint onMesh(const SurfaceHit& hit) const;

  const PartSurface* part_;
  AabbTree tree_;
  std::vector<std::array<Vec3, 3>> cornerNormals_;  ///< of meshes
};

}  // namespace wcam::geometry
