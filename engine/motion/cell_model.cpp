// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cell_model.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

double dexterityOf(const cell::Matrix6& jacobian) {
  const auto block = jacobian.topRows<3>();
  const Eigen::Matrix3d gram = block * block.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(gram, Eigen::EigenvaluesOnly);
  const double smallest = std::max(solver.eigenvalues()(0), 0.0);
  const double largest = solver.eigenvalues()(2);
  return largest > 0.0 ? std::sqrt(smallest / largest) : 0.0;
}

}  // namespace

CellModel::CellModel(const cell::Cell& cell) : cell_(cell) {
  WCAM_ASSERT(cell.robotJoints() == 6 && cell.arm.has_value());
  for (std::size_t j = 0; j < 6; ++j) {
    const cell::Joint& joint = cell.robot.joints[j];
    Link& link = links_[j];
    link = {std::cos(joint.alpha),
            std::sin(joint.alpha),
            joint.d,
            joint.r,
            joint.theta,
            joint.sign,
            {}};
    std::copy(joint.coupling.begin(), joint.coupling.end(), link.coupling.begin());
  }
  const cell::Matrix6& gain = cell.arm->gain;
  cableSign_ = gain(3, 3) * gain(5, 5) < 0.0 ? -1.0 : 1.0;
  for (int j = 0; j < cell.jointCount(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    motionWeight_[static_cast<std::size_t>(j)] =
        joint.endless ? 0.0 : 1.0 / radToDeg(joint.max - joint.min);
  }
}

ArmState CellModel::armState(const cell::JointVector& q) const {
  std::array<Vec3, 6> points;
  std::array<Vec3, 6> axes;
  Eigen::Matrix3d rotation = cell_.robot.T_root_first.linear();
  Vec3 origin = cell_.robot.T_root_first.translation();
  for (std::size_t j = 0; j < 6; ++j) {
    const Link& link = links_[j];
    double angle = link.theta + link.sign * q(static_cast<Eigen::Index>(j));
    for (std::size_t k = 0; k < j; ++k) {
      angle += link.coupling[k] * q(static_cast<Eigen::Index>(k));
    }
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Eigen::Matrix3d step;
    step << c, -s, 0, link.ca * s, link.ca * c, -link.sa, link.sa * s, link.sa * c, link.ca;
    origin += rotation * Vec3(link.d, -link.r * link.sa, link.r * link.ca);
    rotation = rotation * step;
    points[j] = origin;
    axes[j] = rotation.col(2);
  }
  Vec3 tcp = cell_.T_base_tcp.translation();
  if (!cell_.partCarried()) {
    const Pose T_last_tcp = cell_.robot.T_last_tip * cell_.T_flange_tcp;
    tcp = origin + rotation * T_last_tcp.translation();
  }
  ArmState state;
  for (std::size_t j = 0; j < 6; ++j) {
    cell::Vector6 twist;
    twist.head<3>() = axes[j].cross(tcp - points[j]);
    twist.tail<3>() = axes[j];
    state.jacobian.col(static_cast<Eigen::Index>(j)) += links_[j].sign * twist;
    for (std::size_t k = 0; k < j; ++k) {
      if (links_[j].coupling[k] != 0.0) {
        state.jacobian.col(static_cast<Eigen::Index>(k)) += links_[j].coupling[k] * twist;
      }
    }
  }
  state.dexterity = dexterityOf(state.jacobian);
  const cell::Arm& arm = *cell_.arm;
  const cell::Vector6 c = arm.gain * q.head<6>() + arm.offset;
  const double forearm = std::hypot(arm.d4, arm.r4);
  const double c23 = c(1) + c(2);
  state.wristSine = std::abs(std::sin(c(4)));
  state.elbowSine = std::abs(-arm.d4 * std::cos(c(2)) + arm.r4 * std::sin(c(2))) / forearm;
  state.axisDistance = std::hypot(
      arm.a1 + arm.a2 * std::sin(c(1)) - arm.d4 * std::cos(c23) + arm.r4 * std::sin(c23), arm.b);
  return state;
}

}  // namespace wcam::motion::detail
