// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/joints.hpp"
#include "wcam/geometry/types.hpp"

#include <string>
#include <vector>

namespace wcam::motion {

using cell::JointVector;
using geometry::Pose;

enum class MoveKind {
  Joint,  ///< all axes together, path not controlled: between beads
  Linear  ///< straight line of the TCP in the part frame
};

/// One robot position with where it comes from. Times are seconds from the start of the operation.
struct Waypoint {
  MoveKind kind = MoveKind::Linear;
  bool arc = false;  ///< the arc burns during the move that ends here
  int layer = -1;
  int bead = -1;
  int point = -1;                      ///< −1 for approach, retract and travel moves
  Pose T_part_tcp = Pose::Identity();  ///< tool frame in the part frame; z of the tool frame is the
                                       ///< tool axis (towards the torch)
  JointVector joints;
  double speed = 0.0;      ///< wanted TCP speed of the move that ends here, in the part frame, mm/s
  double wireSpeed = 0.0;  ///< mm/s
  double time = 0.0;       ///< s, from the time law
  double tcpSpeed = 0.0;   ///< predicted TCP speed in the part frame, mm/s
};

/// The motion of one operation.
struct Motion {
  std::vector<Waypoint> waypoints;
};

}  // namespace wcam::motion
