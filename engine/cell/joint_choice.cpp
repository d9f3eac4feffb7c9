// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/joint_choice.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

constexpr double kTurn = 2.0 * kPi;
/// Figures of two candidates that differ by less are a tie (rad): rounding of wrapped angles.
constexpr double kTie = 1e-9;
/// Rounding of a sum that lies on its limit.
constexpr double kSumSlack = 1e-9;
/// Turns of an endless joint that are offered: nobody needs all of them.
constexpr int kMostTurns = 2;

/// The values that differ from `value` by whole turns and lie inside the limits.
std::vector<double> turnsInside(const Cell& cell, int index, double value) {
  const Joint& joint = cell.joint(index);
  if (!periodicJoint(cell, index)) {
    return {value};
  }
  std::vector<double> values;
  for (int k = -kMostTurns; k <= kMostTurns; ++k) {
    const double turned = value + k * kTurn;
    if (limitExcess(joint, turned) == 0.0) {
      values.push_back(turned);
    }
  }
  return values;
}

void addTurns(const Cell& cell,
              int joint,
              const JointVector& positioner,
              JointCandidate& candidate,
              std::vector<JointCandidate>& result) {
  if (joint == cell.robotJoints()) {
    if (admissible(cell, candidate.joints, positioner)) {
      result.push_back(candidate);
    }
    return;
  }
  const double value = candidate.joints(joint);
  for (const double turned : turnsInside(cell, joint, value)) {
    candidate.joints(joint) = turned;
    addTurns(cell, joint + 1, positioner, candidate, result);
  }
  candidate.joints(joint) = value;
}

/// Index of the least (largest, sum); the earlier one on a tie.
template <class Figure>
std::optional<std::size_t> leastOf(const std::vector<JointCandidate>& from, const Figure& figure) {
  std::optional<std::size_t> best;
  std::pair<double, double> bestFigure;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::pair<double, double> found = figure(from[i].joints);
    if (!best || found.first < bestFigure.first - kTie ||
        (found.first <= bestFigure.first + kTie && found.second < bestFigure.second - kTie)) {
      best = i;
      bestFigure = found;
    }
  }
  return best;
}

}  // namespace

bool admissible(const Cell& cell, const JointVector& robot, const JointVector& positioner) {
  WCAM_ASSERT(robot.size() == cell.robotJoints());
  JointVector q = JointVector::Zero(cell.jointCount());
  q.head(robot.size()) = robot;
  if (positioner.size() > 0) {
    q.tail(positioner.size()) = positioner;
  }
  for (int j = 0; j < cell.robotJoints(); ++j) {
    if (limitExcess(cell.joint(j), q(j)) > 0.0) {
      return false;
    }
  }
  return std::all_of(cell.sums.begin(), cell.sums.end(), [&q](const JointSum& sum) {
    const double value = sum.value(q);
    return value >= sum.min - kSumSlack && value <= sum.max + kSumSlack;
  });
}

std::vector<JointCandidate> candidates(const Cell& cell,
                                       const Pose& T_base_flange,
                                       const JointVector& positioner,
                                       const double* seed) {
  std::vector<JointCandidate> result;
  for (int branch = 0; branch < cell.inverse->branches(); ++branch) {
    const InverseSolution solution = cell.inverse->solve(T_base_flange, branch, seed);
    if (solution.reachable) {
      JointCandidate candidate{branch, solution.joints};
      addTurns(cell, 0, positioner, candidate, result);
    }
  }
  return result;
}

std::optional<std::size_t> smallestJoints(const std::vector<JointCandidate>& from,
                                          const std::vector<bool>& counts) {
  return leastOf(from, [&counts](const JointVector& q) {
    double largest = 0.0;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      largest = counts[static_cast<std::size_t>(j)] ? std::max(largest, std::abs(q(j))) : largest;
    }
    return std::pair(largest, 0.0);
  });
}

std::optional<std::size_t> smallestChange(const std::vector<JointCandidate>& from,
                                          const JointVector& previous,
                                          const std::vector<bool>& counts) {
  return leastOf(from, [&](const JointVector& q) {
    double largest = 0.0;
    double sum = 0.0;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      if (counts[static_cast<std::size_t>(j)]) {
        const double change = std::abs(q(j) - previous(j));
        largest = std::max(largest, change);
        sum += change;
      }
    }
    return std::pair(largest, sum);
  });
}

}  // namespace wcam::cell
