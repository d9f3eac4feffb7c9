// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/collision/exit_angle.hpp"

#include "wcam/base/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wcam::collision {
namespace {

/// Diourté A39: the angle brings a point on the nozzle's side into the plane of its end.
TEST(ExitAngle, pointOnTheSideLeavesThroughTheEnd) {
  for (const double radius : {8.0, 12.5}) {
    for (const double d : {0.0, 0.1, 3.0, 12.5, 40.0}) {
      const double angle = exitAngleThroughEnd(radius, d, 0.0);
      EXPECT_NEAR(angle, std::atan(d / radius), 1e-14);
      const double y = std::cos(angle) * radius + std::sin(angle) * d;
      const double z = -std::sin(angle) * radius + std::cos(angle) * d;
      EXPECT_NEAR(z, 0.0, 1e-13);
      EXPECT_NEAR(y, std::hypot(radius, d), 1e-13);
      EXPECT_GE(y, radius - 1e-13);
    }
  }
  EXPECT_EQ(exitAngleThroughEnd(12.5, 0.0, 0.0), 0.0);
}

/// The turned nozzle touches the point, and a little less does not free it; A40: the greatest of
/// the angles frees all points on one side.
TEST(ExitAngle, generalFormTouchesAndTheGreatestFreesAll) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  const auto depthInside = [](double x, double y, double z, double turn, double radius, double s) {
    const double turnedY = std::cos(turn) * y + std::sin(turn) * z;
    const double turnedZ = -std::sin(turn) * y + std::cos(turn) * z;
    return std::min(std::sqrt(std::max(radius * radius - x * x, 0.0)) - std::abs(turnedY),
                    turnedZ - s);
  };
  for (int run = 0; run < 200; ++run) {
    const double radius = uniform(5, 20);
    const double standOff = run % 3 == 0 ? 0.0 : uniform(1, 15);
    double greatest = 0.0;
    double points[20][3];
    for (auto& p : points) {
      p[0] = uniform(-1, 1) * radius;
      p[1] = uniform(0, 1) * std::sqrt(radius * radius - p[0] * p[0]);
      p[2] = standOff + uniform(0, 10);
      const double angle = exitAngle(p[0], p[1], p[2], radius, standOff);
      EXPECT_LE(depthInside(p[0], p[1], p[2], angle, radius, standOff), 1e-9);
      if (angle > 1e-6) {
        EXPECT_GT(depthInside(p[0], p[1], p[2], angle - 1e-6, radius, standOff), 0.0);
      }
      greatest = std::max(greatest, exitAngleThroughEnd(p[1], p[2], standOff));
    }
    for (const auto& p : points) {
      EXPECT_LE(depthInside(p[0], p[1], p[2], greatest, radius, standOff), 1e-9);
    }
  }
}

TEST(ExitAngle, whatIsOutsideNeedsNothing) {
  EXPECT_EQ(exitAngle(0, 13, 20, 12.5, 10), 0.0);
  EXPECT_EQ(exitAngle(13, 0, 20, 12.5, 10), 0.0);
  EXPECT_EQ(exitAngle(0, 3, 9.9, 12.5, 10), 0.0);
  EXPECT_EQ(exitAngle(0, 0, 0, 12.5, 0), 0.0);
}

}  // namespace
}  // namespace wcam::collision
