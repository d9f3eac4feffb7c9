// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/speed_law.hpp"

#include "plain_speed_law.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wcam::motion {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

/// One joint along a line; s is its value.
SpeedPath line(double length, std::size_t segments, double speed) {
  SpeedPath path;
  path.joints = 1;
  for (std::size_t i = 0; i <= segments; ++i) {
    path.q.push_back(length * static_cast<double>(i) / static_cast<double>(segments));
    path.length.push_back(i == 0 ? 0.0 : length / static_cast<double>(segments));
    path.speed.push_back(speed);
  }
  return path;
}

/// Random waypoints or a smooth random curve, `joints` wide.
SpeedPath randomPath(std::mt19937_64& random, int joints, std::size_t points, bool smooth) {
  SpeedPath path;
  path.joints = joints;
  std::vector<double> amplitude;
  std::vector<double> phase;
  for (int j = 0; j < 3 * joints; ++j) {
    amplitude.push_back(uniform(random, -1, 1));
    phase.push_back(uniform(random, 0, 6));
  }
  for (std::size_t i = 0; i < points; ++i) {
    const double s = 0.02 * static_cast<double>(i);
    for (int j = 0; j < joints; ++j) {
      double q = uniform(random, -1, 1);
      if (smooth) {
        q = 0.0;
        for (int k = 0; k < 3; ++k) {
          const auto m = static_cast<std::size_t>(3 * j + k);
          q += amplitude[m] * std::sin(s * (k + 1) + phase[m]);
        }
      }
      path.q.push_back(q);
    }
    path.length.push_back(i == 0 ? 0.0 : smooth ? 0.02 : uniform(random, 0.5, 3));
    path.speed.push_back(uniform(random, 1, 4));
  }
  return path;
}

SpeedLimits randomLimits(std::mt19937_64& random, int joints, double blend) {
  SpeedLimits limits;
  limits.blend = blend;
  for (int j = 0; j < joints; ++j) {
    limits.joints.push_back({uniform(random, 0.5, 3), uniform(random, 0.5, 5), kInf});
  }
  return limits;
}

/// Debout AT-41: L/V + V/a + a/j with the limits of X, below the times that he measured.
TEST(SpeedLaw, restToRestAlongALine) {
  struct Row {
    double length, expected, measured;
  };

  for (const Row& row : {Row{5620, 6.6933, 6.92}, Row{2994, 4.0673, 5.15}, Row{6189, 7.2623, 7.53},
                         Row{5539, 6.6123, 7.46}}) {
    for (const std::size_t segments : {1U, 2U, 50U, 5000U}) {
      const SpeedPath path = line(row.length, segments, kInf);
      SpeedLimits limits;
      limits.joints = {{1000, 1200, 5000}};
      const double closed = row.length / 1000 + 1000.0 / 1200 + 1200.0 / 5000;
      const SpeedLaw law = speedLaw(path, limits);
      EXPECT_NEAR(law.duration, closed, 1e-6) << segments;
      EXPECT_NEAR(law.duration, row.expected, 1e-3);
      EXPECT_LE(law.duration, row.measured);
      EXPECT_NEAR(restToRest(row.length, limits.joints[0]), closed, 1e-9);
      limits.joints[0].jerk = kInf;
      EXPECT_NEAR(speedLaw(path, limits).duration, closed - 0.24, 1e-6);
      EXPECT_NEAR(restToRest(-row.length, limits.joints[0]), closed - 0.24, 1e-9);
    }
  }
}

TEST(SpeedLaw, shortWaysNeverReachTheSpeed) {
  SpeedLimits limits;
  limits.joints = {{1000, 100, kInf}};
  EXPECT_NEAR(speedLaw(line(25, 10, kInf), limits).duration, 2 * std::sqrt(25.0 / 100), 1e-9);
  EXPECT_NEAR(restToRest(25, limits.joints[0]), 1.0, 1e-9);
  EXPECT_EQ(restToRest(0, limits.joints[0]), 0.0);
  // Jerk alone decides: a quarter of the way with +j, half with −j, a quarter with +j.
  limits.joints[0].jerk = 10;
  EXPECT_NEAR(restToRest(1, limits.joints[0]), std::cbrt(32.0 * 1 / 10), 1e-9);
  EXPECT_GE(speedLaw(line(1, 10, kInf), limits).duration, std::cbrt(32.0 * 1 / 10) - 1e-9);
}

