// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/generatrices.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/spiral_law.hpp"

namespace wcam::toolpath {

/// One bead through all revolutions of a plan: the generatrices' points at the planned arc lengths,
/// moved onto the part (exactly on CAD surfaces), with the deposit height H = step·b of each
/// (Diourté M22, M23). One layer with one open contour that carries its revolutions.
///
/// Findings: slicing.spiral (what was made), slicing.spiral_height (heights outside the range after
/// the projection on b).
SlicedLayers spiralAlong(const geometry::PartSurface& part,
                         const Generatrices& generatrices,
                         const SpiralPlan& plan,
                         const SpiralWish& wish,
                         const JobContext& context);

}  // namespace wcam::toolpath
