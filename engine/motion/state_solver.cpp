// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints from free choices: with search_states.cpp the only place that calls inverse kinematics.

#include "wcam/base/parallel.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "plan_detail.hpp"
#include "turns.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

using cell::Branch;
using cell::InverseKinematics;
using cell::InverseSolution;
using cell::JointVector;

constexpr std::size_t kGrain = 128;
/// A branch whose joints all keep this part of their range to the limits is good enough for a usual
/// posture to be preferred to a larger margin.
constexpr double kEnoughMargin = 0.05;
/// Targets on which the start postures of a numeric search are compared, at most.
constexpr std::size_t kFollowedTargets = 200;

/// Distance to the nearest limit over the joint's range, of the turn that lies best inside.
double relativeMargin(const cell::Joint& joint, double value, bool periodic) {
  if (joint.endless) {
    return BranchScore::kFullMargin;
  }
  const double middle = 0.5 * (joint.min + joint.max);
  const double best = periodic ? cell::nearestTurn(value, middle) : value;
  return cell::limitMargin(joint, best) / (joint.max - joint.min);
}

void addToScore(const CellModel& model, const InverseSolution& solution, BranchScore& score) {
  const Cell& cell = model.cell();
  if (!solution.reachable) {
    ++score.unreachable;
    return;
  }
  double margin = BranchScore::kFullMargin;
  for (int j = 0; j < cell.robotJoints(); ++j) {
    margin = std::min(margin, relativeMargin(cell.joint(j), solution.joints(j), model.periodic(j)));
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

BranchScores emptyScores(const Cell& cell) {
  BranchScores scores;
  for (std::size_t k = 0; cell.arm && k < scores.size(); ++k) {
    const Branch branch = Branch::fromIndex(static_cast<int>(k));
    scores[k].unusual = (branch.elbowDown ? 1 : 0) + (branch.backwards ? 2 : 0);
  }
  return scores;
}

/// Joints of a target in the cell's order.
JointVector cellJoints(const Cell& cell,
                       const JointVector& robot,
                       const PositionerValues& positioner) {
  JointVector q(cell.jointCount());
  q.head(robot.size()) = robot;
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    q(cell.robotJoints() + j) = positioner[static_cast<std::size_t>(j)];
  }
  return q;
}

PointState stateOf(const Cell& cell, const InverseSolution& solution) {
  PointState state;
  state.wristSine = static_cast<float>(marginSine(cell, solution.wristSine));
  state.elbowSine = static_cast<float>(solution.elbowSine);
  state.axisDistance = static_cast<float>(solution.axisDistance);
  state.missing = solution.missing;
  state.missingTilt = solution.tilt;
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
    const InverseSolution solution = task.cell.inverse->solve(
        flange, resolution.branches[run[i]], motion.waypoints[i - 1].joints.data());
    motion.waypoints[i].joints.head(solution.joints.size()) = solution.joints;
  }
}

/// Everything of a waypoint but its joints, and the pose that the flange must take.
Pose prepareWaypoint(const Task& task, std::size_t i, const FreeChoice& choice, Waypoint& point) {
  const Target& target = task.targets[i];
  point = Waypoint{target.waypoint};
  const Pose flange = flangePose(task.cell, target, choice, &point.T_part_tcp);
  point.verticalError = verticalError(task.cell, target.up, choice.positioner);
  point.leastVerticalError = task.aligned[0].residual[i];
  const Vec3 axis = point.T_part_tcp.linear().col(2);
  point.tilt = choice.lead == 0.0 && choice.lateral == 0.0
                   ? 0.0
                   : std::atan2(axis.cross(target.axis).norm(), axis.dot(target.axis));
  return flange;
}

/// Joints of all waypoints in order, each from those before.
void followTargets(const Task& task,
                   const Resolution& resolution,
                   const std::vector<std::size_t>& run,
                   const JobContext& context,
                   Motion& motion,
                   std::vector<PointState>* states) {
  const double* seed = nullptr;
  for (std::size_t i = 0; i < task.targets.size(); ++i) {
    context.check();
    Waypoint& point = motion.waypoints[i];
    const FreeChoice& choice = resolution.choices[i];
    const Pose flange = prepareWaypoint(task, i, choice, point);
    const InverseSolution solution =
        task.cell.inverse->solve(flange, resolution.branches[run[i]], seed);
    point.reachable = solution.reachable;
    point.joints = cellJoints(task.cell, solution.joints, choice.positioner);
    if (solution.reachable) {
      seed = point.joints.data();
    }
    if (states != nullptr) {
      (*states)[i] = stateOf(task.cell, solution);
    }
  }
}

