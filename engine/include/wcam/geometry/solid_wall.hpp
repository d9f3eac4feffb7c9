// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"

#include <vector>

namespace wcam::geometry {

/// Which surface of a solid wall is worked on: one of its two sides, or the surface halfway between
/// them.
enum class WallSide { Outer, Inner, Middle };

/// Wall thickness at the vertices of a working surface: distance to the opposite side (of the
/// middle surface: from side to side through the vertex), mm.
struct WallThickness {
  std::vector<double> atVertex;
  double min = 0.0;
  double mean = 0.0;  ///< by area
  double max = 0.0;
  Vec3 thinnest = Vec3::Zero();  ///< place of min
  Vec3 thickest = Vec3::Zero();  ///< place of max
};

/// The working surface of a solid wall, an open surface with the outward side of the wall's own
/// triangles, and the map of its thickness.
struct SolidWall {
  PartSurface surface;
  WallThickness thickness;
};

/// Takes the two sides of a solid wall apart.
///
/// A triangle belongs to a wall when the straight line into the material meets another triangle
/// that looks the other way, no farther than three times the usual thickness; what is left is rims
/// and the ends of walls. Sides that look at each other get different colours, pieces of rim
/// between equal colours join them (the ring around the bottom of a cup). The outer side is the
/// larger one. Sides of CAD parts are whole faces and stay exact; the middle surface is a mesh (the
/// outer side, refined, with each vertex moved halfway to the nearest point of the inner side,
/// exactly where the part is exact), turned outwards like the outer side.
///
/// @throws Error(JobFailed) for a part without two sides that look at each other (an open shell, a
/// bulk part, ribs on a wall): says which and what to do
/// Cost: O(n log n), parallel.
SolidWall solidWall(const PartSurface& part,
                    WallSide side,
                    const JobContext& context = JobContext());

}  // namespace wcam::geometry
