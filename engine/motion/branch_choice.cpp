// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

using cell::Branch;
using cell::IkSolution;
using cell::JointVector;

constexpr std::size_t kGrain = 128;
/// A branch whose joints all keep this part of their range to the limits is good enough for a usual
/// posture to be preferred to a larger margin.
constexpr double kEnoughMargin = 0.05;

/// Distance to the nearest limit over the joint's range, of the turn that lies best inside.
double relativeMargin(const cell::Joint& joint, double value, bool periodic) {
  if (joint.endless) {
    return BranchScore::kFullMargin;
  }
  const double middle = 0.5 * (joint.min + joint.max);
  const double best = periodic ? cell::nearestTurn(value, middle) : value;
  return cell::limitMargin(joint, best) / (joint.max - joint.min);
}

void addToScore(const Cell& cell, const IkSolution& solution, BranchScore& score) {
  if (!solution.reachable) {
    ++score.unreachable;
    return;
  }
  double margin = BranchScore::kFullMargin;
  for (int j = 0; j < cell.robotJoints(); ++j) {
    margin = std::min(margin, relativeMargin(cell.joint(j), solution.joints(j),
                                             cell.arm->periodic[static_cast<std::size_t>(j)]));
  }
  if (margin < 0.0) {
    ++score.outsideLimits;
  }
  score.margin = std::min(score.margin, margin);
}

/// True when the positioner's own values lie outside their limits: counts for every branch.
bool positionerOutside(const Cell& cell, const std::array<double, 2>& values) {
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    if (cell::limitExcess(cell.joint(cell.robotJoints() + j), values[static_cast<std::size_t>(j)]) >
        0.0) {
      return true;
    }
  }
  return false;
}

void merge(const BranchScore& part, BranchScore& whole) {
  whole.unreachable += part.unreachable;
  whole.outsideLimits += part.outsideLimits;
  whole.margin = std::min(whole.margin, part.margin);
}

BranchScores emptyScores() {
  BranchScores scores;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const Branch branch = Branch::fromIndex(static_cast<int>(k));
    scores[k].unusual = (branch.elbowDown ? 1 : 0) + (branch.backwards ? 2 : 0);
  }
  return scores;
}

/// Joints of a target in the cell's order.
JointVector cellJoints(const Cell& cell,
                       const cell::Vector6& robot,
                       const std::array<double, 2>& positioner) {
  JointVector q(cell.jointCount());
  q.head<6>() = robot;
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    q(cell.robotJoints() + j) = positioner[static_cast<std::size_t>(j)];
  }
  return q;
}

PointState stateOf(const IkSolution& solution) {
  PointState state;
  state.wristSine = static_cast<float>(solution.wristSine);
  state.elbowSine = static_cast<float>(solution.elbowSine);
  state.axisDistance = static_cast<float>(solution.axisDistance);
  state.missing = solution.missing;
  return state;
}

/// Follows full turns point by point from `begin` to `end`, then moves each joint of this run by
/// whole turns so that the run lies inside its limits and nearest to where the run before ended.
void unwrapRun(const Cell& cell, Motion& motion, std::size_t begin, std::size_t end) {
  std::vector<Waypoint>& points = motion.waypoints;
  for (int j = 0; j < cell.robotJoints(); ++j) {
    if (!cell::periodicJoint(cell, j)) {
      continue;
    }
    const cell::Joint& joint = cell.joint(j);
    double low = points[begin].joints(j);
    double high = low;
    for (std::size_t i = begin + 1; i < end; ++i) {
      points[i].joints(j) = cell::nearestTurn(points[i].joints(j), points[i - 1].joints(j));
      low = std::min(low, points[i].joints(j));
      high = std::max(high, points[i].joints(j));
    }
    const double before = begin > 0 ? points[begin - 1].joints(j) : 0.0;
    const double first = points[begin].joints(j);
    // The run as one interval: it fits where its first value may lie between these bounds.
    cell::Joint room = joint;
    room.min = joint.min + (first - low);
    room.max = joint.max - (high - first);
    double start = cell::nearestTurn(first, before);
    if (room.min <= room.max) {
      start = cell::turnInLimits(room, first, before);
    } else {
      // It does not fit at all: share the excess between both sides.
      start = cell::nearestTurn(first, 0.5 * (room.min + room.max));
    }
    const double shift = start - first;
    for (std::size_t i = begin; i < end && shift != 0.0; ++i) {
      points[i].joints(j) += shift;
    }
  }
}

