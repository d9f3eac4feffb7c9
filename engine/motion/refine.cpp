// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "refine.hpp"

#include "refine_points.hpp"

#include <algorithm>

namespace wcam::motion::detail {

namespace {

/// Weights of squared violations (degrees) of the stages; the later ones only run while constraints
/// are broken.
constexpr double kPenalties[] = {1e2, 1e4};
constexpr int kIterations = 10;
/// A relative improvement of the merit below this ends a stage: a thousandth is nothing that a
/// joint shows.
constexpr double kConverged = 1e-3;
constexpr double kFirstDamping = 1e-4;
constexpr double kMostDamping = 1e4;
/// Keeps poles that no objective moves where they are, relative to the largest diagonal entry.
constexpr double kRest = 1e-9;

/// Relative damping of the diagonal (Levenberg–Marquardt).
Eigen::VectorXd dampingOf(const BandMatrix& normal, double damping) {
  Eigen::VectorXd extra(normal.size());
  double largest = 0.0;
  for (Eigen::Index i = 0; i < normal.size(); ++i) {
    extra(i) = damping * normal.at(i, i);
    largest = std::max(largest, normal.at(i, i));
  }
  extra.array() += kRest * largest + 1e-300;
  return extra;
}

}  // namespace

Candidate refine(const Task& task,
                 const RefineFrame& frame,
                 const Candidate& start,
                 const JobContext& context,
                 const collision::Clearance* clearance) {
  const SplineLayout layout(task, frame);
  const ModelBuilder builder(task, frame, layout);
  Candidate best = start;
  Eigen::VectorXd x = layout.fit(start.resolution.choices);
  Resolution resolution{layout.choices(x), start.resolution.branches};
  Motion motion = solveMotion(task, resolution, context);
  Motion moved;
  const auto keep = [&] {
    Candidate candidate;
    candidate.mode = RedundancyMode::Optimized;
    candidate.evaluation = evaluateMotion(motion, task.cell, task.params, context, clearance);
    if (candidate.evaluation.betterThan(best.evaluation)) {
      candidate.motion = motion;
      candidate.resolution = resolution;
      best = std::move(candidate);
    }
  };
  for (const double penalty : kPenalties) {
    Model model = builder.build(resolution.choices, motion, penalty, context);
    double damping = kFirstDamping;
    for (int k = 0; k < kIterations && damping < kMostDamping; ++k) {
      context.check();
      Eigen::VectorXd step;
      if (!model.normal.solve(dampingOf(model.normal, damping), model.gradient, step)) {
        damping *= 10.0;
        continue;
      }
      const Eigen::VectorXd next = x - step;
      Resolution trial{layout.choices(next), resolution.branches};
      solveMotion(task, trial, context, moved);
      Model trialModel = builder.build(trial.choices, moved, penalty, context);
      if (!(trialModel.merit < model.merit)) {
        damping *= 10.0;
        continue;
      }
      const bool converged = model.merit - trialModel.merit <= kConverged * model.merit;
      x = next;
      resolution = std::move(trial);
      std::swap(motion, moved);
      model = std::move(trialModel);
      damping = std::max(damping * 0.1, 1e-9);
      if (converged) {
        break;
      }
    }
    keep();
    if (best.evaluation.feasible()) {
      break;
    }
  }
  return best;
}

}  // namespace wcam::motion::detail
