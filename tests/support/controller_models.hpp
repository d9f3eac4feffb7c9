// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

/// Kinematics of the controllers of the shipped cells, written from public data and apart from the
/// cell files: the ROS-Industrial models of the M-20iA (ARC Mate 120iC), of the KR16-2 and of the
/// GP12, which has the links of the MA1440; the KR360 has the KR16's structure with the lengths of
/// Carrière's Table 2-2. Axes and offsets as those models give them, links along x, base at the
/// controller's origin; the flange is the controller's (tool0).
namespace wcam::test {

struct ControllerModel {
  struct Axis {
    Eigen::Vector3d offset;  ///< from the axis before, at zero, mm
    Eigen::Vector3d axis;
  };

  std::array<Axis, 6> axes;
  Eigen::Vector3d toFlange;       ///< from the last axis, mm
  Eigen::Matrix3d flange;         ///< orientation of the flange at zero
  bool j3FromHorizontal = false;  ///< FANUC: axis 3 turns by J2 + J3

  /// Flange in the base, degrees.
  [[nodiscard]] Eigen::Isometry3d flangeAt(const std::vector<double>& degrees) const {
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double value = degrees[i] + (j3FromHorizontal && i == 2 ? degrees[1] : 0.0);
      pose = pose * Eigen::Translation3d(axes[i].offset) *
             Eigen::AngleAxisd(value * kDegree, axes[i].axis);
    }
    pose = pose * Eigen::Translation3d(toFlange);
    pose.linear() = pose.linear() * flange;
    return pose;
  }
};

namespace detail {

inline const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
inline const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
inline const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

/// x up, z forward: rpy (180, -90, 0) degrees.
inline Eigen::Matrix3d upward() {
  Eigen::Matrix3d rotation;
  rotation.col(0) = kZ;
  rotation.col(1) = -kY;
  rotation.col(2) = kX;
  return rotation;
}

/// x down, z forward: rpy (0, 90, 0) degrees.
inline Eigen::Matrix3d downward() {
  Eigen::Matrix3d rotation;
  rotation.col(0) = -kZ;
  rotation.col(1) = kY;
  rotation.col(2) = kX;
  return rotation;
}

inline ControllerModel kuka(double height, double a1, double a2, double a3, double d4, double d6) {
  return {{{{{0, 0, height}, -kZ},
            {{a1, 0, 0}, kY},
            {{a2, 0, 0}, kY},
            {{d4, 0, -a3}, -kX},
            {{0, 0, 0}, kY},
            {{0, 0, 0}, -kX}}},
          {d6, 0, 0},
          downward()};
}

}  // namespace detail

/// @param cell file name of a shipped cell without its extension
inline ControllerModel controllerModel(const std::string& cell) {
  using namespace detail;
  if (cell.starts_with("fanuc_arcmate120ic")) {
    return {{{{{0, 0, 0}, kZ},
              {{150, 0, 0}, kY},
              {{0, 0, 790}, -kY},
              {{0, 0, 250}, -kX},
              {{835, 0, 0}, -kY},
              {{100, 0, 0}, -kX}}},
            {0, 0, 0},
            upward(),
            true};
  }
  return cell.starts_with("kuka_kr16") ? kuka(675, 260, 680, 35, 670, 158)
                                       : kuka(1045, 500, 1300, 55, 1025, 425);
}

/// Table of a shipped cell's positioner from its root: tilt about an axis across, then turn.
/// @param values of the external axes, degrees
inline Eigen::Isometry3d tableFromRoot(const std::string& cell, const std::vector<double>& values) {
  using namespace detail;
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  if (values.empty()) {
    return Eigen::Isometry3d::Identity();
  }
  if (values.size() == 1) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(values[0] * kDegree, kZ));
  }
  const bool fanuc = cell.starts_with("fanuc");
  const double height = fanuc ? 149.631 : 150.0;
  return Eigen::AngleAxisd(values[0] * kDegree, fanuc ? kY : Eigen::Vector3d(-kY)) *
         Eigen::Translation3d(0, 0, height) *
         Eigen::Isometry3d(Eigen::AngleAxisd(values[1] * kDegree, kZ));
}

}  // namespace wcam::test
