// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"
#include "wcam/cell/positioner.hpp"

#include "inverse_detail.hpp"
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace wcam::cell::detail {

namespace {

constexpr int kLinear = 3;
/// Three linear axes closer to one plane than this (determinant of the unit vectors), or two rotary
/// axes closer to parallel (sine), are no machine that could reach a volume of poses.
constexpr double kIndependent = 1e-3;
/// Orientation left (rad) that rounding may cause.
constexpr double kAligned = 1e-9;
/// Below this sine the first rotary axis is kept from the seed, as alignAxis does.
constexpr double kSingular = 1e-9;

/// Rotary joints after the linear ones, with all that is constant before them at zero values.
Chain rotaryChain(const Chain& robot, int count) {
  Chain chain;
  const std::vector<double> zero(robot.joints.size(), 0.0);
  Chain linear = robot;
  linear.joints.resize(kLinear);
  linear.T_last_tip = Pose::Identity();
  chain.T_root_first = chainPose(linear, zero.data());
  for (int j = 0; j < count; ++j) {
    Joint joint = robot.joints[static_cast<std::size_t>(kLinear + j)];
    const std::size_t coupled = joint.coupling.size();
    joint.coupling.erase(joint.coupling.begin(),
                         joint.coupling.begin() +
                             static_cast<std::ptrdiff_t>(std::min<std::size_t>(coupled, kLinear)));
    chain.joints.push_back(joint);
  }
  return chain;
}

/// True when the first three joints are linear, the others rotary, and neither drives the other.
bool isCartesian(const Chain& robot) {
  if (robot.size() != 5 && robot.size() != 6) {
    return false;
  }
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    if (joint.prismatic() != (j < kLinear)) {
      return false;
    }
    for (int k = 0; j >= kLinear && k < kLinear; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (i < joint.coupling.size() && joint.coupling[i] != 0.0) {
        return false;
      }
    }
  }
  return true;
}

/// Three linear axes that carry two or three rotary ones (Debout M19, M29, for any directions of
/// the axes). The linear axes only shift what the rotary ones hold, so orientation comes first: the
/// first two rotary joints turn one direction of the tool, the tool axis of a 5-axis machine or
/// axis 6 of a 6-axis one, onto the wanted one; the third turns about it; the linear axes close the
/// gap.
class CartesianInverse final : public InverseKinematics {
public:
  CartesianInverse(const Chain& robot, const Tool& tool)
      : robot_(robot), tool_(tool), rotary_(rotaryChain(robot, robot.size() - kLinear)) {
    const std::vector<double> zero(robot.joints.size(), 0.0);
    const ChainAxes axes = chainAxes(robot, zero.data());
    Eigen::Matrix3d directions;
    for (int j = 0; j < kLinear; ++j) {
      directions.col(j) = axes.directions[static_cast<std::size_t>(j)];
    }
    const Eigen::MatrixXd coupling = couplingMatrix(robot);
    independent_ = std::abs(directions.determinant());
    inverseLinear_ = (directions * coupling.topLeftCorner<kLinear, kLinear>()).inverse();
    first_ = axes.directions[kLinear];
    second_ = axes.directions[kLinear + 1];
    sines_ = first_.cross(second_).norm();
    two_ = rotaryChain(robot, 2);
    if (robot.size() == 6) {
      sines_ = std::min(sines_, second_.cross(axes.directions[kLinear + 2]).norm());
      const Joint& last = rotary_.joints.back();
      two_.T_last_tip = dhTransform(last.alpha, last.d, 0.0, 0.0);
      turned_ = Vec3::UnitZ();
    } else {
      two_.T_last_tip = robot.T_last_tip;
      turned_ = tool.axis;
    }
    // Where the direction lies against the first axis at zero, a positive motion leads to the other
    // side than where it lies along it.
    const bool against = (chainPose(two_, zero.data()).linear() * turned_).dot(first_) < 0.0;
    positiveSide_ = (two_.joints[1].sign > 0.0) != against ? 1.0 : -1.0;
  }

  [[nodiscard]] bool usable() const {
    return independent_ >= kIndependent && sines_ >= kIndependent;
  }

  [[nodiscard]] InverseMethod method() const override { return InverseMethod::Cartesian; }

  [[nodiscard]] int joints() const override { return robot_.size(); }

  [[nodiscard]] int branches() const override { return 2; }

  [[nodiscard]] std::string branchName(int branch) const override {
    return robot_.joints[kLinear + 1].name + (branch == 0 ? "+" : "-");
  }

  [[nodiscard]] int branchOf(const double* q) const override { return sideOf(directionAt(q)); }

  [[nodiscard]] SingularityMeasures measures(const double* q) const override {
    SingularityMeasures own;
    own.wristSine = first_.cross(directionAt(q)).norm() * sines_;
    return own;
  }

  [[nodiscard]] InverseSolution solve(const Pose& T_base_flange,
                                      int branch,
                                      const double* seed) const override {
    InverseSolution solution;
    solution.joints = JointVector::Zero(robot_.size());
    if (!T_base_flange.matrix().allFinite()) {
      solution.missing = std::numeric_limits<double>::infinity();
      return solution;
    }
    const Vec3 target = wantedDirection(T_base_flange);
    turnTowards(target, branch, seed, solution);
    solution.wristSine = first_.cross(target).norm() * sines_;
    solution.wristSingular = first_.cross(target).norm() < kSingular;
    if (robot_.size() == 6) {
      turnAboutLast(T_base_flange, solution.joints);
    }
    const Pose reached = chainPose(robot_, solution.joints.data());
    const Vec3 gap = T_base_flange * tool_.point - reached * tool_.point;
    solution.joints.head<kLinear>() = inverseLinear_ * gap;
    solution.reachable = solution.tilt <= kAligned;
    return solution;
  }

private:
  /// The direction that the first two rotary joints turn, with the first at zero.
  [[nodiscard]] Vec3 directionAt(const double* q) const {
    std::array<double, 2> values{0.0, q[kLinear + 1]};
    const auto& coupling = two_.joints[1].coupling;
    if (!coupling.empty()) {
      values[1] += two_.joints[1].sign * coupling[0] * q[kLinear];
    }
    return chainPose(two_, values.data()).linear() * turned_;
  }

  [[nodiscard]] Vec3 wantedDirection(const Pose& T_base_flange) const {
    return robot_.size() == 6
               ? Vec3(T_base_flange.linear() * robot_.T_last_tip.linear().transpose().col(2))
               : Vec3(T_base_flange.linear() * tool_.axis);
  }

  /// 0 on the side to which a positive motion of the second joint leads from the posture in which
  /// the direction is in line with the first axis.
  [[nodiscard]] int sideOf(const Vec3& direction) const {
    return first_.cross(direction).dot(second_) * positiveSide_ >= 0.0 ? 0 : 1;
  }

  void turnTowards(const Vec3& target,
                   int branch,
                   const double* seed,
                   InverseSolution& solution) const {
    const std::array<double, 2> start = {seed != nullptr ? seed[kLinear] : 0.0,
                                         seed != nullptr ? seed[kLinear + 1] : 0.0};
    const PositionerResult result = alignAxis(two_, turned_, target, start);
    std::size_t chosen = 0;
    if (result.count == 2) {
      // alignAxis gives the side of first × second first; sideOf counts from the other one.
      chosen = (branch == 0) == (positiveSide_ > 0.0) ? 1 : 0;
    }
    solution.joints(kLinear) = result.solutions[chosen].joints[0];
    solution.joints(kLinear + 1) = result.solutions[chosen].joints[1];
    solution.tilt = result.solutions[chosen].residual;
  }

  void turnAboutLast(const Pose& T_base_flange, JointVector& q) const {
    const Joint& last = rotary_.joints.back();
    const Eigen::Matrix3d turn = chainPose(two_, q.data() + kLinear).linear().transpose() *
                                 T_base_flange.linear() * robot_.T_last_tip.linear().transpose();
    double value = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1)) - last.theta;
    for (std::size_t k = 0; k < last.coupling.size(); ++k) {
      value -= last.coupling[k] * q(static_cast<Eigen::Index>(kLinear + k));
    }
    q(kLinear + 2) = wrapAngle(value * last.sign);
  }

  Chain robot_;
  Tool tool_;
  Chain rotary_;
  Chain two_;  ///< the first two rotary joints
  Vec3 first_ = Vec3::UnitZ();
  Vec3 second_ = Vec3::UnitX();
  Vec3 turned_ = Vec3::UnitZ();  ///< direction that they turn, in the tip of two_
  Eigen::Matrix3d inverseLinear_ = Eigen::Matrix3d::Identity();
  double positiveSide_ = 1.0;  ///< sign of first × direction · second on the side of branch 0
  double independent_ = 1.0;
  double sines_ = 1.0;
};

}  // namespace

std::shared_ptr<const InverseKinematics> makeCartesianInverse(const Chain& robot,
                                                              const Tool& tool) {
  if (!isCartesian(robot)) {
    return nullptr;
  }
  auto inverse = std::make_shared<const CartesianInverse>(robot, tool);
  return inverse->usable() ? inverse : nullptr;
}

}  // namespace wcam::cell::detail
