// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"

#include <limits>
#include <span>
#include <string>

namespace wcam::cell {

/// One solution of the inverse kinematics of any robot. As IkSolution, with the robot's own joints.
struct InverseSolution {
  bool reachable = false;
  /// The robot's joints, controller values; periodic ones in (−π, π]. For an unreachable pose: the
  /// nearest that was found.
  JointVector joints;
  double missing = 0.0;  ///< distance left to the wanted point (arm: of the wrist centre), mm
  /// Angle left to the wanted orientation, or to the wanted tool axis where the rotation about it
  /// is not free, rad.
  double tilt = 0.0;
  double wristSine = 1.0;  ///< sine of the angle to a singularity of the orientation axes
  double elbowSine = 1.0;  ///< 0 where an arm is stretched or folded; 1 for robots without elbow
  /// Wrist centre to axis 1, mm; infinite for robots without such an axis.
  double axisDistance = std::numeric_limits<double>::infinity();
  bool wristSingular = false;     ///< orientation axes in line: the first kept from the seed
  bool elbowSingular = false;     ///< both elbow branches are the same
  bool shoulderSingular = false;  ///< axis 1 kept from the seed
};

/// How far a posture is from the singularities of its robot, as in InverseSolution.
struct SingularityMeasures {
  double wristSine = 1.0;
  double elbowSine = 1.0;
  double axisDistance = std::numeric_limits<double>::infinity();
};

enum class InverseMethod {
  Arm,        ///< closed form of a 6R arm with a spherical wrist, 8 branches
  Cartesian,  ///< closed form of 3 prismatic axes that carry 2 or 3 rotary ones, 2 branches
  Numeric     ///< damped least squares for anything else
};

/// Inverse kinematics of a robot from base to flange, whatever its kind. Immutable; may be shared
/// between threads. Found by prepareArm and kept in Cell::inverse.
class InverseKinematics {
public:
  InverseKinematics() = default;
  virtual ~InverseKinematics() = default;
  InverseKinematics(const InverseKinematics&) = delete;
  InverseKinematics& operator=(const InverseKinematics&) = delete;

  [[nodiscard]] virtual InverseMethod method() const = 0;
  /// Number of joints of the robot.
  [[nodiscard]] virtual int joints() const = 0;
  /// Ways to reach a pose. Of the numeric method: start postures of the search.
  [[nodiscard]] virtual int branches() const = 0;
  /// "NUT" of an arm, "A+" or "A-" of a machine after its second rotary joint, "1" … of a search.
  [[nodiscard]] virtual std::string branchName(int branch) const = 0;
  /// The branch of given joint values (robot). Of the numeric method: the nearest start posture.
  [[nodiscard]] virtual int branchOf(const double* q) const = 0;

  /// True when the robot can take any rotation about the tool axis. A machine with 5 joints cannot:
  /// solve() then puts the tool point and the tool axis of the wanted pose in place, and forward
  /// kinematics tells the rotation that goes with it.
  [[nodiscard]] virtual bool freeRotation() const { return joints() >= 6; }

  /// @param seed joint values (robot, may be null) that decide what a singularity leaves open, and
  /// from which a search starts: the numeric method keeps the solution that they lead to, also
  /// outside the limits, so that a path is followed without jumps
  [[nodiscard]] virtual InverseSolution solve(const Pose& T_base_flange,
                                              int branch,
                                              const double* seed = nullptr) const = 0;

  /// All branches at once, cheaper than one by one where the method can.
  /// @param solutions branches() of them
  virtual void solveAll(const Pose& T_base_flange,
                        std::span<InverseSolution> solutions,
                        const double* seed = nullptr) const;

  /// The measures of given joint values (robot).
  [[nodiscard]] virtual SingularityMeasures measures(const double* q) const = 0;

  static constexpr int kMostBranches = 8;
};

/// Flange pose that puts the tool on a point with its axis (unit, towards the torch) along `axis`,
/// both in the robot base; `rotation` is the third Bryant angle of the tool frame (Chalvin A18b).
/// Torch carried.
Pose flangeForTool(const Cell& cell, const Vec3& point, const Vec3& axis, double rotation = 0.0);

/// The same solved.
InverseSolution solveTool(const Cell& cell,
                          const Vec3& point,
                          const Vec3& axis,
                          double rotation,
                          int branch,
                          const double* seed = nullptr);

}  // namespace wcam::cell
