// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints from free choices: with search_states.cpp the only place that calls inverse kinematics.

#include "wcam/base/parallel.hpp"
#include "wcam/cell/unwrap.hpp"

#include "plan_detail.hpp"
#include "turns.hpp"

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
bool positionerOutside(const Cell& cell, const PositionerValues& values) {
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
                       const PositionerValues& positioner) {
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

/// The run of each target.
std::vector<std::size_t> runOfTargets(const Runs& runs) {
  std::vector<std::size_t> run(runs.begins.back());
  for (std::size_t r = 0; r < runs.count(); ++r) {
    std::fill(run.begin() + static_cast<std::ptrdiff_t>(runs.begins[r]),
              run.begin() + static_cast<std::ptrdiff_t>(runs.begins[r + 1]), r);
  }
  return run;
}

/// Solves again, in order, the points that a wrist or shoulder singularity left open.
void closeSingularPoints(const Task& task,
                         const Resolution& resolution,
                         const std::vector<std::size_t>& run,
                         const std::vector<char>& open,
                         Motion& motion) {
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open[i] == 0) {
      continue;
    }
    Pose T_part_tcp;
    const Pose flange = flangePose(task.cell, task.targets[i], resolution.choices[i], &T_part_tcp);
    const IkSolution solution = cell::inverseArm(
        *task.cell.arm, flange, resolution.branches[run[i]], motion.waypoints[i - 1].joints.data());
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

bool mayUse(const MotionParams& params, int branch) {
  return params.branch == BranchChoice::Auto || static_cast<int>(params.branch) - 1 == branch;
}

BranchScores scoreBranches(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context) {
  const Cell& cell = task.cell;
  std::vector<BranchScores> parts((choices.size() + kGrain - 1) / kGrain, emptyScores());
  parallelForChunks(
      choices.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        BranchScores& scores = parts[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
          Pose T_part_tcp;
          const Pose flange = flangePose(cell, task.targets[i], choices[i], &T_part_tcp);
          const cell::IkResult result = cell::inverseArm(*cell.arm, flange);
          const std::size_t outside = positionerOutside(cell, choices[i].positioner) ? 1 : 0;
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

std::vector<Branch> oneBranch(const Task& task,
                              const std::vector<FreeChoice>& choices,
                              const JobContext& context,
                              BranchScore* score) {
  const BranchScores scores = scoreBranches(task, choices, context);
  int best = -1;
  for (int k = 0; k < Branch::kCount; ++k) {
    if (mayUse(task.params, k) && (best < 0 || scores[static_cast<std::size_t>(k)].betterThan(
                                                   scores[static_cast<std::size_t>(best)]))) {
      best = k;
    }
  }
  if (score != nullptr) {
    *score = scores[static_cast<std::size_t>(best)];
  }
  return std::vector<Branch>(task.runs.count(), Branch::fromIndex(best));
}

Motion solveMotion(const Task& task,
                   const Resolution& resolution,
                   const JobContext& context,
                   std::vector<PointState>* states) {
  Motion motion;
  solveMotion(task, resolution, context, motion, states);
  return motion;
}

void solveMotion(const Task& task,
                 const Resolution& resolution,
                 const JobContext& context,
                 Motion& motion,
                 std::vector<PointState>* states) {
  const Cell& cell = task.cell;
  const std::vector<Target>& targets = task.targets;
  const std::vector<std::size_t> run = runOfTargets(task.runs);
  motion.waypoints.resize(targets.size());
  if (states != nullptr) {
    states->resize(targets.size());
  }
  std::vector<char> open(targets.size(), 0);
  parallelFor(
      targets.size(), kGrain,
      [&](std::size_t i) {
        Waypoint& point = motion.waypoints[i];
        const FreeChoice& choice = resolution.choices[i];
        point = targets[i].waypoint;
        const Pose flange = flangePose(cell, targets[i], choice, &point.T_part_tcp);
        const IkSolution solution =
            cell::inverseArm(*cell.arm, flange, resolution.branches[run[i]]);
        point.reachable = solution.reachable;
        point.joints = cellJoints(cell, solution.joints, choice.positioner);
        point.verticalError = verticalError(cell, targets[i].up, choice.positioner);
        point.leastVerticalError = task.aligned[0].residual[i];
        const Vec3 axis = point.T_part_tcp.linear().col(2);
        point.tilt =
            choice.lead == 0.0 && choice.lateral == 0.0
                ? 0.0
                : std::atan2(axis.cross(targets[i].axis).norm(), axis.dot(targets[i].axis));
        open[i] = solution.wristSingular || solution.shoulderSingular ? 1 : 0;
        if (states != nullptr) {
          (*states)[i] = stateOf(solution);
        }
      },
      context);
  closeSingularPoints(task, resolution, run, open, motion);
  chooseTurns(task, motion, context);
}

Candidate makeCandidate(const Task& task,
                        RedundancyMode mode,
                        Resolution resolution,
                        const JobContext& context,
                        const collision::Clearance* clearance) {
  Candidate candidate;
  candidate.mode = mode;
  candidate.motion = solveMotion(task, resolution, context);
  candidate.resolution = std::move(resolution);
  candidate.evaluation =
      evaluateMotion(candidate.motion, task.cell, task.params, context, clearance);
  return candidate;
}

}  // namespace wcam::motion::detail
