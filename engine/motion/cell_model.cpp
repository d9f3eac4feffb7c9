// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cell_model.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/unwrap.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// A sine of rounding.
constexpr double kInLine = 1e-9;

double dexterityOf(const Eigen::Matrix<double, 3, 6>& block) {
  const Eigen::Matrix3d gram = block * block.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(gram, Eigen::EigenvaluesOnly);
  const double smallest = std::max(solver.eigenvalues()(0), 0.0);
  const double largest = solver.eigenvalues()(2);
  return largest > 0.0 ? std::sqrt(smallest / largest) : 0.0;
}

}  // namespace

double marginSine(const cell::Cell& cell, double wristSine) {
  const bool machine = cell.inverse->method() == cell::InverseMethod::Cartesian;
  return machine && wristSine < kInLine ? 1.0 : wristSine;
}

CellModel::CellModel(const cell::Cell& cell) : cell_(cell) {
  WCAM_ASSERT(cell.robotJoints() <= 6 && cell.inverse != nullptr);
  joints_ = cell.robotJoints();
  int linear = 0;
  for (std::size_t j = 0; j < cell.robot.joints.size(); ++j) {
    const cell::Joint& joint = cell.robot.joints[j];
    linear += joint.prismatic() ? 1 : 0;
    Link& link = links_[j];
    link = {
        std::cos(joint.alpha), std::sin(joint.alpha), joint.d, joint.r, joint.theta, joint.sign, {},
        joint.prismatic()};
    std::copy(joint.coupling.begin(), joint.coupling.end(), link.coupling.begin());
  }
  threeLinear_ = linear >= 3;
  if (cell.arm) {
    const cell::Matrix6& gain = cell.arm->gain;
    cableSign_ = gain(3, 3) * gain(5, 5) < 0.0 ? -1.0 : 1.0;
  }
  for (int j = 0; j < cell.jointCount(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    const auto k = static_cast<std::size_t>(j);
    prismatic_[k] = joint.prismatic();
    periodic_[k] = cell::periodicJoint(cell, j);
    const double stroke = joint.endless ? 0.0 : joint.max - joint.min;
    travelRange_[k] = inUnit(j, joint.prismatic() ? stroke : std::max(stroke, 2.0 * kPi));
    motionWeight_[k] = joint.endless ? 0.0 : 1.0 / inUnit(j, joint.max - joint.min);
  }
}

ArmState CellModel::armState(const cell::JointVector& q) const {
  std::array<Vec3, 6> points;
  std::array<Vec3, 6> axes;
  Eigen::Matrix3d rotation = cell_.robot.T_root_first.linear();
  Vec3 origin = cell_.robot.T_root_first.translation();
  const auto joints = static_cast<std::size_t>(joints_);
  for (std::size_t j = 0; j < joints; ++j) {
    const Link& link = links_[j];
    const double moved = movedTo(j, q);
    const double angle = link.prismatic ? link.theta : moved;
    const double r = link.prismatic ? moved : link.r;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Eigen::Matrix3d step;
    step << c, -s, 0, link.ca * s, link.ca * c, -link.sa, link.sa * s, link.sa * c, link.ca;
    origin += rotation * Vec3(link.d, -r * link.sa, r * link.ca);
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
  for (std::size_t j = 0; j < joints; ++j) {
    cell::Vector6 twist;
    if (links_[j].prismatic) {
      twist << axes[j], Vec3::Zero();
    } else {
      twist.head<3>() = axes[j].cross(tcp - points[j]);
      twist.tail<3>() = axes[j];
    }
    state.jacobian.col(static_cast<Eigen::Index>(j)) += links_[j].sign * twist;
    for (std::size_t k = 0; k < j; ++k) {
      if (links_[j].coupling[k] != 0.0) {
        state.jacobian.col(static_cast<Eigen::Index>(k)) += links_[j].coupling[k] * twist;
      }
    }
  }
  if (joints == 5) {
    const Vec3 axis =
        rotation * (cell_.robot.T_last_tip.linear() * cell_.T_flange_tcp.linear().col(2));
    state.jacobian.col(5) << Vec3::Zero(), axis;
  }
  state.dexterity = dexterityOf(linearBlock(state.jacobian));
  if (cell_.arm) {
    const cell::ArmMeasures own = cell::armMeasures(*cell_.arm, q.data());
    state.wristSine = own.wristSine;
    state.elbowSine = own.elbowSine;
    state.axisDistance = own.axisDistance;
  } else {
    const cell::SingularityMeasures own = cell_.inverse->measures(q.data());
    state.wristSine = marginSine(cell_, own.wristSine);
    state.elbowSine = own.elbowSine;
    state.axisDistance = own.axisDistance;
  }
  return state;
}

int CellModel::firstOf(const cell::JointSum& sum) {
  const auto found =
      std::find_if(sum.factors.begin(), sum.factors.end(), [](double f) { return f != 0.0; });
  return found == sum.factors.end() ? 0 : static_cast<int>(found - sum.factors.begin());
}

double CellModel::movedTo(std::size_t joint, const cell::JointVector& q) const {
  const Link& link = links_[joint];
  double value = link.prismatic ? link.r : link.theta;
  value += link.sign * q(static_cast<Eigen::Index>(joint));
  for (std::size_t k = 0; k < joint; ++k) {
    value += link.coupling[k] * q(static_cast<Eigen::Index>(k));
  }
  return value;
}

Eigen::Matrix<double, 3, 6> CellModel::linearBlock(const cell::Matrix6& jacobian) const {
  Eigen::Matrix<double, 3, 6> block = jacobian.topRows<3>();
  for (std::size_t j = 0; threeLinear_ && j < 6; ++j) {
    if (!links_[j].prismatic) {
      block.col(static_cast<Eigen::Index>(j)).setZero();
    }
  }
  return block;
}

}  // namespace wcam::motion::detail
