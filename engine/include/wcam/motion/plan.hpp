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

/// Branch of an arm for a whole operation: automatic, or fixed (cell::Branch in the same order).
/// Robots that are no arms have branches of their own, see cell::InverseKinematics: automatic only.
enum class BranchChoice { Auto, Nut, Nub, Ndt, Ndb, Fut, Fub, Fdt, Fdb };

/// How the torch comes from the end of a bead to the start of the next one.
enum class LinkMode {
  Retract,  ///< up to the safe height, joint move
  Direct    ///< straight at the approach height where that is clear, else as Retract
};

/// How what is free at a point is chosen: rotation about the torch, positioner, tilt, branch.
enum class RedundancyMode {
  Optimized,     ///< graph search, then smooth optimisation; never worse than the other modes
  Constant,      ///< constant rotation about the torch, positioner by gravity (Chalvin A18, A22)
  PointByPoint,  ///< rotation of each point after the one before (Chalvin A32b)
  Polynomial,    ///< rotation a polynomial of the way in each bead (Chalvin A32)
  Fixed,         ///< positioner at rest (Debout M30.1)
  ConstantToolAxis,  ///< table turns the tool axis to a constant azimuth (Debout Eq. 4-4)
  FixedToolTip,      ///< table turns the point to a constant azimuth (Debout Eq. 4-5)
  Homogeneous,       ///< table turns evenly with the path's length (Debout Eq. 4-6)
  PlanarVertical     ///< robot in one plane, torch vertical (TCP-velocity article M46)
};

inline constexpr int kRedundancyModes = 9;
/// "optimized", "constant" …
const char* redundancyKey(RedundancyMode mode);

/// Parameters of the motion of an operation.
struct MotionParams : TimeLawParams {
  RedundancyMode mode = RedundancyMode::Optimized;
  Angle torchRotation{};  ///< rotation about the tool axis (R_Z, Chalvin A18) where it is constant
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
  int polynomialDegree = 3;
  Angle tableAngle{};  ///< rest of Fixed, start of Homogeneous, azimuth α of the others
  Angle tableTurn{degToRad(360.0)};  ///< of Homogeneous, per bead
  Angle tiltTolerance{};             ///< lead and lateral tilt that may be added to the tool axis
  Angle cableLimit{};                ///< of |J4 + J6|; 0: that of the cell
  Angle cableZero{};                 ///< J4 + J6 of the untwisted cable
  Angle jointResolution{degToRad(1e-4)};  ///< σ of joints whose resolution the cell does not tell
  double weightMotion = 1.0;
  double weightPositioner = 1.0;
  double weightWinding = 0.05;
  double weightTransition = 0.001;
  double weightSpeed = 0.0;
  double weightAcceleration = 0.0;
  double weightJerk = 0.0;
  double weightGravity = 0.0;
  double weightDexterity = 0.01;
  double weightLimits = 0.01;
  double weightUncertainty = 0.0;
  double weightTcpSpeed = 0.0;

  [[nodiscard]] ObjectiveValues weights() const;
  void setWeights(const ObjectiveValues& weights);

  static const Schema<MotionParams>& schema();
};

/// Weights with which a mode is judged by what it is made for: the rotation's modes by Motion,
/// those of the positioner by Gravity, Positioner, Motion or Acceleration.
ObjectiveValues ownObjective(RedundancyMode mode);

/// Joint motion of a whole operation (Chalvin A18, A20, A22, A32, A33, A37; Debout M30).
///
/// Torch carried: the tool frame's z is the point's `axis`, the positioner turns each point's `up`
/// to the world's vertical as far as the mode wants. Part carried: the part's `axis` is turned to
/// the fixed torch's. What is free is chosen by the mode. Between beads: retract along the axis, up
/// to the safe height above all that is deposited by then, joint move, approach; or a straight line
/// between the points of retract and approach, where everything deposited within the torch's radius
/// of it lies below it by the clearance and the build direction stays within 5°. The branch of the
/// arm and full turns change only in joint moves. A segment takes its length over its speed, or
/// longer when a joint could not follow.
///
/// Optimized: see search.hpp and refine.hpp. Its result is never worse (Evaluation::betterThan)
/// with the weights of the parameters than that of any other mode. Where no motion keeps all
/// constraints the least bad one is given, and the findings tell what is broken.
///
/// Findings: motion.unreachable, motion.joint_limit, motion.cable_twist, motion.tilt,
/// motion.too_slow (violations),
/// motion.singularity, motion.joint_step, motion.speed_limited, motion.low_dexterity,
/// motion.not_vertical (warnings), motion.configuration_change (information:
/// full turns taken back between beads). One per bead and cause, with the worst value and number of
/// points.
///
/// Any robot (Cell::inverse). One that cannot turn about the tool axis takes the rotation that goes
/// with its joints; one without a closed form is followed from point to point, without graph
/// search.
///
/// A toolpath without points gives an empty motion. Independent of the number of threads. About 5
/// µs per point, optimized 100 µs; without a closed form some ms.
/// @param clearance of the operation, may be null: collisions are not looked at
/// @throws Error(JobFailed) when the cell lacks the positioner axes that the mode drives, or the
/// parameters name a branch of an arm and the robot is none
PlannedMotion planMotion(const toolpath::Toolpath& path,
                         const cell::Cell& cell,
                         const MotionParams& params,
                         const std::string& operationId,
                         const JobContext& context,
                         const collision::Clearance* clearance = nullptr);

/// Objectives and broken constraints of a motion, the one judge of all modes. About 1 µs per
/// waypoint.
Evaluation evaluateMotion(const Motion& motion,
                          const cell::Cell& cell,
                          const MotionParams& params,
                          const JobContext& context = JobContext(),
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
