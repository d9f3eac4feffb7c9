// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace wcam::geometry {

struct SurfaceHit {
  Vec3 p = Vec3::Zero();
  std::uint32_t triangle = 0;
  double distance = 0.0;  ///< mm, along the ray or to the query point
};

/// Closest-point and ray queries on a mesh. Holds its own copy of the triangles; const queries are
/// thread-safe. Building costs O(n log n), a query O(log n) on usual meshes. Degenerate triangles
/// are left out.
class AabbTree {
public:
  explicit AabbTree(const TriangleMesh& mesh);
  ~AabbTree();
  AabbTree(AabbTree&&) noexcept;
  AabbTree& operator=(AabbTree&&) noexcept;

  /// Nothing for a mesh without triangles.
  [[nodiscard]] std::optional<SurfaceHit> closestPoint(const Vec3& query) const;
  /// First hit at or after the origin. The direction need not be a unit vector.
  [[nodiscard]] std::optional<SurfaceHit> firstHit(const Vec3& origin, const Vec3& direction) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::geometry
