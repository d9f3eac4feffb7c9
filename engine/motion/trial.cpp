// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trial.hpp"

#include "wcam/cell/angles.hpp"
#include "wcam/cell/positioner.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "exit_search.hpp"
#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion::detail {

namespace {

using geometry::Pose;
using geometry::Vec3;

std::array<double, 2> positionerOf(const cell::Cell& cell, const cell::JointVector& q) {
  std::array<double, 2> values{};
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    values[static_cast<std::size_t>(j)] = q(cell.robotJoints() + j);
  }
  return values;
}

/// The solution of the positioner that the planned values are not.
std::array<double, 2> otherSolution(const cell::Cell& cell,
                                    const Vec3& up,
                                    const std::array<double, 2>& planned) {
  const cell::PositionerResult result = cell::alignToVertical(cell, up, planned);
  if (result.count < 2) {
    return planned;
  }
  const auto away = [&](std::size_t k) {
    const auto& values = result.solutions[k].joints;
    return std::abs(cell::wrapAngle(values[0] - planned[0])) +
           std::abs(cell::wrapAngle(values[1] - planned[1]));
  };
  std::array<double, 2> other = result.solutions[away(0) >= away(1) ? 0 : 1].joints;
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    if (cell::periodicJoint(cell, cell.robotJoints() + j)) {
      other[k] = cell::turnInLimits(cell.joint(cell.robotJoints() + j), other[k], planned[k]);
    }
  }
  return other;
}

void addMeasures(const cell::Cell& cell,
                 const cell::InverseSolution& solution,
                 TrialResult& result) {
  result.reachable = solution.reachable;
  result.missing = solution.missing;
  result.wrist = std::asin(std::min(marginSine(cell, solution.wristSine), 1.0));
  result.elbow = std::asin(std::min(solution.elbowSine, 1.0));
  result.shoulder = solution.axisDistance;
}

void addLimits(const cell::Cell& cell, TrialResult& result) {
  result.limitMargin = std::numeric_limits<double>::infinity();
  for (int j = 0; j < cell.jointCount(); ++j) {
    double margin = cell::limitMargin(cell.joint(j), result.joints(j));
    margin = cell.joint(j).prismatic() ? margin / kLengthPerRadian : margin;
    if (margin < result.limitMargin) {
      result.limitMargin = margin;
      result.limitJoint = j;
    }
  }
  for (const cell::JointSum& sum : cell.sums) {
    if (sumExcess(sum, result.joints) > 0.0) {
      result.limitMargin = std::min(result.limitMargin, -sumExcess(sum, result.joints));
    }
  }
}

}  // namespace

bool TrialResult::right(const MotionParams& params) const {
  return reachable && limitMargin >= 0.0 && wrist >= params.wristMargin.value() &&
         elbow >= params.elbowMargin.value() && shoulder >= params.shoulderMargin.value() &&
         cable <= 0.0 && clearance >= 0.0;
}

Trial::Trial(const cell::Cell& cell,
             const collision::CellCollision* collision,
             const MotionParams& params)
    : cell_(cell), model_(cell), collision_(collision), params_(params) {}

/// The part on the other cell's table as its file places it.
TrialResult Trial::inOther(const TrialPoint& point, const Change& change) const {
  const cell::Cell& other = *cell_.other;
  Pose T_part_tcp = point.T_part_tcp;
  T_part_tcp.linear() =
      T_part_tcp.linear() * Eigen::AngleAxisd(change.rotation, Vec3::UnitZ()).toRotationMatrix();
  TrialResult result;
  result.joints = cell::neutralJoints(other);
  Pose flange = Pose::Identity();
  if (other.partCarried()) {
    flange = other.T_base_tcp * T_part_tcp.inverse() *
             (other.T_flange_table * other.T_table_part).inverse();
  } else {
    const Vec3 up = point.point != nullptr ? point.point->up : Vec3(T_part_tcp.linear().col(2));
    const cell::PositionerResult aligned =
        cell::alignToVertical(other, up, positionerOf(other, result.joints));
    const auto& values = aligned.solutions[change.positioner == 1 ? 1 : 0].joints;
    for (int j = 0; j < other.positionerJoints(); ++j) {
      result.joints(other.robotJoints() + j) = values[static_cast<std::size_t>(j)];
    }
    flange = cell::chainPose(other.positioner, values.data()) * other.T_table_part * T_part_tcp *
             other.T_flange_tcp.inverse();
  }
  const cell::InverseSolution solution =
      other.inverse->solve(flange, std::max(change.branch, 0), result.joints.data());
  addMeasures(other, solution, result);
  result.joints.head(other.robotJoints()) = solution.joints;
  result.joints = cell::unwrapJoints(other, result.joints, cell::neutralJoints(other));
  addLimits(other, result);
  return result;
}

