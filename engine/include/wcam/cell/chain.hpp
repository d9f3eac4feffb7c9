// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/joints.hpp"
#include "wcam/geometry/types.hpp"

#include <limits>
#include <string>
#include <vector>

namespace wcam::cell {

using geometry::Pose;
using geometry::Vec3;

/// Columns: one per joint. Rows: linear velocity (mm per rad, or mm per mm), then angular velocity.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 12>;
/// Linear velocity of the TCP in the part frame per joint.
using PartJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 12>;

enum class JointType {
  Revolute,  ///< values in rad
  Prismatic  ///< values in mm
};

/// A joint in modified Denavit–Hartenberg form (Khalil):
/// Rot(x, alpha)·Trans(x, d)·Rot(z, angle)·Trans(z, length). With the controller values q and
/// v = sign·q + Σ coupling[k]·q[k] over the joints before it, a revolute joint has
/// angle = theta + v and length = r, a prismatic one angle = theta and length = r + v.
/// Wherever a quantity of a joint is in rad below, it is in mm for a prismatic joint.
struct Joint {
  std::string name;
  JointType type = JointType::Revolute;
  double alpha = 0.0;  ///< rad
  double d = 0.0;      ///< mm
  double theta = 0.0;  ///< angle at zero controller values, rad
  double r = 0.0;      ///< mm
  double sign = 1.0;   ///< +1 or −1
  /// Factors of the values of the earlier joints (FANUC J3: −1 for J2); may be shorter than their
  /// number.
  std::vector<double> coupling;
  bool endless = false;
  double min = -std::numeric_limits<double>::infinity();  ///< controller value, rad
  double max = std::numeric_limits<double>::infinity();
  double maxSpeed = 0.0;  ///< rad/s, always positive
  /// rad/s² and rad/s³; infinite when the file does not tell.
  double maxAcceleration = std::numeric_limits<double>::infinity();
  double maxJerk = std::numeric_limits<double>::infinity();
  /// Motor turns per turn of the joint, or per mm; 0 when the file does not tell.
  double ratio = 0.0;
  double resolution = 0.0;  ///< smallest programmable step, rad; 0 when the file does not tell
  double backlash = 0.0;    ///< lost motion at a reversal, rad; 0 when the file does not tell

  [[nodiscard]] bool prismatic() const { return type == JointType::Prismatic; }

  [[nodiscard]] bool within(double value) const { return value >= min && value <= max; }
};

/// A serial chain from a root frame to a tip frame.
struct Chain {
  Pose T_root_first = Pose::Identity();  ///< frame that the first joint's alpha and d start from
  std::vector<Joint> joints;
  Pose T_last_tip = Pose::Identity();  ///< tip (flange, table) in the last joint's frame

  [[nodiscard]] int size() const { return static_cast<int>(joints.size()); }
};

/// Rot(x, alpha)·Trans(x, d)·Rot(z, angle)·Trans(z, r).
Pose dhTransform(double alpha, double d, double angle, double r);

/// d(angle or length)/dq: lower triangular matrix of signs and couplings.
Eigen::MatrixXd couplingMatrix(const Chain& chain);

/// Pose of the tip in the root frame. `q` points to chain.size() controller values.
Pose chainPose(const Chain& chain, const double* q);

/// Poses of the frames that turn with each joint, in the root frame, then of the tip: chain.size()
/// + 1 poses. `q` points to chain.size() controller values.
void chainFrames(const Chain& chain, const double* q, Pose* frames);

/// Axis lines (point, unit direction) of all joints in the root frame, then the tip.
struct ChainAxes {
  std::vector<Vec3> points;
  std::vector<Vec3> directions;
  Pose T_root_tip = Pose::Identity();
};

ChainAxes chainAxes(const Chain& chain, const double* q);

/// Geometric Jacobian of a point that moves with the tip, both in the root frame, per controller
/// value.
Jacobian chainJacobian(const Chain& chain, const double* q, const Vec3& point);

}  // namespace wcam::cell
