// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/arm.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/motion/speed_law.hpp"

#include <array>
#include <cstddef>
#include <vector>

/// Stages of planMotion. Private to this module.
namespace wcam::motion::detail {

using cell::Cell;
using geometry::Pose;
using geometry::Vec3;
using PositionerValues = std::array<double, 2>;

/// A waypoint before the robot is asked: where and how, in the part frame.
struct Target {
  Vec3 p = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  Vec3 up = Vec3::UnitZ();
  Vec3 along = Vec3::UnitX();  ///< direction of travel; lead tilts towards it
  WantedMove waypoint;
};

/// Waypoints of an operation: beads with retract, travel and approach moves around them.
std::vector<Target> makeTargets(const toolpath::Toolpath& path,
                                const MotionParams& params,
                                const JobContext& context);

/// Targets of one bead, and where its travel moves end: [first, last] lie on the bead, the targets
/// from `begin` to `first` approach it and those after `last` up to `end` leave it. The travel
/// moves take the free choice of the bead's nearest end.
struct Segment {
  std::size_t begin = 0, first = 0, last = 0, end = 0;
  std::size_t run = 0;
};

/// Runs are the targets between two joint moves: one branch of the arm for each.
struct Runs {
  std::vector<std::size_t> begins;  ///< of each run, then the number of targets
  std::vector<Segment> segments;

  [[nodiscard]] std::size_t count() const { return begins.size() - 1; }
};

Runs findRuns(const std::vector<Target>& targets);

/// What is free at a target (DESIGN 9: rotation about the torch, positioner, tilt).
struct FreeChoice {
  double torchRotation = 0.0;  ///< third Bryant angle of the tool frame or of the part (A18), rad
  PositionerValues positioner{};  ///< controller values, continuous inside a run
  double lead = 0.0;              ///< tilt towards the travel direction, rad
  double lateral = 0.0;           ///< tilt to the left of it, rad
};

/// What a mode gives: the free choice of each target and the branch of each run.
struct Resolution {
  std::vector<FreeChoice> choices;
  std::vector<int> branches;  ///< of Cell::inverse
};

/// Positioner values of every target that turn `up` to the vertical as far as they can (unused
/// entries 0), continuous over the operation.
struct Positioning {
  std::vector<PositionerValues> joints;
  std::vector<double> residual;  ///< angle between up and the vertical, rad
};

/// @param family which of the two solutions the first target takes (0 or 1)
Positioning positionPart(const Cell& cell,
                         const std::vector<Target>& targets,
                         int family,
                         const JobContext& context);
/// Angle between the vertical and `up` (part frame) at given positioner values; 0 when the robot
/// carries the part.
double verticalError(const Cell& cell, const Vec3& up, const PositionerValues& positioner);

/// The parameters with the cable limit of the cell where they give none.
MotionParams withCable(const MotionParams& params, const Cell& cell);

/// What all modes work on.
struct Task {
  const Cell& cell;
  const MotionParams& params;
  std::vector<Target> targets;
  Runs runs;
  /// Gravity-aligned positions: two where the positioner has two ways, else one; [0] also when the
  /// robot carries the part (all zero). Where exact ones turn the table faster than it can, or over
  /// for nothing, slower ones within the vertical tolerance (table_reference.hpp).
  std::vector<Positioning> aligned;
  /// What the search and the refinement start from.
  std::vector<Positioning> references;
};

// Poses (poses.cpp).

/// The tool axis of a target with lead and lateral tilt, part frame.
Vec3 tiltedAxis(const Target& target, double lead, double lateral);
/// The flange for a tool axis, from the pose of the part.
Pose flangePose(const Cell& cell, const Target& target, const FreeChoice& choice, Pose* T_part_tcp);

/// What the inverse kinematics told about a waypoint, for the findings.
struct PointState {
  float wristSine = 1.0F;
  float elbowSine = 1.0F;
  float axisDistance = 0.0F;
  float dexterity = 1.0F;
  double missing = 0.0;      ///< mm
  double missingTilt = 0.0;  ///< rad
};

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

using BranchScores = std::array<BranchScore, cell::InverseKinematics::kMostBranches>;
BranchScores scoreBranches(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context);
/// The best branch that the parameters allow, the same for all runs.
std::vector<int> oneBranch(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context,
                           BranchScore* score = nullptr);
/// The parameters name branches of an arm; other robots use any.
bool mayUse(const Cell& cell, const MotionParams& params, int branch);

/// @throws Error(JobFailed) when the parameters name a branch that only an arm has
void checkBranch(const Cell& cell, const MotionParams& params, const Text& place);

/// A robot without a closed form is followed from point to point: its branches are start postures.
bool isFollowed(const Cell& cell);

/// Joints of all waypoints: inverse kinematics in each run's branch, full turns inside the limits
/// and with the least motion between runs. `states` may be null.
Motion solveMotion(const Task& task,
                   const Resolution& resolution,
                   const JobContext& context,
                   std::vector<PointState>* states = nullptr);
/// The same into a motion whose memory is used again.
void solveMotion(const Task& task,
                 const Resolution& resolution,
                 const JobContext& context,
                 Motion& motion,
                 std::vector<PointState>* states = nullptr);

/// A mode's answer with its joints and their worth.
struct Candidate {
  RedundancyMode mode = RedundancyMode::Constant;
  Resolution resolution;
  Motion motion;
  Evaluation evaluation;
};

Candidate makeCandidate(const Task& task,
                        RedundancyMode mode,
                        Resolution resolution,
                        const JobContext& context,
                        const collision::Clearance* clearance);

// Evaluation (evaluation.cpp).

/// Time in which a joint whose acceleration the cell file does not tell reaches its greatest speed,
/// and that acceleration its jerk, s: a usual figure of 6-axis robots of this size.
inline constexpr double kRampTime = 0.25;
double accelerationScale(const cell::Joint& joint);
double jerkScale(const cell::Joint& joint);
/// How far a sum of joints lies outside its limits, rad or mm; 0 inside.
double sumExcess(const cell::JointSum& sum, const cell::JointVector& q);
/// States of a motion that are compared with the cell between two questions for a cancel: some 50
/// µs each on one core.
inline constexpr std::size_t kStatesBetweenChecks = 4096;
std::vector<float> clearanceOf(const Motion& motion,
                               const collision::Clearance& clearance,
                               const JobContext& context);

/// Collects findings per bead and adds them in order.
void reportFindings(const Cell& cell,
                    const Motion& motion,
                    const std::vector<PointState>& states,
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

/// Objective::TcpSpeed of a motion whose times are known: the mean over the points of beads.
double speedLoss(const Motion& motion);

/// Where the torch crawls, dips and peaks of the predicted speed, and reversals of joints, per
/// bead.
/// @param path of the motion: how wide the beads are
void reportSpeeds(const Cell& cell,
                  const Motion& motion,
                  const toolpath::Toolpath& path,
                  const MotionParams& params,
                  const std::string& operationId,
                  const std::vector<Reversal>& reversals,
                  const JobContext& context);

/// Declares the parameters of TimeLawParams.
void addTimeLaw(Schema<MotionParams>& schema);

}  // namespace wcam::motion::detail
