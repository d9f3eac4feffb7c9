// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/arm.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/motion/speed_law.hpp"

#include <array>
#include <vector>

/// Stages of planMotion. Private to this module.
namespace wcam::motion::detail {

using cell::Cell;
using geometry::Vec3;

/// A waypoint before the robot is asked: where and how, in the part frame.
struct Target {
  Vec3 p = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  Vec3 up = Vec3::UnitZ();
  Waypoint waypoint;  ///< everything but pose, joints and times
};

/// Waypoints of an operation: beads with retract, travel and approach moves around them.
std::vector<Target> makeTargets(const toolpath::Toolpath& path,
                                const MotionParams& params,
                                const JobContext& context);

/// Positioner values of every target (unused entries 0), continuous over the operation.
struct Positioning {
  std::vector<std::array<double, 2>> joints;
  std::vector<double> residual;  ///< angle between up and the vertical, rad
};

/// @param family which of the two solutions the first target takes (0 or 1)
Positioning positionPart(const Cell& cell,
                         const std::vector<Target>& targets,
                         int family,
                         const JobContext& context);

/// Flange pose that puts the tool on a target; sets the pose of the tool in the part too.
geometry::Pose flangePose(const Cell& cell,
                          const Target& target,
                          const std::array<double, 2>& positioner,
                          double torchRotation,
                          geometry::Pose* T_part_tcp);

/// How good a branch is over all targets, compared in this order: points out of reach, points
/// outside limits, enough margin to the limits, usual posture (shoulder to the front, elbow up: the
/// others meet the table or the robot's own base more easily), largest margin.
struct BranchScore {
  static constexpr double kFullMargin = 0.5;  ///< a joint in the middle of its range
  std::size_t unreachable = 0;
  std::size_t outsideLimits = 0;
  double margin = kFullMargin;  ///< smallest distance to a limit over the joint's range
  int unusual = 0;              ///< 1 for elbow down, 2 for shoulder to the back, 3 for both
  [[nodiscard]] bool betterThan(const BranchScore& other) const;
};

using BranchScores = std::array<BranchScore, cell::Branch::kCount>;
BranchScores scoreBranches(const Cell& cell,
                           const std::vector<Target>& targets,
                           const Positioning& positioning,
                           const MotionParams& params,
                           const JobContext& context);

/// What the inverse kinematics told about a waypoint, for the findings.
struct PointState {
  float wristSine = 1.0F;
  float elbowSine = 1.0F;
  float axisDistance = 0.0F;
  float dexterity = 1.0F;
  double missing = 0.0;
};

/// Joints of all waypoints in one branch, unwrapped.
void solveBranch(const Cell& cell,
                 const std::vector<Target>& targets,
                 const Positioning& positioning,
                 cell::Branch branch,
                 const MotionParams& params,
                 const JobContext& context,
                 Motion& motion,
                 std::vector<PointState>& states);

/// Collects findings per bead and adds them in order.
void reportFindings(const Cell& cell,
                    const Motion& motion,
                    const std::vector<PointState>& states,
                    const Positioning& positioning,
                    const MotionParams& params,
                    const std::string& operationId,
                    const JobContext& context);

/// Time that the slowest joint needs for a step at a part of its greatest speed.
double jointTime(const Cell& cell,
                 const cell::JointVector& from,
                 const cell::JointVector& to,
                 double ratio);

/// Limits of the joints for the speed law.
std::vector<JointBounds> jointBounds(const Cell& cell, const TimeLawParams& params);

/// True where the torch comes to rest at a waypoint: ends, joint moves, arc on and off.
bool stopsAfter(const Motion& motion, std::size_t i);

/// Dips and peaks of the predicted speed and reversals of joints, per bead.
void reportSpeeds(const Cell& cell,
                  const Motion& motion,
                  const MotionParams& params,
                  const std::string& operationId,
                  const std::vector<Reversal>& reversals,
                  const JobContext& context);

/// Declares the parameters of TimeLawParams.
void addTimeLaw(Schema<MotionParams>& schema);

}  // namespace wcam::motion::detail
