// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/arm.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

/// Deviation from an ideal axis arrangement that rounding in a file may cause: angles in rad,
/// distances in mm. The solutions are exact for the ideal arm, so the pose error has this size.
constexpr double kAngleTolerance = 1e-9;
constexpr double kDistanceTolerance = 1e-7;
/// A length below this (mm) has no usable sign or direction.
constexpr double kNoLength = 1e-6;

[[noreturn]] void fail(const Text& what, double by, const char* unit) {
  throw Error(ErrorCode::ProjectInvalid,
              text("%1 (off by %2 %3)", {what, formatFixed(by, 6), std::string(unit)}), "robot",
              "the closed-form inverse kinematics needs axes 2 and 3 parallel, both at a right "
              "angle to axes 1 and 4, and axes 4, 5, 6 meeting at right angles in one point");
}

void requireAngle(double deviation, const Text& what) {
  if (!(std::abs(deviation) <= kAngleTolerance)) {
    fail(what, radToDeg(std::abs(deviation)), "deg");
  }
}

void requireDistance(double deviation, const Text& what) {
  if (!(std::abs(deviation) <= kDistanceTolerance)) {
    fail(what, std::abs(deviation), "mm");
  }
}

double sineBetween(const Vec3& a, const Vec3& b) {
  return a.cross(b).norm();
}

double distanceToLine(const Vec3& p, const Vec3& onLine, const Vec3& direction) {
  return (p - onLine).cross(direction).norm();
}

/// The point of line a nearest to line b; both unit, not parallel.
Vec3 nearestPoint(const Vec3& pa, const Vec3& a, const Vec3& pb, const Vec3& b) {
  const double c = a.dot(b);
  const Vec3 w = pb - pa;
  return pa + a * ((w.dot(a) - c * w.dot(b)) / (1.0 - c * c));
}

/// The wrist's centre, with its geometry checked.
Vec3 wristCentre(const ChainAxes& axes) {
  const auto& p = axes.points;
  const auto& z = axes.directions;
  requireAngle(z[3].dot(z[4]), "axes 4 and 5 are not perpendicular");
  requireAngle(z[4].dot(z[5]), "axes 5 and 6 are not perpendicular");
  Vec3 centre = nearestPoint(p[3], z[3], p[4], z[4]);
  requireDistance(distanceToLine(centre, p[4], z[4]),
                  "the wrist is not spherical: axes 4 and 5 do not meet");
  requireDistance(distanceToLine(centre, p[5], z[5]),
                  "the wrist is not spherical: axis 6 does not pass through the wrist centre");
  return centre;
}

double signOf(double value) {
  return value < 0.0 ? -1.0 : 1.0;
}

/// Sense of axis 1 that points upwards in the base frame: makes draw their tables with axis 1 up or
/// down, and the elbow stands above or below all the same.
double upwards(const ChainAxes& axes) {
  return signOf(axes.directions[0].z() + kAngleTolerance);
}

/// Base frame of the canonical form: z = axis 1 upwards, y = along axis 2, origin at the height of
/// axis 2. Of the two senses of y the one that puts axis 2 (or, where it meets axis 1, the wrist
/// centre at zero values) before axis 1, so that "front" and "up" mean the same for every brand.
Pose canonicalBase(const ChainAxes& axes, const Vec3& centre) {
  const auto& p = axes.points;
  std::vector<Vec3> z = axes.directions;
  z[0] *= upwards(axes);
  requireAngle(z[0].dot(z[1]), "axes 1 and 2 are not perpendicular");
  requireAngle(sineBetween(z[1], z[2]), "axes 2 and 3 are not parallel");
  requireAngle(z[2].dot(z[3]), "axes 3 and 4 are not perpendicular");
  const Vec3 along = (z[1] - z[0] * z[0].dot(z[1])).normalized();
  const Vec3 ahead = along.cross(z[0]);
  double front = ahead.dot(p[1] - p[0]);
  if (std::abs(front) < kNoLength) {
    front = ahead.dot(centre - p[0]) + kNoLength;
  }
  Pose base = Pose::Identity();
  base.linear().col(2) = z[0];
  base.linear().col(1) = signOf(front) * along;
  base.linear().col(0) = base.linear().col(1).cross(base.linear().col(2));
  base.translation() = p[0] + z[0] * z[0].dot(p[1] - p[0]);
  return base;
}

struct Signs {
  Vector6 sign = Vector6::Ones();
  Vector6 atZero = Vector6::Zero();  ///< canonical angles at zero controller values
};