/// A robot that cannot turn about the tool axis takes the rotation that goes with its joints.
void takeOwnRotation(const Cell& cell, Motion& motion, const JobContext& context) {
  parallelFor(
      motion.waypoints.size(), kGrain,
      [&](std::size_t i) {
        Waypoint& point = motion.waypoints[i];
        if (point.reachable) {
          point.T_part_tcp.linear() = cell::T_part_tcp(cell, point.joints).linear();
        }
      },
      context);
}

/// Scores of the start postures of a numeric search, each followed over targets in order.
BranchScores scorePostures(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context) {
  const CellModel model(task.cell);
  const std::size_t stride = choices.size() / kFollowedTargets + 1;
  BranchScores scores = emptyScores(task.cell);
  parallelFor(
      static_cast<std::size_t>(task.cell.inverse->branches()), 1,
      [&](std::size_t k) {
        JointVector before;
        for (std::size_t i = 0; i < choices.size(); i += stride) {
          context.check();
          Pose T_part_tcp;
          const Pose flange = flangePose(task.cell, task.targets[i], choices[i], &T_part_tcp);
          const InverseSolution solution = task.cell.inverse->solve(
              flange, static_cast<int>(k), before.size() > 0 ? before.data() : nullptr);
          addToScore(model, solution, scores[k]);
          scores[k].outsideLimits += positionerOutside(task.cell, choices[i].positioner) ? 1 : 0;
          if (solution.reachable) {
            before = solution.joints;
          }
        }
      },
      context);
  return scores;
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

bool mayUse(const Cell& cell, const MotionParams& params, int branch) {
  return !cell.arm || params.branch == BranchChoice::Auto ||
         static_cast<int>(params.branch) - 1 == branch;
}

bool isFollowed(const Cell& cell) {
  return cell.inverse->method() == cell::InverseMethod::Numeric;
}

BranchScores scoreBranches(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context) {
  const Cell& cell = task.cell;
  if (isFollowed(cell)) {
    return scorePostures(task, choices, context);
  }
  const CellModel model(cell);
  const auto branches = static_cast<std::size_t>(cell.inverse->branches());
  std::vector<BranchScores> parts((choices.size() + kGrain - 1) / kGrain, emptyScores(cell));
  parallelForChunks(
      choices.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        BranchScores& scores = parts[begin / kGrain];
        std::array<InverseSolution, InverseKinematics::kMostBranches> result;
        for (std::size_t i = begin; i < end; ++i) {
          Pose T_part_tcp;
          const Pose flange = flangePose(cell, task.targets[i], choices[i], &T_part_tcp);
          cell.inverse->solveAll(flange, result);
          const std::size_t outside = positionerOutside(cell, choices[i].positioner) ? 1 : 0;
          for (std::size_t k = 0; k < branches; ++k) {
            addToScore(model, result[k], scores[k]);
            scores[k].outsideLimits += outside;
          }
        }
      },
      context);
  BranchScores whole = emptyScores(cell);
  for (const BranchScores& part : parts) {
    for (std::size_t k = 0; k < whole.size(); ++k) {
      merge(part[k], whole[k]);
    }
  }
  return whole;
}

std::vector<int> oneBranch(const Task& task,
                           const std::vector<FreeChoice>& choices,
                           const JobContext& context,
                           BranchScore* score) {
  const BranchScores scores = scoreBranches(task, choices, context);
  int best = -1;
  for (int k = 0; k < task.cell.inverse->branches(); ++k) {
    if (mayUse(task.cell, task.params, k) &&
        (best < 0 ||
         scores[static_cast<std::size_t>(k)].betterThan(scores[static_cast<std::size_t>(best)]))) {
      best = k;
    }
  }
  if (score != nullptr) {
    *score = scores[static_cast<std::size_t>(best)];
  }
  return std::vector<int>(task.runs.count(), best);
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
  if (isFollowed(cell)) {
    followTargets(task, resolution, run, context, motion, states);
    chooseTurns(task, motion, context);
    if (!cell.inverse->freeRotation()) {
      takeOwnRotation(cell, motion, context);
    }
    return;
  }
  std::vector<char> open(targets.size(), 0);
  parallelFor(
      targets.size(), kGrain,
      [&](std::size_t i) {
        Waypoint& point = motion.waypoints[i];
        const FreeChoice& choice = resolution.choices[i];
        const Pose flange = prepareWaypoint(task, i, choice, point);
        const InverseSolution solution = cell.inverse->solve(flange, resolution.branches[run[i]]);
        point.reachable = solution.reachable;
        point.joints = cellJoints(cell, solution.joints, choice.positioner);
        open[i] = solution.wristSingular || solution.shoulderSingular ? 1 : 0;
        if (states != nullptr) {
          (*states)[i] = stateOf(cell, solution);
        }
      },
      context);
  closeSingularPoints(task, resolution, run, open, motion);
  chooseTurns(task, motion, context);
  if (!cell.inverse->freeRotation()) {
    takeOwnRotation(cell, motion, context);
  }
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
