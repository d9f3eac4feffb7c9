// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/joints.hpp"
#include "wcam/geometry/types.hpp"
#include "wcam/motion/objective.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace wcam::motion {

using cell::JointVector;
using geometry::Pose;

enum class MoveKind {
  Joint,  ///< all axes together, path not controlled: between beads
  Linear  ///< straight line of the TCP in the part frame
};

/// Where a robot position comes from and what is wanted of the move that ends there.
struct WantedMove {
  MoveKind kind = MoveKind::Linear;
  bool arc = false;  ///< the arc burns during the move that ends here
  int layer = -1;
  int bead = -1;
  int point = -1;          ///< −1 for approach, retract and travel moves
  double speed = 0.0;      ///< wanted TCP speed of the move that ends here, in the part frame, mm/s
  double wireSpeed = 0.0;  ///< mm/s
  /// How many points of the toolpath (all layers and beads, in order) are deposited when the torch
  /// is here.
  std::size_t deposited = 0;
};

/// One robot position. Times are seconds from the start of the operation.
struct Waypoint : WantedMove {
  Pose T_part_tcp = Pose::Identity();  ///< tool frame in the part frame; z of the tool frame is the
                                       ///< tool axis (towards the torch)
  JointVector joints;
  double time = 0.0;      ///< s, from the time law
  double pause = 0.0;     ///< s that the torch stands here before it goes on (withPauses)
  double tcpSpeed = 0.0;  ///< predicted TCP speed in the part frame, mm/s
  /// False where the robot cannot come: joints then hold the arm stretched towards the point (or
  /// the joints before it), and the TCP is not at T_part_tcp.
  bool reachable = true;
  double verticalError = 0.0;       ///< angle between the point's up and the vertical, rad
  double leastVerticalError = 0.0;  ///< the same with the positioner's axes at their best, rad
  double tilt = 0.0;  ///< angle between the tool axis and the toolpath's one (lead, lateral), rad
};

/// The motion of one operation.
struct Motion {
  std::vector<Waypoint> waypoints;
};

/// What one joint does over an operation; rad, or mm.
struct JointStatistics {
  double min = 0.0;
  double max = 0.0;
  double margin = 0.0;         ///< to the nearest limit, negative outside, infinite when endless
  double maxSpeedRatio = 0.0;  ///< greatest speed over the joint's maximum
};

/// A joint that turns round (Carrière M29).
struct Reversal {
  std::size_t waypoint = 0;
  int joint = 0;
  int direction = 1;  ///< of the joint afterwards, +1 or −1
  double time = 0.0;  ///< s
  /// Step of the TCP in the part frame by the joint's backlash, mm; zero when that is not known.
  geometry::Vec3 effect = geometry::Vec3::Zero();
};

/// Figures of a motion for the report.
struct MotionStatistics {
  std::vector<JointStatistics> joints;  ///< in the cell's order
  double minDexterity = 1.0;            ///< Chalvin Eq. 1.8, linear block; over reachable waypoints
  double maxJointSpeedRatio = 0.0;
  double totalTime = 0.0;  ///< s
  double arcTime = 0.0;    ///< s
  double maxVerticalError =
      0.0;  ///< angle between a point's up and the vertical, torch carried, rad
  std::size_t unreachableWaypoints = 0;
  std::vector<Reversal> reversals;  ///< of all joints, in order
  std::string branch;  ///< cell::InverseKinematics::branchName: "NUT" …, "A+" …; "NUT/FUT" when
                       ///< it changes between beads
  std::string mode;    ///< the redundancy mode that made the motion, see RedundancyMode
  double maxCableTwist = 0.0;  ///< greatest |J4 + J6| from the cable's zero while on beads, rad
  double maxTilt = 0.0;        ///< greatest lead and lateral tilt added to the toolpath's axis, rad
  Evaluation evaluation;       ///< objectives and broken constraints, see evaluateMotion
};

/// What planMotion returns.
struct PlannedMotion {
  Motion motion;
  MotionStatistics statistics;
};

}  // namespace wcam::motion
