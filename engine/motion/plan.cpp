// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/plan.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/motion/reversals.hpp"

#include "cell_model.hpp"
#include "coarse_targets.hpp"
#include "modes.hpp"
#include "table_reference.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace {

constexpr std::size_t kGrain = 256;

/// References of both ways of the positioner, one where they are the same.
std::vector<detail::Positioning> alignments(const cell::Cell& cell,
                                            const std::vector<detail::Target>& targets,
                                            const JobContext& context) {
  std::vector<detail::Positioning> aligned;
  aligned.push_back(detail::positionPart(cell, targets, 0, context));
  // Two positioner solutions exist only with two axes.
  if (!cell.partCarried() && cell.positionerJoints() == 2) {
    detail::Positioning other = detail::positionPart(cell, targets, 1, context);
    if (other.joints != aligned[0].joints) {
      aligned.push_back(std::move(other));
    }
  }
  return aligned;
}

std::string branchNames(const cell::Cell& cell, const std::vector<int>& branches) {
  std::string names;
  std::vector<int> seen;
  for (const int branch : branches) {
    if (std::find(seen.begin(), seen.end(), branch) == seen.end()) {
      seen.push_back(branch);
      names += (names.empty() ? "" : "/") + cell.inverse->branchName(branch);
    }
  }
  return names;
}

void fillDexterity(const cell::Cell& cell,
                   const Motion& motion,
                   std::vector<detail::PointState>& states,
                   const JobContext& context) {
  const detail::CellModel model(cell);
  parallelFor(
      motion.waypoints.size(), kGrain,
      [&](std::size_t i) {
        if (motion.waypoints[i].reachable) {
          states[i].dexterity =
              static_cast<float>(model.armState(motion.waypoints[i].joints).dexterity);
        }
      },
      context);
}

void fillStatistics(const cell::Cell& cell,
                    const MotionParams& params,
                    const detail::Candidate& chosen,
                    PlannedMotion& planned) {
  MotionStatistics& statistics = planned.statistics;
  statistics.branch = branchNames(cell, chosen.resolution.branches);
  statistics.mode = redundancyKey(chosen.mode);
  statistics.evaluation = chosen.evaluation;
  statistics.evaluation.objectives[static_cast<std::size_t>(Objective::TcpSpeed)] =
      detail::speedLoss(planned.motion);
  const detail::CellModel model(cell);
  for (const Waypoint& point : planned.motion.waypoints) {
    statistics.maxVerticalError = std::max(statistics.maxVerticalError, point.verticalError);
    statistics.maxTilt = std::max(statistics.maxTilt, point.tilt);
    if (point.point >= 0 && point.reachable) {
      statistics.maxCableTwist =
          std::max(statistics.maxCableTwist,
                   std::abs(model.cableTwist(point.joints, params.cableZero.value())));
    }
  }
}

}  // namespace

void detail::checkBranch(const cell::Cell& cell, const MotionParams& params, const Text& place) {
  if (!cell.arm && params.branch != BranchChoice::Auto) {
    throw Error(
        ErrorCode::JobFailed,
        text("the robot of the cell has no configurations of this name: %1", {cell.armProblem}),
        place, "set \"branch\" to auto");
  }
}

