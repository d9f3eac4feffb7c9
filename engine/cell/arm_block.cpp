// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/cell/arm.hpp"

#include "arm_kernel.hpp"

namespace wcam::cell {

static_assert(PoseBlock::kSize == ArmConstants::kLanes);

namespace {

void rowMajor(const Pose& pose, double* out) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      out[3 * i + k] = pose.linear()(i, k);
    }
    out[9 + i] = pose.translation()(i);
  }
}

ArmConstants constantsOf(const Arm& arm) {
  ArmConstants k{};
  rowMajor(arm.T_base_canonical.inverse(), k.base);
  rowMajor(arm.T_wrist_flange.inverse(), k.wrist);
  k.a1 = arm.a1;
  k.a2 = arm.a2;
  k.d4 = arm.d4;
  k.r4 = arm.r4;
  k.b = arm.b;
  int n = 0;
  const Vector6 zero = -(arm.inverseGain * arm.offset);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) {
      k.gain[n++] = arm.inverseGain(i, j);
    }
    k.zero[i] = zero(i);
    k.turn[i] = arm.periodic[static_cast<std::size_t>(i)] ? 2.0 * kPi : 0.0;
  }
  return k;
}

}  // namespace

void PoseBlock::set(int lane, const Pose& T_base_flange) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      rotation[3 * i + k][lane] = T_base_flange.linear()(i, k);
    }
    position[i][lane] = T_base_flange.translation()(i);
  }
}

void inverseBlock(const Arm& arm, PoseBlock& poses, int count, JointBlock& result) {
  // Unused lanes repeat the first pose, so that no lane holds garbage.
  for (int n = count > 0 ? count : 0; n < PoseBlock::kSize; ++n) {
    for (auto& row : poses.rotation) {
      row[n] = count > 0 ? row[0] : 0.0;
    }
    for (auto& row : poses.position) {
      row[n] = count > 0 ? row[0] : 0.0;
    }
  }
  solveLanes(constantsOf(arm), {poses.rotation, poses.position}, {result.joints, result.reachable});
}

}  // namespace wcam::cell
