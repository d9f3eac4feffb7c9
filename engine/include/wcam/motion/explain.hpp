// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"
#include "wcam/motion/plan.hpp"

#include <vector>

namespace wcam::motion {

/// Findings with remedies that have been tried: for every motion.unreachable, motion.joint_limit,
/// motion.cable_twist, motion.singularity, motion.collision and motion.near_collision of a bead,
/// changes are made to the worst point of the bead, the smallest first, and those that put it right
/// are tried at points spread over the bead. In this order: another rotation about the torch;
/// another configuration of the arm; the positioner's other solution; a lead or lateral tilt within
/// the tolerances; the part moved or turned on its table; the positioner moved in the base; the
/// cell's other configuration (part carried instead of torch carried, or the other way round;
/// Cell::other).
///
/// "Right" means reachable, inside the limits, outside the singularity margins of `params`, and
/// free by the model (when there is one). The remedy is a hint: it tells the change with its figure
/// and for how many of the points it serves, or that nothing that was tried does; data gets cure_*
/// figures. Positions between the points, joint steps and speeds are not looked at: who plans the
/// whole operation with the change knows. The change that a project can be given goes to data as
/// try_* figures: rotation_deg and branch of the torch, exit_rotations, turn_deg and table_*_mm of
/// the part on its table, other_branch in the cell's other configuration.
///
/// The worst kExplained findings are explained (a sixth of them where the inverse kinematics are
/// numeric); each costs about 1 to 30 ms.
/// @param path that the motion follows
/// @param collision may be null
std::vector<Diagnostic> explainFindings(std::vector<Diagnostic> findings,
                                        const Motion& motion,
                                        const toolpath::Toolpath& path,
                                        const cell::Cell& cell,
                                        const collision::CellCollision* collision,
                                        const MotionParams& params,
                                        const JobContext& context);

inline constexpr int kExplained = 24;

}  // namespace wcam::motion
