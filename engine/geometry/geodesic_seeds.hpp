// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/geodesic.hpp"

#include <limits>
#include <vector>

namespace wcam::geometry {

/// Radius of a straight wave front.
inline constexpr double kStraightFront = std::numeric_limits<double>::infinity();

/// A vertex whose distance follows from the source directly.
struct GeodesicSeed {
  std::uint32_t vertex = 0;
  double distance = 0.0;  ///< mm
  /// Radius of the wave front there, mm: positive where it spreads, negative where it converges.
  double radius = 0.0;
  bool fan = false;  ///< on the source where it is a point: ways leave in all directions
};

/// The vertices on the source and the corners of the triangles that hold it. A vertex may occur
/// several times.
/// @throws Error(InvalidArgument) when the source is empty or does not lie on the mesh
std::vector<GeodesicSeed> geodesicSeeds(const TriangleMesh& mesh,
                                        const HalfEdges& halfEdges,
                                        const GeodesicSource& source);

}  // namespace wcam::geometry
