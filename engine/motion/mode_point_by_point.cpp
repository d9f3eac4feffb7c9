// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "modes.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

constexpr int kSamples = 72;
constexpr double kSampleStep = 2.0 * kPi / kSamples;
/// Steps of the golden section after the samples: the interval of two samples shrinks to 1e-4 of
/// it.
constexpr int kGoldenSteps = 20;
/// Cost of a radian beyond a limit (of joints, their sums and the cable), of a missing unit of
/// dexterity and of an unreachable point: far above any weighted step (180°²/stroke is some
/// hundred).
constexpr double kBeyondCost = 1e6;
constexpr std::size_t kCheckEvery = 64;

/// Cost of a rotation at one point after a previous posture.
class PointCost {
public:
  PointCost(const Task& task, const CellModel& model, int branch)
      : task_(task), model_(model), branch_(branch), followed_(isFollowed(task.cell)) {}

  double operator()(const Target& target,
                    const FreeChoice& choice,
                    const cell::JointVector* previous,
                    cell::JointVector& q) const {
    const Cell& cell = task_.cell;
    Pose T_part_tcp;
    const Pose flange = flangePose(cell, target, choice, &T_part_tcp);
    const cell::InverseSolution solution = cell.inverse->solve(
        flange, branch_, followed_ && previous != nullptr ? previous->data() : nullptr);
    q.resize(cell.jointCount());
    q.head(solution.joints.size()) = solution.joints;
    for (int j = 0; j < cell.positionerJoints(); ++j) {
      q(cell.robotJoints() + j) = choice.positioner[static_cast<std::size_t>(j)];
    }
    if (!solution.reachable) {
      return kBeyondCost * (1.0 + solution.missing);
    }
    double cost = 0.0;
    for (int j = 0; j < cell.robotJoints(); ++j) {
      const cell::Joint& joint = cell.joint(j);
      if (cell::periodicJoint(cell, j)) {
        q(j) = cell::turnInLimits(joint, q(j), previous != nullptr ? (*previous)(j) : 0.0);
      }
      cost += kBeyondCost * model_.asAngle(j, cell::limitExcess(joint, q(j)));
      if (previous != nullptr) {
        const double step = model_.inUnit(j, q(j) - (*previous)(j));
        cost += model_.motionWeight(j) * step * step;
      }
    }
    for (const cell::JointSum& sum : cell.sums) {
      cost += kBeyondCost * model_.asAngle(CellModel::firstOf(sum), sumExcess(sum, q));
    }
    const double limit = task_.params.cableLimit.value();
    if (limit > 0.0) {
      const double twist = std::abs(model_.cableTwist(q, task_.params.cableZero.value()));
      cost += kBeyondCost * std::max(0.0, twist - limit);
    }
    const double missing = task_.params.minDexterity - model_.armState(q).dexterity;
    return missing > 0.0 ? cost + kBeyondCost * missing : cost;
  }

private:
  const Task& task_;
  const CellModel& model_;
  int branch_;
  bool followed_;
};

/// Least cost of a function on [a, b] by golden section.
template <class Cost>
double goldenSection(const Cost& cost, double a, double b) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double x1 = b - ratio * (b - a);
  double x2 = a + ratio * (b - a);
  double f1 = cost(x1);
  double f2 = cost(x2);
  for (int k = 0; k < kGoldenSteps; ++k) {
    if (f1 <= f2) {
      b = x2;
      x2 = x1;
      f2 = f1;
      x1 = b - ratio * (b - a);
      f1 = cost(x1);
    } else {
      a = x1;
      x1 = x2;
      f1 = f2;
      x2 = a + ratio * (b - a);
      f2 = cost(x2);
    }
  }
  return f1 <= f2 ? x1 : x2;
}

}  // namespace

Resolution resolvePointByPoint(const Task& task, const JobContext& context) {
  Resolution resolution = resolveConstant(task, context);
  if (!task.cell.inverse->freeRotation()) {
    return resolution;
  }
  const CellModel model(task.cell);
  cell::JointVector before;
  const cell::JointVector* previous = nullptr;
  double rotation = task.params.torchRotation.value();
  std::size_t done = 0;
  for (const Segment& segment : task.runs.segments) {
    const PointCost pointCost(task, model, resolution.branches[segment.run]);
    for (std::size_t i = segment.first; i <= segment.last; ++i) {
      if (done++ % kCheckEvery == 0) {
        context.check();
      }
      FreeChoice choice = resolution.choices[i];
      cell::JointVector q;
      const auto cost = [&](double angle) {
        choice.torchRotation = angle;
        return pointCost(task.targets[i], choice, previous, q);
      };
      double best = rotation;
      double least = cost(rotation);
      if (previous != nullptr || least > 0.0) {
        for (int k = 1; k < kSamples; ++k) {
          const double angle = rotation + (k <= kSamples / 2 ? k : k - kSamples) * kSampleStep;
          const double value = cost(angle);
          if (value < least) {
            least = value;
            best = angle;
          }
        }
        const double refined = goldenSection(cost, best - kSampleStep, best + kSampleStep);
        best = cost(refined) < least ? refined : best;
      }
      cost(best);
      rotation = best;
      before = q;
      previous = &before;
      resolution.choices[i].torchRotation = best;
    }
  }
  spreadToTravel(task.runs, resolution.choices);
  return resolution;
}

}  // namespace wcam::motion::detail