TrialResult Trial::at(const TrialPoint& point, const Change& change, bool withCollision) const {
  if (change.other) {
    return inOther(point, change);
  }
  Pose T_part_tcp = point.T_part_tcp;
  if (point.point != nullptr && (change.lateral != 0.0 || change.lead != 0.0)) {
    T_part_tcp.linear() =
        tiltRotation(*point.point, {change.lateral, change.lead}) * T_part_tcp.linear();
  }
  T_part_tcp.linear() =
      T_part_tcp.linear() * Eigen::AngleAxisd(change.rotation, Vec3::UnitZ()).toRotationMatrix();
  Pose T_table_part = cell_.T_table_part;
  if (change.turn != 0.0 || change.onTable != Vec3::Zero()) {
    Pose move = Pose::Identity();
    move.linear() = Eigen::AngleAxisd(change.turn, Vec3::UnitZ()).toRotationMatrix();
    move.translation() = change.onTable;
    T_table_part = move * T_table_part;
  }
  std::array<double, 2> positioner = positionerOf(cell_, point.joints);
  Pose flange = Pose::Identity();
  if (cell_.partCarried()) {
    Pose tcp = cell_.T_base_tcp;
    tcp.translation() += change.inBase;
    flange = tcp * T_part_tcp.inverse() * (cell_.T_flange_table * T_table_part).inverse();
  } else {
    if (change.positioner == 1 && point.point != nullptr) {
      positioner = otherSolution(cell_, point.point->up, positioner);
    }
    Pose table = cell::chainPose(cell_.positioner, positioner.data());
    const Eigen::Matrix3d planned = (table * cell_.T_table_part * T_part_tcp).linear();
    table.translation() += change.inBase;
    Pose tcp = table * T_table_part * T_part_tcp;
    if (change.turn != 0.0) {
      // The torch does not turn along with the part: planning sets its rotation in the base.
      tcp.linear() = Eigen::Quaterniond::FromTwoVectors(planned.col(2), tcp.linear().col(2))
                         .toRotationMatrix() *
                     planned;
    }
    flange = tcp * cell_.T_flange_tcp.inverse();
  }
  const cell::InverseKinematics& inverse = *cell_.inverse;
  const int branch = change.branch >= 0 ? change.branch : inverse.branchOf(point.joints.data());
  // Where a branch is a start posture, the planned joints would lead back to themselves.
  const bool elsewhere = change.branch >= 0 && isFollowed(cell_);
  const cell::InverseSolution solution =
      inverse.solve(flange, branch, elsewhere ? nullptr : point.joints.data());
  TrialResult result;
  addMeasures(cell_, solution, result);
  result.joints = point.joints;
  for (int j = 0; j < cell_.robotJoints(); ++j) {
    result.joints(j) = cell::periodicJoint(cell_, j)
                           ? cell::turnInLimits(cell_.joint(j), solution.joints(j), point.joints(j))
                           : solution.joints(j);
  }
  for (int j = 0; j < cell_.positionerJoints(); ++j) {
    result.joints(cell_.robotJoints() + j) = positioner[static_cast<std::size_t>(j)];
  }
  addLimits(cell_, result);
  if (params_.cableLimit.value() > 0.0) {
    const double twist = model_.cableTwist(result.joints, params_.cableZero.value());
    result.cable = std::max(0.0, std::abs(twist) - params_.cableLimit.value());
  }
  // The model stands for the part where it is: what moves is looked at without it.
  const bool moved =
      change.turn != 0.0 || change.onTable != Vec3::Zero() || change.inBase != Vec3::Zero();
  if (withCollision && collision_ != nullptr && !moved && result.right(params_)) {
    const collision::CellState state{result.joints, point.deposited};
    float clearance = 0.0F;
    collision_->evaluate(std::span(&state, 1), std::span(&clearance, 1));
    result.clearance = clearance;
  }
  return result;
}

}  // namespace wcam::motion::detail
