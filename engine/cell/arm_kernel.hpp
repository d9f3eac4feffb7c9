// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The vector kernel of inverseBlock on plain arrays. Private to this module; see arm_kernel.cpp.
namespace wcam::cell {

/// Arm data as plain numbers.
struct ArmConstants {
  static constexpr int kLanes = 128;
  double base[12];   ///< canonical base from robot base: rotation row major, translation
  double wrist[12];  ///< wrist in the flange frame, likewise
  double a1, a2, d4, r4, b;
  double gain[21];  ///< lower triangle of the inverse gain, row by row
  double zero[6];   ///< controller values at zero canonical angles
  double turn[6];   ///< a full turn for periodic joints, else 0
};

/// Flange poses, structure of arrays.
struct LanePoses {
  const double (*rotation)[ArmConstants::kLanes];  ///< 9 rows, row major
  const double (*position)[ArmConstants::kLanes];  ///< 3 rows
};

/// Where results go: see JointBlock.
struct LaneResults {
  double (*joints)[6][ArmConstants::kLanes];
  double (*reachable)[ArmConstants::kLanes];
};

void solveLanes(const ArmConstants& k, const LanePoses& poses, const LaneResults& result);

}  // namespace wcam::cell
