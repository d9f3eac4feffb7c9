// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wcam::toolpath {

/// Sets the height of every contour point to step/|∇φ|, with |∇φ| averaged at the vertices by area
/// and linear between them (DESIGN 3). Points without a gradient keep theirs.
/// Cost: one nearest-point query per point.
void setFieldHeights(SlicedLayers& sliced,
                     const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                     const VertexField& field,
                     double step);

/// Looks whether all heights lie within what the process can deposit. Finding
/// slicing.height_out_of_range: how many points, the worst place and by how much, and a step that
/// would do, or the ratio of heights that the part needs when none does.
/// @param otherwise what to try when no step would do
void reportHeights(const SlicedLayers& sliced,
                   const BeadRange& bead,
                   double step,
                   const Text& otherwise,
                   const JobContext& context);

/// Finding slicing.grows_down: layers whose mean direction of growth points below the horizon, as
/// where a distance reaches over the top of a part and down again.
void reportDownward(const SlicedLayers& sliced, const Vec3& up, const JobContext& context);

}  // namespace wcam::toolpath
