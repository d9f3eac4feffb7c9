// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/generatrices.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/spiral_law.hpp"

#include <optional>

namespace wcam::toolpath {

/// One bead through all revolutions of a plan: the generatrices' points at the planned arc lengths,
/// moved onto the part (exactly on CAD surfaces), with the deposit height H = step·b of each
/// (Diourté M22, M23). One layer with one open contour that carries its revolutions.
///
/// @param thinning drops points that neither the chord error nor the spacing needs
/// Findings: slicing.spiral (what was made), slicing.spiral_height (heights outside the range of
/// their zone after the projection on b).
SlicedLayers spiralAlong(const geometry::PartSurface& part,
                         const Generatrices& generatrices,
                         const SpiralPlan& plan,
                         const SpiralWish& wish,
                         const JobContext& context,
                         const std::optional<Sampling>& thinning = {});

/// The spiral as one level set: of φ − (turn fraction), φ the mean height above the lower border in
/// a field that follows both limits, the turn fraction a field that grows from 0 to 1 around the
/// wall. Curves end and begin at the same point of the cut where the fraction jumps, so that
/// nothing is linked. Points lie on the mesh's edges (of CAD parts: moved onto the exact surface),
/// heights are step/|∇φ|.
///
/// Against generatrices it needs no points per revolution and follows the field itself; the number
/// of revolutions is that of the mean generatrix.
/// Heights outside of the range are findings: slicing.spiral_height as far as they are noise, else
/// slicing.spiral_infeasible.
/// @param surface the part before it was refined: points go onto it
/// @throws Error(JobFailed) as decomposeWall and planSpiral
SlicedLayers spiralOnField(const geometry::PartSurface& part,
                           const geometry::PartSurface& surface,
                           const WallLimits& limits,
                           const SpiralWish& wish,
                           const Sampling& sampling,
                           const JobContext& context);

}  // namespace wcam::toolpath
