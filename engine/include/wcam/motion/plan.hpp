// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/collision/clearance.hpp"
#include "wcam/motion/motion.hpp"
#include "wcam/motion/time_law_params.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <string>

namespace wcam::motion {

/// Branch of the arm for a whole operation: automatic, or fixed (cell::Branch in the same order).
enum class BranchChoice { Auto, Nut, Nub, Ndt, Ndb, Fut, Fub, Fdt, Fdb };

/// How the torch comes from the end of a bead to the start of the next one.
enum class LinkMode {
  Retract,  ///< up to the safe height, joint move
  Direct    ///< straight at the approach height where that is clear, else as Retract
};

/// Parameters of the motion of an operation.
struct MotionParams : TimeLawParams {
  Angle torchRotation{};  ///< constant rotation about the tool axis (R_Z, Chalvin A18)
  BranchChoice branch = BranchChoice::Auto;
  Length approachHeight{20.0};
  Length safeHeight{50.0};
  LinkMode link = LinkMode::Retract;
  Length linkClearance{10.0};  ///< of direct links above what is deposited
  Length torchRadius{30.0};    ///< what stands higher must be this far beside a direct link
  Speed travelSpeed{50.0};
  double jointSpeedRatio = 0.3;
  double minDexterity = 0.05;
  Angle wristMargin{degToRad(5.0)};
  Angle elbowMargin{degToRad(5.0)};
  Length shoulderMargin{50.0};
  Angle maxJointStep{degToRad(30.0)};
  Angle verticalTolerance{degToRad(1.0)};

  bool checkCollisions = true;
  Length safetyDistance{5.0};
  bool exitRotations = false;
  Angle exitLateral{degToRad(30.0)};
  Angle exitLead{degToRad(10.0)};
  double exitRate = 2.0;  ///< degrees per mm

  static const Schema<MotionParams>& schema();
};

/// Joint motion of a whole operation with a constant rotation about the torch (Chalvin A18, A20,
/// A22, A37).
///
/// Torch carried: the positioner turns each point's `up` to the world's vertical, the tool frame's
/// z is the point's `axis`. Part carried: the part's `axis` is turned to the fixed torch's. One
/// branch of the arm for all points; joints are unwrapped inside their limits, full turns change
/// only in joint moves. Between beads: retract along the axis, up to the safe height above all that
/// is deposited by then, joint move, approach; or a straight line between the points of retract and
/// approach, where everything deposited within the torch's radius of it lies below it by the
/// clearance and the build direction stays within 5°. A segment takes its length over its speed, or
/// longer when a joint could not follow.
///
/// Findings: motion.unreachable and motion.joint_limit (violations), motion.singularity,
/// motion.joint_step, motion.speed_limited, motion.low_dexterity, motion.not_vertical (warnings),
/// motion.configuration_change (information: full turns taken back between beads). One per bead and
/// cause, with the worst value and the number of points.
///
/// A toolpath without points gives an empty motion. Independent of the number of threads. About
/// 3 µs per point.
/// @param clearance of the operation, may be null
/// @throws Error(JobFailed) when the cell's robot has no closed-form inverse kinematics
PlannedMotion planMotion(const toolpath::Toolpath& path,
                         const cell::Cell& cell,
                         const MotionParams& params,
                         const std::string& operationId,
                         const JobContext& context,
                         const collision::Clearance* clearance = nullptr);

/// Fills time and tcpSpeed of all waypoints. The length of the path is the master: linear moves
/// between two stops follow wcam/motion/speed_law.hpp with the wanted speed as the cap; joint moves
/// go from rest to rest. The torch stops where the program does: at its ends, at joint moves, where
/// the arc goes on or off. Without any acceleration (cell file, parameters) speeds change at once:
/// a segment takes its length over its speed, or longer when a joint could not follow. Points at
/// which nothing moves take no time. With wireFollowsSpeed the wire feed is lowered with the speed.
void applyTimeLaw(Motion& motion,
                  const cell::Cell& cell,
                  const TimeLawParams& params,
                  double jointSpeedRatio,
                  const JobContext& context = JobContext());

/// Figures of a motion; branch and maxVerticalError are left to the planner.
MotionStatistics motionStatistics(const Motion& motion,
                                  const cell::Cell& cell,
                                  const JobContext& context = JobContext());

}  // namespace wcam::motion
