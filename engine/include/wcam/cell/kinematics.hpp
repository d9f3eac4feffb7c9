// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"

namespace wcam::cell {

// Forward kinematics. `q` is the whole joint vector of the cell (robot, then positioner).

Pose T_base_flange(const Cell& cell, const JointVector& q);
/// The TCP in the base frame; constant when the robot carries the part.
Pose T_base_tcp(const Cell& cell, const JointVector& q);
/// The positioner's table, or the table on the flange when the robot carries the part.
Pose T_base_table(const Cell& cell, const JointVector& q);
Pose T_base_part(const Cell& cell, const JointVector& q);
Pose T_part_tcp(const Cell& cell, const JointVector& q);

/// Geometric Jacobian of the robot (6 × robot joints) in the base frame: of the TCP when the robot
/// carries the torch, of the flange point under the TCP when it carries the part.
Jacobian robotJacobian(const Cell& cell, const JointVector& q);
/// Velocity of the TCP in the part frame per joint velocity (3 × all joints; TCP-velocity article
/// M43, signs corrected). mm/rad.
PartJacobian partJacobian(const Cell& cell, const JointVector& q);
/// Ratio of the smallest to the largest singular value of the robot's block of partJacobian
/// (Chalvin Eq. 1.8, linear block), 0..1. Of a machine with three prismatic joints: of their
/// columns.
double dexterity(const Cell& cell, const JointVector& q);

/// Joint speeds from motor speeds (rpm) by the reduction ratios of the file (M43), rad/s or mm/s.
/// @throws Error(InvalidArgument) when the sizes differ or a ratio is unknown
JointVector jointSpeedsFromMotors(const Cell& cell, const JointVector& motorRpm);

}  // namespace wcam::cell