TEST(SpeedLaw, aLoneCornerIsAsFastAsItsZoneAllows) {
  for (const double blend : {0.5, 1.0, 3.0}) {
    SpeedPath path;
    path.joints = 2;
    path.q = {0, 0, 100, 0, 100, 100};
    path.length = {0, 100, 100};
    path.speed = {0, 60, 60};
    SpeedLimits limits;
    limits.joints = {{kInf, 300, kInf}, {kInf, 300, kInf}};
    limits.blend = blend;
    const SpeedLaw law = speedLaw(path, limits);
    EXPECT_NEAR(law.speed[1], std::sqrt(2 * 300 * blend), 1e-9);
    limits.blend = 0.0;
    EXPECT_EQ(speedLaw(path, limits).speed[1], 0.0);
    EXPECT_GT(speedLaw(path, limits).duration, law.duration);
    // The limit of the path itself: |t1 − t0|·v²/ℓ = a/√2.
    limits.blend = blend;
    limits.joints = {JointBounds{}, JointBounds{}};
    limits.pathAcceleration = 300;
    limits.tangents = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    EXPECT_NEAR(speedLaw(path, limits).speed[1], std::sqrt(300 * 2 * blend / 2), 1e-9);
  }
}

TEST(SpeedLaw, equalsThePlainLawOnRandomPaths) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const int joints = 1 + static_cast<int>(seed % 12);
    const bool smooth = seed % 2 == 0;
    const SpeedPath path = randomPath(random, joints, smooth ? 2000 : 200, smooth);
    const SpeedLimits limits = randomLimits(random, joints, smooth ? 1.0 : 0.3);
    const SpeedLaw law = speedLaw(path, limits);
    const SpeedLaw plain = test::plainSpeedLaw(path, limits);
    ASSERT_NEAR(law.duration, plain.duration, 1e-7 * plain.duration);
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_NEAR(law.time[i], plain.time[i], 1e-6 * plain.duration) << i;
      ASSERT_GE(law.time[i], i > 0 ? law.time[i - 1] : 0.0);
    }
  }
}

/// Of a circle in two joints every quantity is known in closed form.
TEST(SpeedLaw, circleIsLimitedByItsCurvature) {
  constexpr double radius = 50;
  constexpr std::size_t points = 3600;
  SpeedPath path;
  path.joints = 2;
  for (std::size_t i = 0; i <= points; ++i) {
    const double a = 2 * std::acos(-1.0) * static_cast<double>(i) / points;
    path.q.insert(path.q.end(), {radius * std::cos(a), radius * std::sin(a)});
    path.length.push_back(i == 0 ? 0.0 : 2 * radius * std::sin(std::acos(-1.0) / points));
    path.speed.push_back(1e5);
  }
  SpeedLimits limits;
  limits.joints = {{kInf, 200, kInf}, {kInf, 200, kInf}};
  limits.blend = 100;
  const SpeedLaw law = speedLaw(path, limits);
  // |q̈| of each joint ≤ a: a phase is at least as slow as v² = a·r on the axes.
  for (const std::size_t i : {points / 4, points / 2, 3 * points / 4}) {
    EXPECT_NEAR(law.speed[i], std::sqrt(200 * radius), 0.2);
  }
}

