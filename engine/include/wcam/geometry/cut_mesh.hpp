// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// Some triangles of a surface, with the values of its vertices if there are any.
struct SubSurface {
  PartSurface surface;
  std::vector<std::uint32_t> vertexOf;  ///< per vertex: the one of the whole surface
};

/// The triangles that are flagged, in their order; vertices that none of them uses go. The hash
/// follows from the flags.
SubSurface keepTriangles(const PartSurface& surface, const std::vector<bool>& keep);

/// A surface with a field on its vertices.
struct CutSurface {
  PartSurface surface;
  std::vector<double> field;
};

/// Splits triangles so that no triangle reaches across one of the levels: new vertices have
/// exactly the level and, on CAD parts, lie on the exact surface and on the CAD edges; the binding
/// follows. Vertices within 1e-9 of the field's range of a level get it.
/// @param levels ascending
/// @throws Error(InvalidArgument) when the field does not fit the surface
/// Cost: O(triangles) per level.
CutSurface cutAtLevels(const PartSurface& surface,
                       const std::vector<double>& field,
                       const std::vector<double>& levels);

/// A piece of a branching part: one level curve per level, save what is smaller than asked for.
struct FieldPiece {
  PartSurface surface;
  std::vector<double> field;  ///< per vertex
  double from = 0.0;          ///< least and greatest value
  double to = 0.0;
  std::vector<std::size_t> below;  ///< pieces on whose upper ends it stands
  std::vector<std::size_t> above;
};

/// Cuts a part at the saddles of a field into pieces without branches (Diourté M35). Their areas
/// add up to the part's. Ordered by least value, then by lowest triangle. What spans no more than
/// `least` makes no piece of its own.
/// @throws Error as fieldTopology
std::vector<FieldPiece> splitAtSaddles(const PartSurface& surface,
                                       const std::vector<double>& field,
                                       double least,
                                       const JobContext& context = JobContext());

}  // namespace wcam::geometry
