// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <optional>

namespace wcam::toolpath {

/// Evaluates the surface of a part around its triangles: exact parts in (u,v) of the triangle's
/// face, meshes in the plane of the triangle, where (u,v) are the weights of its corners 1 and 2.
/// For one thread.
class SurfacePatch {
public:
  explicit SurfacePatch(const geometry::PartSurface& part);

  [[nodiscard]] const geometry::PartSurface& part() const { return *part_; }

  [[nodiscard]] bool exact() const { return evaluator_.has_value(); }

  [[nodiscard]] geometry::SurfacePoint surface(std::uint32_t triangle,
                                               const geometry::Vec2& uv) const;
  /// Outward unit normal.
  [[nodiscard]] Vec3 normal(std::uint32_t triangle,
                            const geometry::Vec2& uv,
                            const geometry::SurfacePoint& point) const;
  [[nodiscard]] geometry::Vec2 corner(std::uint32_t triangle, std::size_t corner) const;
  /// (u,v) in a triangle of the place on a half-edge, which may be the half-edge of a neighbour.
  [[nodiscard]] geometry::Vec2 onHalfEdge(std::uint32_t triangle,
                                          std::uint32_t halfEdge,
                                          double fraction) const;
  /// Parameters of the surface point nearest to p, from uv.
  [[nodiscard]] geometry::Vec2 project(std::uint32_t triangle,
                                       geometry::Vec2 uv,
                                       const Vec3& p) const;
  /// The exact place on a half-edge: on its CAD edge, inside a face on the surface.
  [[nodiscard]] Vec3 edgePoint(std::uint32_t halfEdge, double fraction) const;
  /// Weights of the triangle's corners at uv.
  [[nodiscard]] Vec3 weights(std::uint32_t triangle, const geometry::Vec2& uv) const;

private:
  const geometry::PartSurface* part_;
  mutable std::optional<geometry::BrepEvaluator> evaluator_;
};

/// Shortest step in (u,v) whose image follows the surface vector that has these products with du
/// and dv; nothing at a point without tangent plane.
std::optional<geometry::Vec2> solveMetric(const geometry::SurfacePoint& point,
                                          const geometry::Vec2& products);

}  // namespace wcam::toolpath
