// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"
#include "wcam/motion/motion.hpp"

#include <vector>

namespace wcam::motion {

/// Smallest way back that counts as a reversal, rad and mm: below it is rounding of the planning.
constexpr double kReversalDeadBand = 1e-6;

/// Joints that turn round (Carrière M29). A reversal lies at the waypoint where the joint is at its
/// extreme; where it rests there over several waypoints, at the last of them. `deadBand` (rad, mm)
/// is the least way back that makes one. In order of the waypoints, then of the joints.
std::vector<Reversal> jointReversals(const Motion& motion,
                                     const cell::Cell& cell,
                                     double deadBand = kReversalDeadBand);

}  // namespace wcam::motion
