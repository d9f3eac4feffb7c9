// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

/// The redundancy modes: each from a task to free choices and branches. Private to this module.
namespace wcam::motion::detail {

/// Constant rotation about the torch, the positioner by gravity, the better of its two ways
/// (Chalvin A18, A22). Any cell.
Resolution resolveConstant(const Task& task, const JobContext& context);
/// Rotation of each point with the least weighted motion from the point before, inside the limits
/// and above the least dexterity (Chalvin A32b). Any cell. About 60 µs per point.
Resolution resolvePointByPoint(const Task& task, const JobContext& context);
/// Rotation of each bead a polynomial of its length with the least sum of weighted motion (Chalvin
/// A32, Eq. 4.1–4.6), scaled to [−1, 1], from many starts. Any cell.
Resolution resolvePolynomial(const Task& task, const JobContext& context);
/// Positioner at rest: the table at MotionParams::tableAngle, a tilting axis where the first point
/// is upright (Debout M30.1). Any cell.
Resolution resolveFixed(const Task& task, const JobContext& context);
/// Table at α − ω, ω the azimuth of the tool axis (Debout Eq. 4-4). Needs a positioner.
Resolution resolveConstantToolAxis(const Task& task, const JobContext& context);
/// Table at α − ω, ω the azimuth of the point (Debout Eq. 4-5). Needs a positioner.
Resolution resolveFixedToolTip(const Task& task, const JobContext& context);
/// Table turns by tableTurn over each bead, evenly with its length (Debout Eq. 4-6). Needs a
/// positioner.
Resolution resolveHomogeneous(const Task& task, const JobContext& context);
/// Table turns the point into the plane through its axis that is square to the tilting axis, the
/// torch is vertical (TCP-velocity article M46). Needs a positioner.
Resolution resolvePlanarVertical(const Task& task, const JobContext& context);
/// Graph search and smooth refinement, the best of all (see search.hpp and refine.hpp). Any cell.
Candidate resolveOptimized(const Task& task,
                           const JobContext& context,
                           const collision::Clearance* clearance);

/// The best of the other modes, without a search of its own.
Candidate bestNamed(const Task& task,
                    const JobContext& context,
                    const collision::Clearance* clearance);

/// One of the modes above except Optimized.
/// @throws Error(JobFailed) when the cell lacks the axes that the mode drives
Resolution resolveNamed(RedundancyMode mode, const Task& task, const JobContext& context);
/// True when the mode drives a positioner that the cell does not have.
bool lacksPositioner(RedundancyMode mode, const Cell& cell);

/// A constant rotation and given positioner values; travel moves take those of their bead's end.
std::vector<FreeChoice> constantRotation(const Task& task,
                                         const std::vector<PositionerValues>& positioner);
/// Copies the choice of each bead's first and last target to the travel moves beside it.
void spreadToTravel(const Runs& runs, std::vector<FreeChoice>& choices);

}  // namespace wcam::motion::detail
