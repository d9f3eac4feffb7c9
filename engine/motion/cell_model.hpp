// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  cell::Matrix6 jacobian = cell::Matrix6::Zero();  ///< of the TCP (torch carried) or of the flange
                                                   ///< point under it, base frame; mm, rad
  double dexterity = 0.0;     ///< smallest over largest singular value of the linear rows
  double wristSine = 1.0;     ///< |sin| of the wrist's bend
  double elbowSine = 1.0;     ///< |sin| of the elbow's bend
  double axisDistance = 0.0;  ///< wrist centre to axis 1, mm
};

class CellModel {
public:
  /// @param cell must live as long; its robot has 6 joints and a closed form
  explicit CellModel(const cell::Cell& cell);

  [[nodiscard]] const cell::Cell& cell() const { return cell_; }

  /// About 0.6 µs.
  [[nodiscard]] ArmState armState(const cell::JointVector& q) const;

  /// J4 + J6 in the sense in which both turn the cable alike, from the cable's zero.
  [[nodiscard]] double cableTwist(const cell::JointVector& q, double zero) const {
    return q(3) + cableSign_ * q(5) - zero;
  }

  [[nodiscard]] double cableSign() const { return cableSign_; }

  /// 1/stroke of a joint in 1/degree, 0 for endless ones (Chalvin Eq. 4.3).
  [[nodiscard]] double motionWeight(int joint) const {
    return motionWeight_[static_cast<std::size_t>(joint)];
  }

private:
  struct Link {
    double ca, sa, d, r, theta, sign;
    std::array<double, 6> coupling;
  };

  const cell::Cell& cell_;
  std::array<Link, 6> links_{};
  double cableSign_ = 1.0;
  std::array<double, 12> motionWeight_{};
};

}  // namespace wcam::motion::detail
