// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/positioner.hpp"
#include "wcam/cell/unwrap.hpp"

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// The positioner stays where it is while the build direction is within this angle of the best that
/// it can do (rad): rounding noise of a flat layer must not turn the table.
constexpr double kKeepStill = 1e-9;
constexpr std::size_t kCheckEvery = 1024;

using Values = PositionerValues;

Values unwrapped(const Cell& cell, const Values& q, const Values& previous) {
  Values result = q;
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    const int joint = cell.robotJoints() + j;
    const auto k = static_cast<std::size_t>(j);
    if (cell::periodicJoint(cell, joint)) {
      result[k] = cell::turnInLimits(cell.joint(joint), q[k], previous[k]);
    }
  }
  return result;
}

double excess(const Cell& cell, const Values& q) {
  double sum = 0.0;
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    sum += cell::limitExcess(cell.joint(cell.robotJoints() + j), q[static_cast<std::size_t>(j)]);
  }
  return sum;
}

double travelled(const Values& a, const Values& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]);
}

/// Inside the limits first, then the shorter way; on a tie the first.
std::size_t nearerSolution(const Cell& cell,
                           const std::array<Values, 2>& candidates,
                           const Values& previous) {
  const double excess0 = excess(cell, candidates[0]);
  const double excess1 = excess(cell, candidates[1]);
  if (excess0 != excess1) {
    return excess0 < excess1 ? 0 : 1;
  }
  return travelled(candidates[0], previous) <= travelled(candidates[1], previous) ? 0 : 1;
}

Values startValues(const Cell& cell) {
  const cell::JointVector neutral = cell::neutralJoints(cell);
  Values start{};
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    start[static_cast<std::size_t>(j)] = neutral(cell.robotJoints() + j);
  }
  return start;
}

/// Follows the solution that is nearest to the previous one; the first target that has two takes
/// the wanted one.
class Follower {
public:
  Follower(const Cell& cell, int family)
      : cell_(cell), family_(family), previous_(startValues(cell)) {}

  Values next(const Vec3& up, double* residual) {
    const cell::PositionerResult result = cell::alignToVertical(cell_, up, previous_);
    const double still = started_ ? verticalError(cell_, up, previous_) : 0.0;
    if (started_ && still <= result.solutions[0].residual + kKeepStill) {
      *residual = still;
      return previous_;
    }
    std::array<Values, 2> candidates{};
    for (std::size_t k = 0; k < 2; ++k) {
      candidates[k] = unwrapped(cell_, result.solutions[k].joints, previous_);
    }
    std::size_t chosen = 0;
    if (result.count == 2) {
      chosen = chosenOnce_ ? nearerSolution(cell_, candidates, previous_)
                           : static_cast<std::size_t>(family_);
      chosenOnce_ = true;
    }
    started_ = true;
    previous_ = candidates[chosen];
    *residual = result.solutions[chosen].residual;
    return previous_;
  }

private:
  const Cell& cell_;
  int family_;
  Values previous_;
  bool started_ = false;
  bool chosenOnce_ = false;
};

}  // namespace

Positioning positionPart(const Cell& cell,
                         const std::vector<Target>& targets,
                         int family,
                         const JobContext& context) {
  Positioning result;
  result.joints.resize(targets.size());
  result.residual.assign(targets.size(), 0.0);
  if (cell.partCarried()) {
    return result;
  }
  Follower follower(cell, family);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    result.joints[i] = follower.next(targets[i].up, &result.residual[i]);
  }
  return result;
}

double verticalError(const Cell& cell, const Vec3& up, const PositionerValues& positioner) {
  if (cell.partCarried()) {
    return 0.0;
  }
  const Vec3 v = cell::chainPose(cell.positioner, positioner.data()).linear() *
                 (cell.T_table_part.linear() * up);
  const Vec3 vertical = cell.verticalInBase();
  return std::atan2(v.cross(vertical).norm(), v.dot(vertical));
}

}  // namespace wcam::motion::detail
