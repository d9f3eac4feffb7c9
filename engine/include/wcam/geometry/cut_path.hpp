// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// Shortest way along mesh edges from any vertex of one set to any of another; touches the first
/// set only with its first vertex and the second only with its last. Empty when there is none. Ties
/// by vertex index. Cost: O(n log n).
std::vector<std::uint32_t> edgePath(const TriangleMesh& mesh,
                                    const HalfEdges& halfEdges,
                                    const std::vector<std::uint32_t>& from,
                                    const std::vector<std::uint32_t>& to);

/// A mesh opened along a path of edges: its vertices are doubled, except an end that lies inside
/// the surface. Triangles keep their numbers.
struct PathCut {
  TriangleMesh mesh;
  HalfEdges halfEdges;
  std::vector<std::uint32_t> left;      ///< per path vertex: its number on the left of the path
  std::vector<std::uint32_t> right;     ///< on its right; equal to left where it is not doubled
  std::vector<std::uint32_t> original;  ///< per vertex of the cut mesh, its number before
};

/// @throws Error(InvalidArgument) when neighbours in the path share no edge
PathCut cutAlong(const TriangleMesh& mesh, const std::vector<std::uint32_t>& path);

}  // namespace wcam::geometry
