// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// A place where the level curves of a field change their number or join.
struct TopologyEvent {
  enum class Kind { Begin, End, Split, Merge, Handle };
  Kind kind = Kind::Begin;
  double level = 0.0;
  Vec3 place = Vec3::Zero();
  std::uint32_t vertex = 0;
};

/// The pieces into which a field's saddles cut a surface: each piece has one curve per level. Arcs
/// of the Reeb graph.
struct FieldBranch {
  double from = 0.0;  ///< level at which the piece begins
  double to = 0.0;
  std::vector<std::size_t> below;  ///< branches that end where this one begins
  std::vector<std::size_t> above;
};

struct FieldTopology {
  std::vector<TopologyEvent> events;    ///< by level, then by vertex
  std::vector<FieldBranch> branches;    ///< by begin level, then by lowest vertex
  std::vector<std::uint32_t> branchOf;  ///< per triangle: the branch of its highest point
};

/// Saddles, minima and maxima of a field of vertices, counted by components of level curves (ties
/// by vertex order). Branches shorter than `least` (in units of the field) are joined to their
/// neighbour, so that noise makes no branch. Cost: O(n log n).
FieldTopology fieldTopology(const TriangleMesh& mesh,
                            const HalfEdges& halfEdges,
                            const std::vector<double>& field,
                            double least);

}  // namespace wcam::geometry
