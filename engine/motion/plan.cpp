// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/plan.hpp"

#include "wcam/motion/reversals.hpp"

#include "plan_detail.hpp"

#include <algorithm>

namespace wcam::motion {

namespace {

using cell::Branch;

/// Positioner solution and branch that serve the whole operation best.
struct Choice {
  detail::Positioning positioning;
  Branch branch;
};

bool mayUse(const MotionParams& params, int branch) {
  return params.branch == BranchChoice::Auto || static_cast<int>(params.branch) - 1 == branch;
}

Choice choose(const cell::Cell& cell,
              const std::vector<detail::Target>& targets,
              const MotionParams& params,
              const JobContext& context) {
  // Two positioner solutions exist only with two axes.
  const int families = cell.positionerJoints() == 2 ? 2 : 1;
  Choice best;
  detail::BranchScore bestScore;
  bool found = false;
  for (int family = 0; family < families; ++family) {
    detail::Positioning positioning = detail::positionPart(cell, targets, family, context);
    if (family > 0 && positioning.joints == best.positioning.joints) {
      break;
    }
    const detail::BranchScores scores =
        detail::scoreBranches(cell, targets, positioning, params, context);
    bool taken = false;
    for (int k = 0; k < Branch::kCount; ++k) {
      const detail::BranchScore& score = scores[static_cast<std::size_t>(k)];
      if (mayUse(params, k) && (!found || score.betterThan(bestScore))) {
        found = true;
        taken = true;
        bestScore = score;
        best.branch = Branch::fromIndex(k);
      }
    }
    if (taken) {
      best.positioning = std::move(positioning);
    }
  }
  return best;
}

}  // namespace

PlannedMotion planMotion(const toolpath::Toolpath& path,
                         const cell::Cell& cell,
                         const MotionParams& params,
                         const std::string& operationId,
                         const JobContext& context,
                         const collision::Clearance* /*clearance*/) {
  if (!cell.arm) {
    throw Error(ErrorCode::JobFailed,
                "the robot of the cell has no closed-form inverse kinematics: " + cell.armProblem,
                "cell " + cell.name + ", operation " + operationId,
                "use a robot with a spherical wrist and parallel axes 2 and 3");
  }
  PlannedMotion planned;
  const std::vector<detail::Target> targets = detail::makeTargets(path, params, context);
  const Choice choice = choose(cell, targets, params, context.portion(0.0, 0.5));
  context.report(0.5);
  std::vector<detail::PointState> states;
  detail::solveBranch(cell, targets, choice.positioning, choice.branch, params, context,
                      planned.motion, states);
  applyTimeLaw(planned.motion, cell, params, params.jointSpeedRatio, context);
  detail::reportFindings(cell, planned.motion, states, choice.positioning, params, operationId,
                         context);
  context.report(0.9);
  planned.statistics = motionStatistics(planned.motion, cell, context);
  planned.statistics.reversals = jointReversals(planned.motion, cell);
  detail::reportSpeeds(cell, planned.motion, params, operationId, planned.statistics.reversals,
                       context);
  planned.statistics.branch = choice.branch.name();
  for (const double residual : choice.positioning.residual) {
    planned.statistics.maxVerticalError = std::max(planned.statistics.maxVerticalError, residual);
  }
  context.report(1.0);
  return planned;
}

}  // namespace wcam::motion
