// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// A place where a level curve begins (a minimum, a lower border), ends, parts or joins others. A
/// Handle joins curves that come from one below: the surface has a hole there (Diourté M35).
struct TopologyEvent {
  enum class Kind { Begin, End, Split, Merge, Handle };
  Kind kind = Kind::Begin;
  double level = 0.0;
  Vec3 place = Vec3::Zero();
  std::uint32_t vertex = 0;
};

/// A piece into which the field's saddles cut a surface: one curve per level, open or closed. An
/// arc of the Reeb graph.
struct FieldBranch {
  double from = 0.0;  ///< level at which the piece begins
  double to = 0.0;
  std::vector<std::size_t> below;  ///< branches that end where this one begins
  std::vector<std::size_t> above;
};

struct FieldTopology {
  std::vector<TopologyEvent> events;  ///< by level, then by vertex
  std::vector<FieldBranch> branches;  ///< by begin level, then by lowest vertex
  /// Per triangle: the branch just below its highest corner; HalfEdges::kNone where the field has
  /// no value and for triangles that are an edge.
  std::vector<std::uint32_t> branchOf;
};

/// Saddles, minima and maxima of a field of vertices, found by following level curves upwards (ties
/// by vertex order). What is not longer than `least` (in units of the field) makes no branch of its
/// own: dead ends, double ways and short ways between events are joined to a neighbour. A vertex at
/// which parts of the surface only touch counts once for each; a triangle with a corner without
/// value does not exist.
/// @throws Error(InvalidArgument) when the field does not fit the mesh or `least` is negative
/// Cost: O(n log n) and the length of the level curves through the saddles.
FieldTopology fieldTopology(const TriangleMesh& mesh,
                            const HalfEdges& halfEdges,
                            const std::vector<double>& field,
                            double least);

}  // namespace wcam::geometry
