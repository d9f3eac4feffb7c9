// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <memory>
#include <vector>

namespace wcam::toolpath {

/// Moves the points of walls and junctions onto the meshes of the parts as they were given: a
/// refined mesh lies beside the original one where edges were flipped over bent facets, and a
/// circle beside facets. Each point goes to the nearest point of its part; normals stay. Points
/// that then coincide with the one before are dropped, contours and layers without length too, and
/// where neighbours came farther apart than the sampling allows their middle is put between them.
/// Exact parts are left as they are: their points lie on the surface already.
/// @param parts by Contour::part
/// @throws Error(JobFailed) when nothing is left
/// Cost: O(log n) per point, parallel.
void moveOntoParts(SlicedLayers& sliced,
                   const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                   const Sampling& sampling,
                   const JobContext& context = JobContext());

}  // namespace wcam::toolpath
