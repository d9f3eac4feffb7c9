// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/toolpath/fill_room.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <cstddef>
#include <vector>

namespace wcam::cladding {

using geometry::Vec3;

/// A curve on the surface with its outward normals.
struct SurfaceCurve {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  bool closed = false;
  std::size_t line = 0;  ///< number of the trace
};

/// @param merge points nearer than this to the one before go (their direction is rounding), mm
SurfaceCurve toCurve(const toolpath::Contour& contour, std::size_t line, double merge);

/// Each normal becomes the mean over the curve within this distance on both sides, weighted by
/// length: facets of a mesh, and slivers above all, have normals that the surface does not have.
void smoothNormals(SurfaceCurve& curve, double distance);

/// The pieces of a curve that keep a distance from the border.
std::vector<SurfaceCurve> insideBorder(const SurfaceCurve& curve,
                                       const geometry::SegmentTree& border,
                                       double margin);

double curveLength(const SurfaceCurve& curve);

/// Neighbouring open lines joined end to start, every other one reversed, where the ends are no
/// farther apart than `reach`. Points between lie on the mesh.
/// @param curves ascending by line
std::vector<SurfaceCurve> zigzag(const std::vector<SurfaceCurve>& curves,
                                 const geometry::AabbTree& surface,
                                 double reach,
                                 double maxSpacing);

/// The bead on a curve at a height above the surface: n = normal × travel, so that t × n is the
/// surface's normal. @param room that the bead has to fill, per length of the curve
/// @param folded is raised by the points at which the raised curve runs backwards
toolpath::Contour raised(const SurfaceCurve& curve,
                         double height,
                         double layerHeight,
                         double width,
                         const toolpath::FillRoom& room,
                         std::size_t& folded);

/// The pieces of a bead that lie above the substrate, cut where they pass through it.
std::vector<toolpath::Contour> aboveSubstrate(const toolpath::Contour& contour,
                                              const toolpath::Substrate& substrate);

/// Adds points on the chords so that none is longer than `maxSpacing`: raised above a convex edge,
/// neighbours move apart.
void densify(toolpath::Contour& contour, double maxSpacing);

}  // namespace wcam::cladding