namespace {

/// The gravity-aligned references of an operation with what all modes work on.
detail::Task makeTask(const cell::Cell& cell,
                      const MotionParams& params,
                      std::vector<detail::Target> targets,
                      const JobContext& context) {
  detail::Runs runs = detail::findRuns(targets);
  std::vector<detail::Positioning> aligned = alignments(cell, targets, context);
  // In every mode: what gravity asks for must not turn the table over where nothing is gained.
  std::vector<detail::Positioning> slower =
      detail::slowerReferences(cell, params, targets, runs, aligned[0], context);
  if (!slower.empty()) {
    aligned = std::move(slower);
  }
  return {cell, params, std::move(targets), std::move(runs), aligned, aligned};
}

/// The free choices of all targets by the mode of the parameters, and their worth. The motion of
/// the candidate is not kept: its memory is that of the path.
detail::Candidate choose(const detail::Task& task,
                         const JobContext& context,
                         const collision::Clearance* clearance) {
  const MotionParams& params = task.params;
  detail::Candidate chosen =
      params.mode == RedundancyMode::Optimized
          ? detail::resolveOptimized(task, context, clearance)
          : detail::makeCandidate(task, params.mode,
                                  detail::resolveNamed(params.mode, task, context), context,
                                  clearance);
  chosen.motion = {};
  return chosen;
}

/// A task whose free choices come from elsewhere: gravity-aligned without more.
detail::Task alignedTask(const cell::Cell& cell,
                         const MotionParams& params,
                         std::vector<detail::Target> targets,
                         const JobContext& context) {
  detail::Runs runs = detail::findRuns(targets);
  std::vector<detail::Positioning> aligned = {detail::positionPart(cell, targets, 0, context)};
  return {cell, params, std::move(targets), std::move(runs), std::move(aligned), {}};
}

detail::Task taskOfSome(const detail::Task& task,
                        const std::vector<std::size_t>& kept,
                        const JobContext& context) {
  std::vector<detail::Target> some;
  some.reserve(kept.size());
  for (const std::size_t i : kept) {
    some.push_back(task.targets[i]);
  }
  return makeTask(task.cell, task.params, std::move(some), context);
}

/// The same by a search on some of the targets.
/// @param task of all targets; only its first reference is needed
detail::Candidate chooseOnCoarse(const detail::Task& task,
                                 const std::vector<std::size_t>& kept,
                                 const JobContext& context,
                                 const collision::Clearance* clearance) {
  detail::Candidate chosen = choose(taskOfSome(task, kept, context), context, clearance);
  chosen.resolution = detail::spreadOverTargets(task, kept, chosen.resolution, context);
  return chosen;
}

/// The named mode that is best on some of the beads, for all of them.
detail::Candidate chooseOnSample(const detail::Task& task,
                                 const JobContext& context,
                                 const collision::Clearance* clearance) {
  detail::Candidate chosen = detail::bestNamed(
      taskOfSome(task, detail::sampledBeads(task.runs), context), context, clearance);
  chosen.resolution = detail::resolveNamed(chosen.mode, task, context);
  chosen.motion = {};
  return chosen;
}

}  // namespace

PlannedMotion planMotion(const toolpath::Toolpath& path,
                         const cell::Cell& cell,
                         const MotionParams& given,
                         const std::string& operationId,
                         const JobContext& context,
                         const collision::Clearance* clearance) {
  const MotionParams params = detail::withCable(given, cell);
  detail::checkBranch(cell, params, text("cell %1, operation %2", {cell.name, operationId}));
  PlannedMotion planned;
  std::vector<detail::Target> targets = detail::makeTargets(path, params, context);
  if (targets.empty()) {
    return planned;
  }
  // Named modes follow their rule at every target; only the search is dear.
  const bool optimized = params.mode == RedundancyMode::Optimized;
  const bool sampled =
      optimized && detail::findRuns(targets).segments.size() > detail::kSearchedBeads;
  const std::vector<std::size_t> kept =
      optimized && !sampled ? detail::coarseTargets(targets) : std::vector<std::size_t>();
  detail::Candidate chosen;
  std::vector<detail::PointState> states;
  {
    const detail::Task task = kept.empty() ? makeTask(cell, params, std::move(targets), context)
                                           : alignedTask(cell, params, std::move(targets), context);
    context.report(0.1);
    const JobContext planning = context.portion(0.1, 0.8);
    chosen = sampled        ? chooseOnSample(task, planning, clearance)
             : kept.empty() ? choose(task, planning, clearance)
                            : chooseOnCoarse(task, kept, planning, clearance);
    planned.motion = detail::solveMotion(task, chosen.resolution, context, &states);
  }
  if (sampled || !kept.empty()) {
    // Collisions of all targets are counted when they are reported.
    chosen.evaluation = evaluateMotion(planned.motion, cell, params, context);
  }
  fillDexterity(cell, planned.motion, states, context);
  applyTimeLaw(planned.motion, cell, params, params.jointSpeedRatio, context);
  detail::reportFindings(cell, planned.motion, states, params, operationId, context);
  context.report(0.95);
  planned.statistics = motionStatistics(planned.motion, cell, context);
  planned.statistics.reversals = jointReversals(planned.motion, cell);
  detail::reportSpeeds(cell, planned.motion, path, params, operationId,
                       planned.statistics.reversals, context);
  fillStatistics(cell, params, chosen, planned);
  context.report(1.0);
  return planned;
}

}  // namespace wcam::motion