TEST(SpeedLaw, jerkIsNeverExceeded) {
  std::mt19937_64 random(11);
  for (int k = 0; k < 20; ++k) {
    // A line with stretches of several speeds.
    SpeedPath path = line(uniform(random, 50, 400), 4000, 100);
    for (std::size_t i = 0; i < path.size(); ++i) {
      path.speed[i] = i / 700 % 2 == 0 ? 60 : 25;
    }
    const JointBounds bounds{100, uniform(random, 100, 500), uniform(random, 500, 5000)};
    SpeedLimits limits;
    limits.joints = {bounds};
    const SpeedLaw law = speedLaw(path, limits);
    double lastGain = 0.0;
    double lastTime = 0.0;
    double worstGain = 0.0;
    double worstJerk = 0.0;
    for (std::size_t i = 2; i < path.size(); ++i) {
      const double step = law.time[i] - law.time[i - 1];
      ASSERT_GT(step, 0.0);
      ASSERT_LE(law.speed[i], path.speed[i] * (1 + 1e-9)) << i;
      const double gain = (law.speed[i] - law.speed[i - 1]) / step;
      const double middle = 0.5 * (law.time[i] + law.time[i - 1]);
      worstGain = std::max(worstGain, std::abs(gain));
      if (i > 2) {
        worstJerk = std::max(worstJerk, std::abs(gain - lastGain) / (middle - lastTime));
      }
      lastGain = gain;
      lastTime = middle;
    }
    EXPECT_LE(worstGain, bounds.acceleration * (1 + 1e-6));
    EXPECT_LE(worstJerk, bounds.jerk * (1 + 1e-3));
    EXPECT_GE(worstJerk, bounds.jerk * 0.4);  // and it is used
  }
}

TEST(SpeedLaw, jerkOnPathsWithManyJointsTakesLonger) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const int joints = 2 + static_cast<int>(seed % 7);
    const SpeedPath path = randomPath(random, joints, 800, seed % 2 == 0);
    SpeedLimits limits = randomLimits(random, joints, 0.3);
    const SpeedLaw free = speedLaw(path, limits);
    for (JointBounds& bounds : limits.joints) {
      bounds.jerk = 20 * bounds.acceleration;
    }
    const SpeedLaw law = speedLaw(path, limits);
    EXPECT_GT(law.duration, free.duration);
    for (std::size_t i = 1; i < path.size(); ++i) {
      ASSERT_TRUE(std::isfinite(law.time[i]) && std::isfinite(law.speed[i]));
      ASSERT_GE(law.time[i], law.time[i - 1]);
    }
    EXPECT_EQ(law.time, speedLaw(path, limits).time);
  }
}

TEST(SpeedLaw, cornersWithoutRoundingStopAlsoWithJerk) {
  SpeedPath path;
  path.joints = 2;
  path.q = {0, 0, 100, 0, 100, 100};
  path.length = {0, 100, 100};
  path.speed = {0, 60, 60};
  SpeedLimits limits;
  limits.joints = {{kInf, 300, 3000}, {kInf, 300, 3000}};
  limits.blend = 0;
  const SpeedLaw law = speedLaw(path, limits);
  EXPECT_EQ(law.speed[1], 0.0);
  const double leg = restToRest(100, {60, 300, 3000});
  EXPECT_NEAR(law.time[1], leg, 1e-6);
  EXPECT_NEAR(law.duration, 2 * leg, 1e-6);
}

TEST(SpeedLaw, tinyPaths) {
  SpeedLimits limits;
  limits.joints = {{1, 1, 1}};
  EXPECT_EQ(speedLaw(line(1, 0, 1), limits).duration, 0.0);
  SpeedPath none;
  none.joints = 1;
  EXPECT_TRUE(speedLaw(none, limits).time.empty());
  const SpeedLaw tiny = speedLaw(line(1e-9, 3, 1), limits);
  EXPECT_TRUE(std::isfinite(tiny.duration));
  EXPECT_GT(tiny.duration, 0.0);
  // A joint that rests, and one without any limit.
  SpeedPath path = line(10, 5, 2);
  for (double& q : path.q) {
    q = 3.0;
  }
  EXPECT_NEAR(speedLaw(path, limits).duration, 5.0, 1e-9);
  limits.joints = {JointBounds{}};
  EXPECT_NEAR(speedLaw(line(10, 5, 2), limits).duration, 5.0, 1e-9);
}

}  // namespace
}  // namespace wcam::motion