/// Solves again, in order, the points that a wrist or shoulder singularity left open.
void closeSingularPoints(const Cell& cell,
                         const std::vector<Target>& targets,
                         const Positioning& positioning,
                         Branch branch,
                         const MotionParams& params,
                         const std::vector<char>& open,
                         Motion& motion) {
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open[i] == 0) {
      continue;
    }
    geometry::Pose T_part_tcp;
    const geometry::Pose flange = flangePose(cell, targets[i], positioning.joints[i],
                                             params.torchRotation.value(), &T_part_tcp);
    const IkSolution solution =
        cell::inverseArm(*cell.arm, flange, branch, motion.waypoints[i - 1].joints.data());
    motion.waypoints[i].joints.head<6>() = solution.joints;
  }
}

}  // namespace

bool BranchScore::betterThan(const BranchScore& other) const {
  if (unreachable != other.unreachable) {
    return unreachable < other.unreachable;
  }
  if (outsideLimits != other.outsideLimits) {
    return outsideLimits < other.outsideLimits;
  }
  const bool enough = margin >= kEnoughMargin;
  if (enough != (other.margin >= kEnoughMargin)) {
    return enough;
  }
  if (unusual != other.unusual) {
    return unusual < other.unusual;
  }
  return margin > other.margin;
}

BranchScores scoreBranches(const Cell& cell,
                           const std::vector<Target>& targets,
                           const Positioning& positioning,
                           const MotionParams& params,
                           const JobContext& context) {
  std::vector<BranchScores> parts((targets.size() + kGrain - 1) / kGrain, emptyScores());
  parallelForChunks(
      targets.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        BranchScores& scores = parts[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
          geometry::Pose T_part_tcp;
          const geometry::Pose flange = flangePose(cell, targets[i], positioning.joints[i],
                                                   params.torchRotation.value(), &T_part_tcp);
          const cell::IkResult result = cell::inverseArm(*cell.arm, flange);
          const std::size_t outside = positionerOutside(cell, positioning.joints[i]) ? 1 : 0;
          for (std::size_t k = 0; k < result.size(); ++k) {
            addToScore(cell, result[k], scores[k]);
            scores[k].outsideLimits += outside;
          }
        }
      },
      context);
  BranchScores whole = emptyScores();
  for (const BranchScores& part : parts) {
    for (std::size_t k = 0; k < whole.size(); ++k) {
      merge(part[k], whole[k]);
    }
  }
  return whole;
}

void solveBranch(const Cell& cell,
                 const std::vector<Target>& targets,
                 const Positioning& positioning,
                 Branch branch,
                 const MotionParams& params,
                 const JobContext& context,
                 Motion& motion,
                 std::vector<PointState>& states) {
  motion.waypoints.resize(targets.size());
  states.resize(targets.size());
  std::vector<char> open(targets.size(), 0);
  parallelFor(
      targets.size(), kGrain,
      [&](std::size_t i) {
        Waypoint& point = motion.waypoints[i];
        point = targets[i].waypoint;
        const geometry::Pose flange = flangePose(cell, targets[i], positioning.joints[i],
                                                 params.torchRotation.value(), &point.T_part_tcp);
        const IkSolution solution = cell::inverseArm(*cell.arm, flange, branch);
        point.reachable = solution.reachable;
        point.joints = cellJoints(cell, solution.joints, positioning.joints[i]);
        states[i] = stateOf(solution);
        open[i] = solution.wristSingular || solution.shoulderSingular ? 1 : 0;
      },
      context);
  closeSingularPoints(cell, targets, positioning, branch, params, open, motion);
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= targets.size(); ++i) {
    if (i == targets.size() || motion.waypoints[i].kind == MoveKind::Joint) {
      context.check();
      unwrapRun(cell, motion, begin, i);
      begin = i;
    }
  }
  parallelFor(
      targets.size(), kGrain,
      [&](std::size_t i) {
        const Waypoint& point = motion.waypoints[i];
        if (point.reachable) {
          states[i].dexterity = static_cast<float>(cell::dexterity(cell, point.joints));
        }
      },
      context);
}

}  // namespace wcam::motion::detail
