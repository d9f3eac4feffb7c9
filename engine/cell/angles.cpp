// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"

#include "wcam/base/quantity.hpp"

#include <cmath>

namespace wcam::cell {

namespace {

/// Below this sine the first angle is taken as 0: the error it causes stays at rounding level.
constexpr double kGimbalLock = 1e-13;

double atan2OrZero(double y, double x) {
  return std::hypot(x, y) < kGimbalLock ? 0.0 : std::atan2(y, x);
}

}  // namespace

Rotation rotationX(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Rotation r;
  r << 1, 0, 0, 0, c, -s, 0, s, c;
  return r;
}

Rotation rotationY(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Rotation r;
  r << c, 0, s, 0, 1, 0, -s, 0, c;
  return r;
}

Rotation rotationZ(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Rotation r;
  r << c, -s, 0, s, c, 0, 0, 0, 1;
  return r;
}

Rotation fromBryant(const Angles& bryant) {
  return rotationX(bryant.x()) * rotationY(bryant.y()) * rotationZ(bryant.z());
}

Angles toBryant(const Rotation& a) {
  const double ry = std::atan2(a(0, 2), std::hypot(a(0, 0), a(0, 1)));
  const double rx = atan2OrZero(-a(1, 2), a(2, 2));
  // Second row of Rx(−rx)·A = Ry·Rz is (sin rz, cos rz, 0): defined whatever rx was chosen.
  const double c = std::cos(rx);
  const double s = std::sin(rx);
  const double rz = std::atan2(c * a(1, 0) + s * a(2, 0), c * a(1, 1) + s * a(2, 1));
  return {rx, ry, rz};
}

Rotation fromKukaAbc(const Angles& abc) {
  return rotationZ(abc.x()) * rotationY(abc.y()) * rotationX(abc.z());
}

Angles toKukaAbc(const Rotation& m) {
  const double b = std::atan2(-m(2, 0), std::hypot(m(0, 0), m(1, 0)));
  const double a = atan2OrZero(m(1, 0), m(0, 0));
  // Second row of Rz(−a)·M = Ry·Rx is (0, cos c, −sin c).
  const double cosA = std::cos(a);
  const double sinA = std::sin(a);
  const double c = std::atan2(sinA * m(0, 2) - cosA * m(1, 2), cosA * m(1, 1) - sinA * m(0, 1));
  return {a, b, c};
}

Rotation fromFanucWpr(const Angles& wpr) {
  return fromKukaAbc(wpr.reverse());
}

Angles toFanucWpr(const Rotation& rotation) {
  return toKukaAbc(rotation).reverse();
}

Rotation axisToVertical(const Eigen::Vector3d& axis, double rotationAboutAxis) {
  const double c = std::cos(rotationAboutAxis);
  const double s = std::sin(rotationAboutAxis);
  const double a = axis.x() * c - axis.y() * s;
  const double b = axis.y() * c + axis.x() * s;
  const double rx = std::atan2(b, std::hypot(a, axis.z()));
  const double ry = atan2OrZero(-a, axis.z());
  return fromBryant({rx, ry, rotationAboutAxis});
}

Rotation frameWithZ(const Eigen::Vector3d& axis, double rotationAboutAxis) {
  const double rx = atan2OrZero(-axis.y(), axis.z());
  const double ry = std::atan2(axis.x(), std::cos(rx) * axis.z() - std::sin(rx) * axis.y());
  return fromBryant({rx, ry, rotationAboutAxis});
}

double wrapAngle(double angle) {
  // The usual case without a division; the difference is exact, as the remainder is.
  if (std::abs(angle) < 2.0 * kPi) {
    const double near = angle > kPi ? angle - 2.0 * kPi : angle < -kPi ? angle + 2.0 * kPi : angle;
    return near <= -kPi ? kPi : near;
  }
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

}  // namespace wcam::cell
