// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <memory>
#include <vector>

namespace wcam::toolpath {

/// Looks what of the parts the layers leave out, whatever strategy made them.
///
/// Findings:
/// - slicing.below_plate: a part reaches below the plate, and what lies there gets no layers: how
///   deep it reaches, and by how much it has to be raised;
/// - slicing.floating: a part stands neither on the plate nor on another part: how high it floats;
/// - slicing.bead_in_plate: beads lie inside the plate (layers around an axis): how deep and where,
/// a
///   violation;
/// - slicing.uncovered: faces farther from every bead than a bead or a layer reaches, between the
///   layers or inside them (near-horizontal ones, the top of a solid that is only outlined): their
///   area, the place farthest from a bead, and the strategy that would cover them. What lies below
///   the first or above the last layer does not count, nor do cladding and imported paths.
/// Cost: one nearest-bead query per triangle, more where the surface is far from all beads.
void reportLeftOut(const SlicedLayers& sliced,
                   const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                   const Substrate& substrate,
                   const BeadRange& bead,
                   const JobContext& context);

}  // namespace wcam::toolpath
