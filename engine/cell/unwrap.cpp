// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/unwrap.hpp"

#include "wcam/base/quantity.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

constexpr double kTurn = 2.0 * kPi;
/// Halfway between two values, within this part of their distance, the lower one is taken: both are
/// as near, and rounding must not choose. Far above the noise of angles, far below what anybody
/// sees.
constexpr double kHalfwayTie = 1e-9;
/// Rounding of a value that lies on a limit, rad and mm.
constexpr double kLimitSlack = 1e-12;
constexpr double kLengthSlack = 1e-9;

double slackOf(const Joint& joint) {
  return joint.prismatic() ? kLengthSlack : kLimitSlack;
}

bool wholeColumn(const Chain& chain, int column) {
  if (chain.joints[static_cast<std::size_t>(column)].prismatic()) {
    return false;
  }
  for (const Joint& joint : chain.joints) {
    const auto k = static_cast<std::size_t>(column);
    if (k < joint.coupling.size() && joint.coupling[k] != 0.0 &&
        (joint.prismatic() || joint.coupling[k] != std::round(joint.coupling[k]))) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool periodicJoint(const Cell& cell, int joint) {
  return joint < cell.robotJoints() ? wholeColumn(cell.robot, joint)
                                    : wholeColumn(cell.positioner, joint - cell.robotJoints());
}

double nearestPeriod(double value, double reference, double period) {
  return value + period * std::ceil((reference - value) / period - 0.5 - kHalfwayTie);
}

double nearestTurn(double value, double reference) {
  return nearestPeriod(value, reference, kTurn);
}

double limitExcess(const Joint& joint, double value) {
  const double excess = std::max({joint.min - value, value - joint.max, 0.0});
  return excess <= slackOf(joint) ? 0.0 : excess;
}

double limitMargin(const Joint& joint, double value) {
  return std::min(value - joint.min, joint.max - value);
}

double turnInLimits(const Joint& joint, double value, double reference) {
  const double nearest = nearestTurn(value, reference);
  if (limitExcess(joint, nearest) == 0.0) {
    return nearest;
  }
  // Outside: the nearest turn back inside, which is the last one before the violated limit.
  const bool above = nearest > joint.max;
  const double turns = above ? -std::ceil((nearest - joint.max - kLimitSlack) / kTurn)
                             : std::ceil((joint.min - nearest - kLimitSlack) / kTurn);
  const double inside = nearest + kTurn * turns;
  const double oneLess = inside - std::copysign(kTurn, turns);
  return limitExcess(joint, inside) <= limitExcess(joint, oneLess) ? inside : oneLess;
}

JointVector unwrapJoints(const Cell& cell, const JointVector& q, const JointVector& previous) {
  JointVector result = q;
  for (int j = 0; j < cell.jointCount(); ++j) {
    if (periodicJoint(cell, j)) {
      result(j) = turnInLimits(cell.joint(j), q(j), previous(j));
    }
  }
  return result;
}

JointVector neutralJoints(const Cell& cell) {
  JointVector q(cell.jointCount());
  for (int j = 0; j < cell.jointCount(); ++j) {
    q(j) = std::clamp(0.0, cell.joint(j).min, cell.joint(j).max);
  }
  return q;
}

}  // namespace wcam::cell
