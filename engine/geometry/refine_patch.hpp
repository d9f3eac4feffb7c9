// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// What refinement works on: the mesh, its binding, and facts about vertices that stay true while
/// edges are split and flipped.
struct RefinePatch {
  TriangleMesh mesh;
  const Brep* brep = nullptr;  ///< null for mesh files, whose binding is empty
  BrepBinding binding;
  std::vector<std::uint32_t> twin;  ///< per half-edge
  /// Per vertex: the parameter that is free at a pole (0: u, 1: v), −1 elsewhere. Corners at a pole
  /// carry the mean of the other corners'.
  std::vector<std::int8_t> freeParameter;
  /// Per vertex: it touches a non-manifold edge or several fans of triangles.
  std::vector<std::uint8_t> irregular;
  std::vector<double> uvSign;  ///< per face: orientation of its triangles in (u,v), ±1

  [[nodiscard]] bool exact() const noexcept { return brep != nullptr; }

  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return mesh.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return mesh.triangles[h / 3][(h % 3 + 1) % 3];
  }

  [[nodiscard]] std::uint32_t oppositeOf(std::uint32_t h) const {
    return mesh.triangles[h / 3][(h % 3 + 2) % 3];
  }

  /// Twice the area of three places in (u,v), positive for a triangle of this face as it should be.
  [[nodiscard]] double uvArea(std::int32_t face, const Vec2& a, const Vec2& b, const Vec2& c) const;
  /// Gives the pole corners of a triangle the mean of the others' free parameter.
  void freePoles(std::uint32_t triangle);
};

/// Splits every edge longer than `maxEdge` at its middle, all at once, without T-junctions.
/// @return number of edges split
std::size_t splitLongEdges(RefinePatch& patch, double maxEdge, const JobContext& context);

/// Flips edges towards Delaunay where the shape stays: inside faces, across flat edges of meshes,
/// never on borders. No edge becomes longer than the longer one of itself and `maxEdge`.
/// The order of flips follows the shape (worst first), not the order of the triangles.
void flipToDelaunay(RefinePatch& patch, double maxEdge, const JobContext& context);

/// Lexicographic order of points: an order that does not depend on indices.
bool pointLess(const Vec3& a, const Vec3& b);

}  // namespace wcam::geometry
