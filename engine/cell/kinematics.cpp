// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

void checkSize(const Cell& cell, const JointVector& q) {
  WCAM_ASSERT(q.size() == cell.jointCount());
}

const double* positionerValues(const Cell& cell, const JointVector& q) {
  return q.data() + cell.robotJoints();
}

}  // namespace

Pose T_base_flange(const Cell& cell, const JointVector& q) {
  checkSize(cell, q);
  return chainPose(cell.robot, q.data());
}

Pose T_base_tcp(const Cell& cell, const JointVector& q) {
  return cell.partCarried() ? cell.T_base_tcp : T_base_flange(cell, q) * cell.T_flange_tcp;
}

Pose T_base_table(const Cell& cell, const JointVector& q) {
  checkSize(cell, q);
  return cell.partCarried() ? T_base_flange(cell, q) * cell.T_flange_table
                            : chainPose(cell.positioner, positionerValues(cell, q));
}

Pose T_base_part(const Cell& cell, const JointVector& q) {
  return T_base_table(cell, q) * cell.T_table_part;
}

Pose T_part_tcp(const Cell& cell, const JointVector& q) {
  return T_base_part(cell, q).inverse() * T_base_tcp(cell, q);
}

Jacobian robotJacobian(const Cell& cell, const JointVector& q) {
  return chainJacobian(cell.robot, q.data(), T_base_tcp(cell, q).translation());
}

PartJacobian partJacobian(const Cell& cell, const JointVector& q) {
  const Vec3 tcp = T_base_tcp(cell, q).translation();
  const Eigen::Matrix3d toPart = T_base_part(cell, q).linear().transpose();
  PartJacobian result(3, cell.jointCount());
  const double robotSide = cell.partCarried() ? -1.0 : 1.0;
  result.leftCols(cell.robotJoints()) =
      robotSide * toPart * chainJacobian(cell.robot, q.data(), tcp).topRows<3>();
  if (cell.positionerJoints() > 0) {
    result.rightCols(cell.positionerJoints()) =
        -toPart * chainJacobian(cell.positioner, positionerValues(cell, q), tcp).topRows<3>();
  }
  return result;
}

double dexterity(const Cell& cell, const JointVector& q) {
  const PartJacobian jacobian = partJacobian(cell, q);
  const auto block = jacobian.leftCols(cell.robotJoints());
  Eigen::Matrix3d gram = block * block.transpose();
  const auto prismatic = [](const Joint& joint) { return joint.prismatic(); };
  if (std::count_if(cell.robot.joints.begin(), cell.robot.joints.end(), prismatic) >= 3) {
    // Lengths and angles cannot be compared, and three prismatic joints alone move the point.
    gram.setZero();
    for (int j = 0; j < cell.robotJoints(); ++j) {
      if (cell.joint(j).prismatic()) {
        gram += jacobian.col(j) * jacobian.col(j).transpose();
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gram, Eigen::EigenvaluesOnly);
  const double smallest = std::max(solver.eigenvalues()(0), 0.0);
  const double largest = solver.eigenvalues()(2);
  return largest > 0.0 ? std::sqrt(smallest / largest) : 0.0;
}

JointVector jointSpeedsFromMotors(const Cell& cell, const JointVector& motorRpm) {
  if (motorRpm.size() != cell.jointCount()) {
    throw Error(ErrorCode::InvalidArgument,
                text("expected %1 motor speeds, got %2",
                     {std::to_string(cell.jointCount()), std::to_string(motorRpm.size())}));
  }
  JointVector speeds(motorRpm.size());
  for (int j = 0; j < cell.jointCount(); ++j) {
    const Joint& joint = cell.joint(j);
    if (!(joint.ratio > 0.0)) {
      throw Error(ErrorCode::InvalidArgument,
                  text("the reduction ratio of joint %1 is unknown", {joint.name}),
                  text("cell %1", {cell.name}), "add \"ratio\" to the joint in the cell file");
    }
    const double turns = motorRpm(j) / 60.0 / joint.ratio;
    speeds(j) = joint.prismatic() ? turns : turns * 2.0 * kPi;
  }
  return speeds;
}

}  // namespace wcam::cell
