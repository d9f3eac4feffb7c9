// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"

namespace wcam::geometry {

/// The same surface with no mesh edge longer than `maxEdge`, for fields that live on vertices (a
/// CAD tessellation has long thin triangles on cylinders and none inside planes). New vertices of
/// CAD parts lie on the exact surface and on the CAD edges, and the binding follows; on meshes they
/// halve their edge. Edges are then flipped towards Delaunay inside faces and smooth regions, so
/// that slivers vanish; borders, CAD edges and sharp edges stay. The result depends on the shape,
/// not on the order of the triangles' corners.
/// @throws Error(InvalidArgument) when maxEdge would give more than 20 million triangles: names an
/// edge length that works
/// Cost: O(n log n) in the triangles made.
PartSurface refineSurface(const PartSurface& surface,
                          double maxEdge,
                          const JobContext& context = JobContext());

/// Edge length for fields on a part of which layers of this step are wanted: fine enough for the
/// step, limited to a number of triangles that the part's area allows.
double fieldEdgeLength(const PartSurface& surface, double step);

}  // namespace wcam::geometry
