// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/cell.hpp"

#include <array>

/// Kinematics of a cell laid out for the many calls of planning: no heap, constants found once.
/// Private to this module.
namespace wcam::motion::detail {

using geometry::Pose;
using geometry::Vec3;

/// First-order data of a robot posture.
struct ArmState {
  /// Of the TCP (torch carried) or of the flange point under it, base frame; mm, rad. Of a robot
  /// with 5 joints column 5 is the rotation about the tool axis, which it leaves open.
  cell::Matrix6 jacobian = cell::Matrix6::Zero();
  double dexterity = 0.0;  ///< as cell::dexterity
  double wristSine = 1.0;  ///< as cell::InverseSolution; see marginSine
  double elbowSine = 1.0;
  double axisDistance = 0.0;  ///< mm
};

/// A joint step of this length counts as one of a radian where both must be added, mm: a point at
/// this distance from an axis.
inline constexpr double kLengthPerRadian = 100.0;

/// The sine that singularity margins look at. The tool of a Cartesian machine exactly in line with
/// the first rotary axis leaves that axis free: it rests while the tool axis does, and where it
/// does not the points beside show the singularity. So a flat layer under a vertical torch breaks
/// no margin.
double marginSine(const cell::Cell& cell, double wristSine);

class CellModel {
public:
  /// @param cell must live as long; its robot has at most 6 joints
  explicit CellModel(const cell::Cell& cell);

  [[nodiscard]] const cell::Cell& cell() const { return cell_; }

  /// About 0.6 µs.
  [[nodiscard]] ArmState armState(const cell::JointVector& q) const;

  /// J4 + J6 in the sense in which both turn the cable alike, from the cable's zero; 0 of a robot
  /// that is no arm with a spherical wrist (see cell::JointSum for those).
  [[nodiscard]] double cableTwist(const cell::JointVector& q, double zero) const {
    return cell_.arm ? q(3) + cableSign_ * q(5) - zero : 0.0;
  }

  [[nodiscard]] double cableSign() const { return cableSign_; }

  /// 1/stroke of a joint in 1/degree or 1/mm, 0 for endless ones (Chalvin Eq. 4.3).
  [[nodiscard]] double motionWeight(int joint) const {
    return motionWeight_[static_cast<std::size_t>(joint)];
  }

  /// The stroke against which moves between beads count, in degrees (at least a turn) or mm.
  [[nodiscard]] double travelRange(int joint) const {
    return travelRange_[static_cast<std::size_t>(joint)];
  }

  /// A full turn of the joint changes no pose (cell::periodicJoint).
  [[nodiscard]] bool periodic(int joint) const {
    return periodic_[static_cast<std::size_t>(joint)];
  }

  /// rad or mm to degrees or mm: objectives and penalties of joints are in these.
  [[nodiscard]] double inUnit(int joint, double value) const {
    return prismatic_[static_cast<std::size_t>(joint)] ? value : radToDeg(value);
  }

  /// rad or mm to rad, where steps of several joints are added.
  [[nodiscard]] double asAngle(int joint, double value) const {
    return prismatic_[static_cast<std::size_t>(joint)] ? value / kLengthPerRadian : value;
  }

  /// Standard deviation of a joint's position, rad or mm: the file's resolution, else `otherwise`
  /// (rad, or of a linear joint what that is at kLengthPerRadian).
  [[nodiscard]] double resolution(int joint, double otherwise) const {
    const double own = cell_.joint(joint).resolution;
    const bool linear = prismatic_[static_cast<std::size_t>(joint)];
    return own > 0.0 ? own : (linear ? kLengthPerRadian * otherwise : otherwise);
  }

  /// The first joint of a sum: all are of its kind.
  [[nodiscard]] static int firstOf(const cell::JointSum& sum);

private:
  struct Link {
    double ca, sa, d, r, theta, sign;
    std::array<double, 6> coupling;
    bool prismatic;
  };

  /// Angle or length of a joint: that at zero + sign·q + Σ coupling·q.
  [[nodiscard]] double movedTo(std::size_t joint, const cell::JointVector& q) const;
  /// The linear rows of the joints that dexterity looks at.
  [[nodiscard]] Eigen::Matrix<double, 3, 6> linearBlock(const cell::Matrix6& jacobian) const;

  const cell::Cell& cell_;
  int joints_ = 6;
  bool threeLinear_ = false;  ///< three prismatic joints move the point alone
  std::array<Link, 6> links_{};
  std::array<bool, 12> periodic_{}, prismatic_{};
  double cableSign_ = 1.0;
  std::array<double, 12> motionWeight_{}, travelRange_{};
};

}  // namespace wcam::motion::detail
