// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/generatrices.hpp"
#include "wcam/toolpath/substrate.hpp"

namespace wcam::toolpath {

/// What stands above the substrate of a wall of one bead's thickness, ready for a field from its
/// lower to its upper limit.
struct WallPart {
  geometry::PartSurface surface;
  WallLimits limits;
};

/// Refines a part to an edge length, cuts away what lies below the substrate, and finds its limits:
/// the lower loop on the substrate and at most one upper loop.
///
/// Findings: those of findBase.
/// @param edge greatest mesh edge, mm
/// @throws Error(JobFailed) for a closed surface, for several pieces, for more than one lower or
/// upper border: says which and what to do
WallPart prepareWall(const geometry::PartSurface& part,
                     const Substrate& substrate,
                     double edge,
                     const JobContext& context);

}  // namespace wcam::toolpath
