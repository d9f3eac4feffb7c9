// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/positioner.hpp"

#include "wcam/cell/angles.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

/// Sine below which a direction counts as lying along an axis: the angle about that axis would be
/// rounding noise, and keeping the seed costs no more than this angle.
constexpr double kAlongAxis = 1e-9;

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Eigen::Matrix3d rotationAbout(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// Angle about `axis` (unit) that turns `from` into `to` as seen along the axis; `seedAngle` where
/// one of them lies along it.
double turnAbout(const Vec3& axis, const Vec3& from, const Vec3& to, double seedAngle) {
  const Vec3 a = from - axis * axis.dot(from);
  const Vec3 b = to - axis * axis.dot(to);
  if (a.norm() < kAlongAxis || b.norm() < kAlongAxis) {
    return seedAngle;
  }
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

/// The directions z with k1·z = k1·target and k2·z = k2·p, |z| = 1 (exact up to 2), or the unit
/// direction on the cone about k2 that comes nearest to the cone about k1.
std::array<Vec3, 2> meetingDirections(const Vec3& k1,
                                      const Vec3& k2,
                                      const Vec3& target,
                                      const Vec3& p) {
  const double u = k1.dot(target);
  const double v = k2.dot(p);
  const Vec3 normal = k1.cross(k2);
  const double sine2 = normal.squaredNorm();
  const double c = k1.dot(k2);
  const double alpha = (u - c * v) / sine2;
  const double beta = (v - c * u) / sine2;
  const Vec3 inPlane = alpha * k1 + beta * k2;
  // Squared volume of (k1, k2, z), from the sines: exact also where both solutions come together.
  const double volume2 =
      k1.cross(target).squaredNorm() * k2.cross(p).squaredNorm() - (c - u * v) * (c - u * v);
  if (volume2 >= 0.0) {
    const Vec3 side = normal * (std::sqrt(volume2) / sine2);
    return {inPlane + side, inPlane - side};
  }
  // No meeting: an extreme of the cone about k2, in the plane of both axes.
  const Vec3 across = (k1 - c * k2).normalized();
  const double w = std::sqrt(std::max(1.0 - v * v, 0.0));
  const Vec3 towards = v * k2 + w * across;
  const Vec3 away = v * k2 - w * across;
  const double wanted = std::acos(std::clamp(u, -1.0, 1.0));
  const bool nearer =
      std::abs(angleBetween(towards, k1) - wanted) <= std::abs(angleBetween(away, k1) - wanted);
  const Vec3 best = nearer ? towards : away;
  return {best, best};
}

/// Physical joint angles (from zero values) from controller values and back.
struct AxisAngles {
  double first = 0.0;
  double second = 0.0;
};

double secondCoupling(const Chain& chain) {
  const auto& coupling = chain.joints[1].coupling;
  return coupling.empty() ? 0.0 : coupling[0];
}

AxisAngles toAngles(const Chain& chain, const std::array<double, 2>& q) {
  AxisAngles angles;
  angles.first = chain.size() > 0 ? chain.joints[0].sign * q[0] : 0.0;
  if (chain.size() > 1) {
    angles.second = chain.joints[1].sign * q[1] + secondCoupling(chain) * q[0];
  }
  return angles;
}

std::array<double, 2> toValues(const Chain& chain, const AxisAngles& angles) {
  std::array<double, 2> q{};
  if (chain.size() > 0) {
    q[0] = wrapAngle(angles.first) / chain.joints[0].sign;
    q[0] = wrapAngle(q[0]);
  }
  if (chain.size() > 1) {
    q[1] = wrapAngle((angles.second - secondCoupling(chain) * q[0]) / chain.joints[1].sign);
  }
  return q;
}

double residualOf(const Chain& chain,
                  const Vec3& b,
                  const Vec3& target,
                  const std::array<double, 2>& q) {
  return angleBetween(chainPose(chain, q.data()).linear() * b, target);
}

PositionerResult single(const Chain& chain,
                        const Vec3& b,
                        const Vec3& target,
                        const std::array<double, 2>& q) {
  PositionerResult result;
  result.count = 1;
  result.solutions.fill({q, residualOf(chain, b, target, q)});
  return result;
}

/// First axis for a given angle of the second one.
AxisAngles withSecond(const Vec3& k1,
                      const Vec3& k2,
                      const Vec3& p,
                      const Vec3& target,
                      double second,
                      double seedFirst) {
  return {turnAbout(k1, rotationAbout(k2, second) * p, target, seedFirst), second};
}

}  // namespace

PositionerResult alignAxis(const Chain& positioner,
                           const Vec3& b,
                           const Vec3& target,
                           const std::array<double, 2>& seed) {
  const std::array<double, 2> zero{};
  if (positioner.size() == 0) {
    return single(positioner, b, target, zero);
  }
  const ChainAxes axes = chainAxes(positioner, zero.data());
  const Vec3 p = axes.T_root_tip.linear() * b;  // in the base at zero values
  const Vec3& k1 = axes.directions[0];
  const AxisAngles seeded = toAngles(positioner, seed);
  if (positioner.size() == 1) {
    const double angle = turnAbout(k1, p, target, seeded.first);
    return single(positioner, b, target, toValues(positioner, {angle, 0.0}));
  }
  const Vec3& k2 = axes.directions[1];
  const bool alongSecond = p.cross(k2).norm() < kAlongAxis;
  if (alongSecond || k1.cross(k2).norm() < kAlongAxis) {
    const AxisAngles angles = withSecond(k1, k2, p, target, seeded.second, seeded.first);
    auto values = toValues(positioner, angles);
    if (secondCoupling(positioner) == 0.0) {
      values[1] = seed[1];
    }
    return single(positioner, b, target, values);
  }
  PositionerResult result;
  result.count = 2;
  const auto directions = meetingDirections(k1, k2, target, p);
  for (std::size_t i = 0; i < 2; ++i) {
    const double second = turnAbout(k2, p, directions[i], seeded.second);
    const AxisAngles angles = withSecond(k1, k2, p, target, second, seeded.first);
    const auto values = toValues(positioner, angles);
    result.solutions[i] = {values, residualOf(positioner, b, target, values)};
  }
  return result;
}

PositionerResult alignToVertical(const Cell& cell,
                                 const Vec3& upInPart,
                                 const std::array<double, 2>& seed) {
  return alignAxis(cell.positioner, cell.T_table_part.linear() * upInPart, cell.verticalInBase(),
                   seed);
}

}  // namespace wcam::cell