/// Axes 1 to 3: lengths, and canonical angles at zero values.
void reduceArmPart(const ChainAxes& axes, const Vec3& centre, Arm& arm, Signs& signs) {
  const Pose toCanonical = arm.T_base_canonical.inverse();
  const Vec3 p2 = toCanonical * axes.points[1];
  const Vec3 p3 = toCanonical * axes.points[2];
  const Vec3 wrist = toCanonical * centre;
  const Eigen::Matrix3d rotation = toCanonical.linear();
  const Vec3 z4 = rotation * axes.directions[3];

  arm.a1 = p2.x();
  arm.b = wrist.y();
  const double upperX = p3.x() - p2.x();
  const double upperZ = p3.z() - p2.z();
  arm.a2 = std::hypot(upperX, upperZ);
  if (arm.a2 < kNoLength) {
    fail("axes 2 and 3 coincide", arm.a2, "mm");
  }
  const Vec3 forearm = wrist - p3;
  signs.sign(3) = signOf(z4.dot(forearm) + kNoLength);
  const Vec3 along = z4 * signs.sign(3);
  const double t = std::atan2(along.x(), along.z());
  arm.r4 = forearm.x() * std::sin(t) + forearm.z() * std::cos(t);
  arm.d4 = -(forearm.x() * std::cos(t) - forearm.z() * std::sin(t));
  if (std::hypot(arm.r4, arm.d4) < kNoLength) {
    fail("the wrist centre lies on axis 3", std::hypot(arm.r4, arm.d4), "mm");
  }
  const Vec3 y = arm.T_base_canonical.linear().col(1);
  signs.sign(0) = upwards(axes);
  signs.sign(1) = signOf(y.dot(axes.directions[1]));
  signs.sign(2) = signOf(y.dot(axes.directions[2]));
  signs.atZero(1) = std::atan2(upperX, upperZ);
  signs.atZero(2) = t - signs.atZero(1);
}

/// Axes 4 to 6: directions and canonical angles at zero values, and the flange in the wrist frame.
void reduceWrist(const ChainAxes& axes, const Vec3& centre, Arm& arm, Signs& signs) {
  const Eigen::Matrix3d toForearm = rotationY(signs.atZero(1) + signs.atZero(2)).transpose() *
                                    arm.T_base_canonical.linear().transpose();
  const Vec3 z5 = toForearm * axes.directions[4];
  // Axis 5 is Rz(c4)·y = (−sin c4, cos c4, 0): the sense that keeps |c4| at zero values within 90°.
  signs.sign(4) = signOf(z5.y() + kAngleTolerance);
  signs.atZero(3) = std::atan2(-signs.sign(4) * z5.x(), signs.sign(4) * z5.y());
  const Vec3 z6 = rotationZ(signs.atZero(3)).transpose() * (toForearm * axes.directions[5]);
  // z of axis 6 towards the flange.
  const double ahead = axes.directions[5].dot(axes.T_root_tip.translation() - centre);
  signs.sign(5) = signOf(ahead + kNoLength);
  signs.atZero(4) = std::atan2(signs.sign(5) * z6.x(), signs.sign(5) * z6.z());

  Pose T_base_wrist = Pose::Identity();
  T_base_wrist.linear() =
      toForearm.transpose() * rotationZ(signs.atZero(3)) * rotationY(signs.atZero(4));
  T_base_wrist.translation() = centre;
  arm.T_wrist_flange = T_base_wrist.inverse() * axes.T_root_tip;
}

bool isInteger(double value) {
  return value == std::round(value);
}

/// The reduced form must be the chain: a check on the reduction itself.
void verify(const Arm& arm, const Chain& chain) {
  for (int k = 0; k < 7; ++k) {
    Vector6 q;
    for (int j = 0; j < 6; ++j) {
      q(j) = std::sin(1.7 * (k * 6 + j));
    }
    const Pose difference = forwardArm(arm, q.data()).inverse() * chainPose(chain, q.data());
    const double size = armReach(arm) + std::abs(arm.a1) + arm.T_wrist_flange.translation().norm();
    WCAM_ASSERT((difference.linear() - Eigen::Matrix3d::Identity()).norm() < 100 * kAngleTolerance);
    WCAM_ASSERT(difference.translation().norm() <
                100 * (kDistanceTolerance + kAngleTolerance * size));
  }
}

}  // namespace

Arm reduceArm(const Chain& chain) {
  if (chain.size() != 6) {
    throw Error(ErrorCode::ProjectInvalid,
                text("the robot has %1 joints", {std::to_string(chain.size())}), "robot",
                "the closed-form inverse kinematics needs 6 revolute joints");
  }
  for (const Joint& joint : chain.joints) {
    if (joint.prismatic()) {
      throw Error(ErrorCode::ProjectInvalid,
                  text("joint %1 of the robot is prismatic", {joint.name}), "robot",
                  "the closed-form inverse kinematics of an arm needs 6 revolute joints");
    }
  }
  const Vector6 zero = Vector6::Zero();
  const ChainAxes axes = chainAxes(chain, zero.data());
  const Vec3 centre = wristCentre(axes);
  Arm arm;
  arm.T_base_canonical = canonicalBase(axes, centre);
  Signs signs;
  reduceArmPart(axes, centre, arm, signs);
  reduceWrist(axes, centre, arm, signs);
  const Matrix6 coupling = couplingMatrix(chain);
  arm.gain = signs.sign.asDiagonal() * coupling;
  arm.inverseGain = arm.gain.inverse();
  arm.offset = signs.atZero;
  for (int j = 0; j < 6; ++j) {
    bool whole = true;
    for (int i = 0; i < 6; ++i) {
      whole = whole && isInteger(coupling(i, j));
    }
    arm.periodic[static_cast<std::size_t>(j)] = whole;
  }
  verify(arm, chain);
  return arm;
}

}  // namespace wcam::cell
