// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/inverse.hpp"

#include <optional>
#include <vector>

/// All the joint values with which a robot takes a pose, and the choice among them (Debout M31).
namespace wcam::cell {

/// One way to take a pose: a branch with whole turns of the periodic joints.
struct JointCandidate {
  int branch = 0;
  JointVector joints;  ///< the robot's joints
};

/// True when the robot's joints lie inside their limits and the sums of joints too. Joints of the
/// positioner count as `positioner` (may be empty: zero).
bool admissible(const Cell& cell, const JointVector& robot, const JointVector& positioner = {});

/// All admissible candidates of a pose: every branch, every whole turn (Debout T12 for a 7-axis
/// machine), branches first, then turns of the first joint. Empty when there is none. Not for the
/// numeric method, whose branches are not distinct. About 1 µs per candidate.
std::vector<JointCandidate> candidates(const Cell& cell,
                                       const Pose& T_base_flange,
                                       const JointVector& positioner = {},
                                       const double* seed = nullptr);

/// The candidate whose largest joint is smallest, over the joints that count (Debout 4-21: C1 and
/// C2 of the 7-axis machine). Ties go to the earlier candidate.
std::optional<std::size_t> smallestJoints(const std::vector<JointCandidate>& from,
                                          const std::vector<bool>& counts);

/// The candidate whose largest change from `previous` is smallest (Debout 4-22), ties by the sum of
/// the changes, then to the earlier candidate.
std::optional<std::size_t> smallestChange(const std::vector<JointCandidate>& from,
                                          const JointVector& previous,
                                          const std::vector<bool>& counts);

}  // namespace wcam::cell
