// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// How the level curves of a field begin, end, join and part: an arc for each curve that moves
/// upwards, a node wherever the number of curves changes.
struct ReebGraph {
  struct Node {
    std::uint32_t vertex = 0;
    double level = 0.0;
  };

  struct Arc {
    std::uint32_t from = 0;  ///< node
    std::uint32_t to = 0;
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> arcOfTriangle;  ///< arc just below its highest corner, or kNone
};

/// The graph of the field as it is, noise included. Cost: O(n log n) and the length of the level
/// curves through its saddles.
ReebGraph reebGraph(const TriangleMesh& mesh,
                    const HalfEdges& halfEdges,
                    const std::vector<double>& field);

/// Without what noise makes: dead ends beside another way, double ways and ways between two nodes,
/// each no longer than `least`. Shortest first, so that the longest of several survives.
ReebGraph simplified(ReebGraph graph, double least);

}  // namespace wcam::geometry
