// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/chain.hpp"

#include <cmath>

namespace wcam::cell {

namespace {

/// The double next to π/2, and its cosine.
constexpr double kRightAngle = 1.5707963267948966;
constexpr double kCosineRightAngle = 6.123233995736766e-17;

/// What the controller values add to the joint's angle or length.
double jointMotion(const Joint& joint, int index, const double* q) {
  double value = joint.sign * q[index];
  for (std::size_t k = 0; k < joint.coupling.size(); ++k) {
    value += joint.coupling[k] * q[k];
  }
  return value;
}

Pose jointTransform(const Joint& joint, int index, const double* q) {
  const double value = jointMotion(joint, index, q);
  return joint.prismatic() ? dhTransform(joint.alpha, joint.d, joint.theta, joint.r + value)
                           : dhTransform(joint.alpha, joint.d, joint.theta + value, joint.r);
}

}  // namespace

Pose dhTransform(double alpha, double d, double angle, double r) {
  // Most axes are parallel or square to the one before; half of the time goes into these two else.
  const bool parallel = alpha == 0.0;
  const double ca = parallel                         ? 1.0
                    : std::abs(alpha) == kRightAngle ? kCosineRightAngle
                                                     : std::cos(alpha);
  const double sa = parallel                         ? 0.0
                    : std::abs(alpha) == kRightAngle ? std::copysign(1.0, alpha)
                                                     : std::sin(alpha);
  const double ct = std::cos(angle);
  const double st = std::sin(angle);
  Pose pose;
  pose.matrix() << ct, -st, 0, d,      //
      ca * st, ca * ct, -sa, -r * sa,  //
      sa * st, sa * ct, ca, r * ca,    //
      0, 0, 0, 1;
  return pose;
}

Eigen::MatrixXd couplingMatrix(const Chain& chain) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(chain.size(), chain.size());
  for (int j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[static_cast<std::size_t>(j)];
    for (std::size_t k = 0; k < joint.coupling.size(); ++k) {
      m(j, static_cast<Eigen::Index>(k)) = joint.coupling[k];
    }
    m(j, j) = joint.sign;
  }
  return m;
}

Pose chainPose(const Chain& chain, const double* q) {
  Pose pose = chain.T_root_first;
  for (int j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[static_cast<std::size_t>(j)];
    pose = pose * jointTransform(joint, j, q);
  }
  return pose * chain.T_last_tip;
}

void chainFrames(const Chain& chain, const double* q, Pose* frames) {
  Pose pose = chain.T_root_first;
  for (int j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[static_cast<std::size_t>(j)];
    pose = pose * jointTransform(joint, j, q);
    frames[j] = pose;
  }
  frames[chain.size()] = pose * chain.T_last_tip;
}

ChainAxes chainAxes(const Chain& chain, const double* q) {
  ChainAxes axes;
  axes.points.reserve(chain.joints.size());
  axes.directions.reserve(chain.joints.size());
  Pose pose = chain.T_root_first;
  for (int j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[static_cast<std::size_t>(j)];
    pose = pose * jointTransform(joint, j, q);
    axes.points.push_back(pose.translation());
    axes.directions.push_back(pose.linear().col(2));
  }
  axes.T_root_tip = pose * chain.T_last_tip;
  return axes;
}

Jacobian chainJacobian(const Chain& chain, const double* q, const Vec3& point) {
  const ChainAxes axes = chainAxes(chain, q);
  const int n = chain.size();
  Jacobian jacobian = Jacobian::Zero(6, n);
  for (int j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    Eigen::Matrix<double, 6, 1> twist;
    const Joint& joint = chain.joints[i];
    if (joint.prismatic()) {
      twist.head<3>() = axes.directions[i];
      twist.tail<3>().setZero();
    } else {
      twist.head<3>() = axes.directions[i].cross(point - axes.points[i]);
      twist.tail<3>() = axes.directions[i];
    }
    jacobian.col(j) += joint.sign * twist;
    for (std::size_t k = 0; k < joint.coupling.size(); ++k) {
      jacobian.col(static_cast<Eigen::Index>(k)) += joint.coupling[k] * twist;
    }
  }
  return jacobian;
}

}  // namespace wcam::cell
