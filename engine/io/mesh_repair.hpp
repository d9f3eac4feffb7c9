// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wcam::io {

/// Number of dropped triangles and where the first one was.
struct Dropped {
  std::size_t count = 0;
  geometry::Vec3 first = geometry::Vec3::Zero();
};

/// Drops triangles that use a vertex twice. Order is kept.
Dropped dropDegenerate(geometry::TriangleMesh& mesh);

/// Drops triangles whose three vertices another triangle before them has, in any order of corners.
/// Order is kept. O(n)
Dropped dropDuplicates(geometry::TriangleMesh& mesh);

/// Drops the walls between bodies that touch: triangles that lie back to back, both of a pair,
/// where the border of their patch lies on other triangles of both bodies. Sheets with two sides
/// are kept. Order is kept. O(n)
Dropped dropInnerWalls(geometry::TriangleMesh& mesh);

/// Drops vertices that no triangle uses; order is kept.
void dropUnusedVertices(geometry::TriangleMesh& mesh);

/// Triangles of three different vertices on (nearly) one line.
Dropped countFlat(const geometry::TriangleMesh& mesh);

/// Joins points of border edges that lie within `tolerance` of each other. Groups grow by chains;
/// the point with the lowest index stays. Degenerate triangles may remain.
/// @return the number of points that were joined to another
std::size_t stitchBorders(geometry::TriangleMesh& mesh,
                          const geometry::HalfEdges& halfEdges,
                          double tolerance);

/// What has to be turned so that all normals of a piece agree.
struct Orientation {
  std::vector<bool> flipNode;  ///< per node
  std::size_t flippedTriangles = 0;
  std::size_t components = 0;                     ///< pieces joined by edges of two triangles
  geometry::Vec3 first = geometry::Vec3::Zero();  ///< on the first turned triangle
};

/// Decides which nodes (triangles, or the CAD faces they belong to) are turned: neighbours over an
/// edge of two triangles agree; an open piece keeps the direction of its majority; a closed piece
/// points outwards, and the pieces inside it turn along, so that cavities stay cavities.
/// @param nodeOf node of each triangle; empty when each triangle is its own
/// @throws Error(InputInvalid) naming `file` and a place when a piece cannot be oriented
Orientation findOrientation(const geometry::TriangleMesh& mesh,
                            const geometry::HalfEdges& halfEdges,
                            const std::vector<std::int32_t>& nodeOf,
                            std::size_t nodeCount,
                            const std::string& file,
                            const JobContext& context);

/// "(1.5, 0, -3)" in mm, for messages.
std::string positionText(const geometry::Vec3& p);

}  // namespace wcam::io
