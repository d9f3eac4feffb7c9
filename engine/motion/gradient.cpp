// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gradient.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// Cosine below which a Bryant frame counts as at its gimbal lock: the angle that it leaves open is
/// then not moved.
constexpr double kGimbalLock = 1e-9;
/// Joints per free angle: more than this is the neighbourhood of a singularity, where a linear
/// model says nothing.
constexpr double kSteepest = 50.0;
/// Step of the difference quotient of the tilted axis, which is smooth of size 1; rad.
constexpr double kTiltStep = 1e-6;

/// Direction of the tool axis per lead or lateral tilt, part frame.
Vec3 axisPerTilt(const Target& target, const FreeChoice& choice, bool lead) {
  const double a = lead ? kTiltStep : 0.0;
  const double b = lead ? 0.0 : kTiltStep;
  return (tiltedAxis(target, choice.lead + a, choice.lateral + b) -
          tiltedAxis(target, choice.lead - a, choice.lateral - b)) /
         (2.0 * kTiltStep);
}

/// Angular velocity of the frame with z and a constant third Bryant angle (A18b) when z moves.
Vec3 frameVelocity(const Vec3& z, const Vec3& dz) {
  const double cy = std::hypot(z.y(), z.z());
  if (cy < kGimbalLock) {
    return z.cross(dz);
  }
  const double cx = z.z() / cy;
  const double sx = -z.y() / cy;
  const Vec3 second(0.0, cx, sx);
  const Vec3 towards(cy, sx * z.x(), -cx * z.x());
  return Vec3(-dz.dot(second) / cy, 0.0, 0.0) + second * dz.dot(towards);
}

using Twist = cell::Vector6;

Twist twistOf(const Vec3& linear, const Vec3& angular) {
  Twist twist;
  twist << linear, angular;
  return twist;
}

/// Twists of the TCP, base frame.
void torchCarried(const Cell& cell,
                  const Target& target,
                  const FreeChoice& choice,
                  bool withTilt,
                  Eigen::Matrix<double, 6, kFreeScalars>& twists) {
  const Pose T_base_part =
      cell::chainPose(cell.positioner, choice.positioner.data()) * cell.T_table_part;
  const Vec3 axis = T_base_part.linear() * tiltedAxis(target, choice.lead, choice.lateral);
  const Vec3 p = T_base_part * target.p;
  twists.col(static_cast<int>(FreeScalar::Torch)) = twistOf(Vec3::Zero(), axis);
  const int last = cell.positionerJoints() - 1;
  if (last >= 0) {
    const cell::Jacobian table = cell::chainJacobian(cell.positioner, choice.positioner.data(), p);
    const Vec3 turn = table.col(last).tail<3>();
    twists.col(static_cast<int>(FreeScalar::Table)) =
        twistOf(table.col(last).head<3>(), frameVelocity(axis, turn.cross(axis)));
  }
  for (const bool lead : {true, false}) {
    if (withTilt) {
      const Vec3 dz = T_base_part.linear() * axisPerTilt(target, choice, lead);
      twists.col(static_cast<int>(lead ? FreeScalar::Lead : FreeScalar::Lateral)) =
          twistOf(Vec3::Zero(), frameVelocity(axis, dz));
    }
  }
}

/// Twists of the flange at the fixed deposition point, base frame.
void partCarried(const Cell& cell,
                 const Target& target,
                 const FreeChoice& choice,
                 const Pose& T_part_tcp,
                 bool withTilt,
                 Eigen::Matrix<double, 6, kFreeScalars>& twists) {
  const Eigen::Matrix3d torch = cell.T_base_tcp.linear();
  // A of A18a: part to torch.
  const Eigen::Matrix3d a = T_part_tcp.linear().transpose();
  const double cy = std::hypot(a(1, 2), a(2, 2));
  const double cx = cy < kGimbalLock ? 1.0 : std::max(a(2, 2) / cy, kGimbalLock);
  // A turn about the torch by cy/cx keeps A·axis = z while the third angle moves by 1.
  twists.col(static_cast<int>(FreeScalar::Torch)) = twistOf(Vec3::Zero(), torch.col(2) * (cy / cx));
  for (const bool lead : {true, false}) {
    if (withTilt) {
      const Vec3 d = -a * axisPerTilt(target, choice, lead);
      const double sx = cy < kGimbalLock ? 0.0 : -a(1, 2) / cy;
      const double ry = d.x() / cx;
      const Vec3 turn(-d.y(), ry * cx, ry * sx);
      twists.col(static_cast<int>(lead ? FreeScalar::Lead : FreeScalar::Lateral)) =
          twistOf(Vec3::Zero(), torch * turn);
    }
  }
}

}  // namespace

FreeGradient freeGradient(const CellModel& model,
                          const Target& target,
                          const FreeChoice& choice,
                          const Pose& T_part_tcp,
                          const ArmState& state,
                          bool withTilt) {
  Eigen::Matrix<double, 6, kFreeScalars> twists;
  twists.setZero();
  if (model.cell().partCarried()) {
    partCarried(model.cell(), target, choice, T_part_tcp, withTilt, twists);
  } else {
    torchCarried(model.cell(), target, choice, withTilt, twists);
  }
  FreeGradient gradient = state.jacobian.partialPivLu().solve(twists);
  for (int k = 0; k < kFreeScalars; ++k) {
    double steepest = 0.0;
    for (int j = 0; j < model.cell().robotJoints(); ++j) {
      const double slope = std::abs(model.asAngle(j, gradient(j, k)));
      steepest = slope > steepest || std::isnan(slope) ? slope : steepest;
    }
    if (!(steepest < kSteepest)) {
      if (std::isfinite(steepest)) {
        gradient.col(k) *= kSteepest / steepest;
      } else {
        gradient.col(k).setZero();
      }
    }
  }
  return gradient;
}

}  // namespace wcam::motion::detail
