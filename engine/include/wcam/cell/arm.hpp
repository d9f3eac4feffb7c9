// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/chain.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace wcam::cell {

/// One of the 8 ways in which a 6R arm reaches a pose. Named like FANUC's configuration: wrist N
/// (no flip: bent downwards at zero J4) or F, elbow U (above the line from shoulder to wrist, seen
/// with the wrist before the shoulder) or D, shoulder T (wrist centre before axis 1) or B. Up is z
/// of the base, however axis 1 points. Each changes only by crossing a singularity.
struct Branch {
  bool flipped = false;
  bool elbowDown = false;
  bool backwards = false;

  static constexpr int kCount = 8;

  /// 0..7 in the order NUT, NUB, NDT, NDB, FUT, FUB, FDT, FDB.
  [[nodiscard]] constexpr int index() const {
    return (flipped ? 4 : 0) + (elbowDown ? 2 : 0) + (backwards ? 1 : 0);
  }

  [[nodiscard]] static constexpr Branch fromIndex(int index) {
    return {(index & 4) != 0, (index & 2) != 0, (index & 1) != 0};
  }

  /// "NUT" …
  [[nodiscard]] std::string name() const;

  friend bool operator==(const Branch&, const Branch&) = default;
};

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A 6R arm with a spherical wrist reduced to a canonical form, whatever its DH convention: axis 1
/// (up) is z, 2 and 3 are y, the wrist's axes z, y, z. With canonical angles c the wrist frame in
/// the canonical base is
///   Rz(c1)·Trans(a1, b, 0)·Ry(c2)·Trans(0, 0, a2)·Ry(c3)·Trans(−d4, 0, r4)·Rz(c4)·Ry(c5)·Rz(c6)
/// (Chalvin A23 and A25 corrected, with a lateral offset b), and c = gain·q + offset for the
/// controller values q (couplings and signs are in the gain, lower triangular).
struct Arm {
  Pose T_base_canonical = Pose::Identity();
  Pose T_wrist_flange = Pose::Identity();
  double a1 = 0.0;  ///< axis 1 to axis 2, mm
  double a2 = 0.0;  ///< axis 2 to axis 3, positive
  double d4 = 0.0;  ///< axis 3 to axis 4, positive when axis 4 lies above at a level forearm
  double r4 = 0.0;  ///< along axis 4 from the foot of axis 3 to the wrist centre
  double b = 0.0;   ///< wrist centre beside the plane of axis 1
  Matrix6 gain = Matrix6::Identity();
  Matrix6 inverseGain = Matrix6::Identity();
  Vector6 offset = Vector6::Zero();
  /// Joints whose value may change by a full turn without changing the pose.
  std::array<bool, 6> periodic{};
};

/// Farthest distance of the wrist centre from axis 2, mm.
double armReach(const Arm& arm);

/// Reduces a chain to the canonical form from the geometry of its axes at zero values.
/// @throws Error(ProjectInvalid) naming the geometric condition that does not hold and by how much
Arm reduceArm(const Chain& chain);

/// One solution of the inverse kinematics.
struct IkSolution {
  bool reachable = false;
  /// Controller values; periodic ones in (−π, π]. For an unreachable pose: the arm stretched (or
  /// folded) towards it.
  Vector6 joints = Vector6::Zero();
  double missing = 0.0;        ///< distance of the wrist centre from the reachable range, mm
  double wristSine = 1.0;      ///< |sin c5|; 0 where axes 4 and 6 are in line
  double elbowSine = 1.0;      ///< |sin| of the angle at the elbow; 0 where stretched or folded
  double axisDistance = 0;     ///< wrist centre to axis 1, mm
  bool wristSingular = false;  ///< axis 4 kept from the seed
  bool elbowSingular =
      false;  ///< both elbow branches are the same (or undefined, kept from the seed)
  bool shoulderSingular = false;  ///< wrist centre on axis 1: axis 1 kept from the seed
};

using IkResult = std::array<IkSolution, Branch::kCount>;

/// One branch. `seed` (6 controller values, may be null) decides what a singularity leaves open.
/// Exact to rounding for reachable poses. About 0.5 µs.
IkSolution inverseArm(const Arm& arm,
                      const Pose& T_base_flange,
                      Branch branch,
                      const double* seed = nullptr);
/// All 8 branches, by Branch::index(). About 2 µs.
IkResult inverseArm(const Arm& arm, const Pose& T_base_flange, const double* seed = nullptr);

/// How far a posture is from the singularities of an arm, as in IkSolution.
struct ArmMeasures {
  double wristSine = 1.0;
  double elbowSine = 1.0;
  double axisDistance = 0.0;  ///< mm
};

/// The measures of given controller values. About 0.1 µs.
ArmMeasures armMeasures(const Arm& arm, const double* q);

/// The branch of given controller values.
Branch branchOf(const Arm& arm, const double* q);

/// Forward kinematics of the canonical form (the chain's own up to rounding).
Pose forwardArm(const Arm& arm, const double* q);

/// A block of poses for inverseBlock, structure of arrays.
struct PoseBlock {
  static constexpr int kSize = 128;
  alignas(64) double rotation[9][kSize];  ///< row major, flange in the robot base
  alignas(64) double position[3][kSize];

  void set(int lane, const Pose& T_base_flange);
};

/// Result of inverseBlock: controller values in (−π, π], by branch index, joint, lane.
struct JointBlock {
  alignas(64) double joints[Branch::kCount][6][PoseBlock::kSize];
  /// 1 where the wrist centre is in reach; [0] shoulder T, [1] shoulder B.
  alignas(64) double reachable[2][PoseBlock::kSize];
};

/// All 8 branches of the first `count` poses of a block. Vectorised for the processor found at run
/// time, so its last bits differ between machines: use it to search, and verify what is kept with
/// inverseArm. About 0.1 µs per pose.
void inverseBlock(const Arm& arm, PoseBlock& poses, int count, JointBlock& result);

}  // namespace wcam::cell
