// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A build direction along the table's axis says nothing about the turn of the table: inside the
// tolerance of the vertical no mode may turn it over, and a torch that crawls is no program.

#include "wcam/motion/collisions.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace wcam::motion {
namespace {

using test::circles;
using test::shippedCell;
using test::Vec3;

constexpr char kCell[] = "fanuc_arcmate120ic";

/// Circles whose build direction leans by an angle to a side that has nothing to do with the layer
/// before (what the tilt of a mesh's layers does), or with the point before.
toolpath::Toolpath nearlyUpright(double lean, bool everyPoint) {
  toolpath::Toolpath path = circles(6, 40.0, 72, Vec3::Zero());
  std::mt19937_64 random(7);
  for (toolpath::Layer& layer : path.layers) {
    double azimuth = 0.0;
    for (std::size_t i = 0; i < layer.beads[0].points.size(); ++i) {
      if (i == 0 || everyPoint) {
        azimuth = 2.0 * kPi * static_cast<double>(random() >> 11U) * 0x1p-53;
      }
      toolpath::PathPoint& point = layer.beads[0].points[i];
      point.up = Vec3(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                      std::cos(lean));
      point.b = point.up;
      point.axis = point.up;
    }
  }
  return path;
}

class NearVertical : public ::testing::TestWithParam<RedundancyMode> {};

TEST_P(NearVertical, TheTableIsNotTurnedOver) {
  const cell::Cell cell = shippedCell(kCell);
  for (const bool everyPoint : {false, true}) {
    for (const double degrees : {0.01, 0.5}) {
      SCOPED_TRACE(std::to_string(degrees) + (everyPoint ? " deg, every point" : " deg"));
      // Axes that jump from point to point by half a degree are the path's own fault.
      if (everyPoint && degrees > 0.1) {
        continue;
      }
      MotionParams params;
      params.mode = GetParam();
      JobContext context;
      const PlannedMotion planned =
          planMotion(nearlyUpright(degToRad(degrees), everyPoint), cell, params, "op", context);
      const std::vector<Waypoint>& points = planned.motion.waypoints;
      double turned = 0.0;
      for (std::size_t i = 1; i < points.size(); ++i) {
        turned = std::max(turned, std::abs(points[i].joints(7) - points[i - 1].joints(7)));
        EXPECT_LE(points[i].verticalError, degToRad(1.0));
        if (points[i].arc) {
          EXPECT_GT(points[i].tcpSpeed, 0.5 * points[i].speed) << i;
        }
      }
      // No more than a point's share of a circle, wherever it is.
      EXPECT_LT(turned, degToRad(10.0));
      EXPECT_EQ(context.diagnostics().count("motion.too_slow"), 0U);
      EXPECT_EQ(context.diagnostics().count("motion.not_vertical"), 0U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes,
                         NearVertical,
                         ::testing::Values(RedundancyMode::Constant,
                                           RedundancyMode::PointByPoint,
                                           RedundancyMode::Polynomial,
                                           RedundancyMode::Fixed,
                                           RedundancyMode::ConstantToolAxis,
                                           RedundancyMode::Optimized),
                         [](const auto& info) { return std::string(redundancyKey(info.param)); });

/// A straight bead under a build direction that passes the table's axis at a distance.
toolpath::Toolpath passage(double distanceDeg, double speed) {
  toolpath::Toolpath path;
  toolpath::Bead bead;
  for (double x = -40.0; x <= 40.0; x += 1.0) {
    const double lean = degToRad(0.5 * std::hypot(x, 2.0 * distanceDeg));
    const double azimuth = std::atan2(2.0 * distanceDeg, x);
    toolpath::PathPoint point;
    point.p = Vec3(x, 0, 50);
    point.t = Vec3::UnitX();
    point.up = Vec3(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                    std::cos(lean));
    point.axis = point.up;
    point.b = point.up;
    point.speed = speed;
    point.width = 6.0;
    bead.points.push_back(point);
  }
  path.layers.emplace_back();
  path.layers[0].beads.push_back(bead);
  return path;
}

std::optional<Diagnostic> first(const JobContext& context, const std::string& code) {
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == code) {
      return d;
    }
  }
  return std::nullopt;
}

TEST(TooSlow, ATableThatMustTurnOverIsAViolation) {
  const cell::Cell cell = shippedCell(kCell);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  // With the tolerance the table hardly turns.
  JobContext eased;
  planMotion(passage(0.3, 10.0), cell, params, "op", eased);
  EXPECT_FALSE(first(eased, "motion.too_slow"));
  // Without it: half a turn within a millimetre.
  params.verticalTolerance = Angle(0.0);
  JobContext exact;
  planMotion(passage(0.05, 10.0), cell, params, "op", exact);
  const auto finding = first(exact, "motion.too_slow");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::Violation);
  EXPECT_NEAR(finding->place.point, 40, 2);
}

/// A bead at a part of the speed that is wanted: the table's axis cannot do more.
JobContext atRatio(double ratio, double minSpeedRatio) {
  cell::Cell cell = shippedCell(kCell);
  toolpath::Toolpath path = circles(1, 40.0, 72, Vec3::Zero());
  MotionParams params;
  params.mode = RedundancyMode::FixedToolTip;
  params.minSpeedRatio = minSpeedRatio;
  // Once around in 2π·40/10 s.
  cell.positioner.joints[1].maxSpeed = ratio * 10.0 / 40.0;
  JobContext context;
  planMotion(path, cell, params, "op", context);
  return context;
}

TEST(TooSlow, CountsBelowTheParameter) {
  EXPECT_FALSE(first(atRatio(0.55, 0.5), "motion.too_slow"));
  EXPECT_TRUE(first(atRatio(0.45, 0.5), "motion.too_slow"));
  EXPECT_FALSE(first(atRatio(0.45, 0.4), "motion.too_slow"));
  EXPECT_TRUE(first(atRatio(0.55, 0.6), "motion.too_slow"));
}

TEST(TooSlow, EndsAndCornersDoNotCount) {
  // Rest to rest, and a right angle without rounding: a halt, but shorter than the bead is wide.
  const cell::Cell cell = shippedCell(kCell);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.accelerationTime = 0.3;
  params.cornerRadius = Length(0.0);
  JobContext context;
  const PlannedMotion planned = planMotion(
      test::polyline({{-40, 0, 2}, {0, 0, 2}, {0, 40, 2}}, 0.5), cell, params, "op", context);
  double slowest = 1e9;
  for (const Waypoint& point : planned.motion.waypoints) {
    slowest = point.arc ? std::min(slowest, point.tcpSpeed) : slowest;
  }
  EXPECT_LT(slowest, 0.5 * test::kSpeed);
  EXPECT_FALSE(first(context, "motion.too_slow"));
}

TEST(TcpSpeed, IsThatOfTheSpeedLaw) {
  // A corner slows the torch by the accelerations of the joints; their speeds would allow it all.
  const cell::Cell cell = shippedCell(kCell);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.accelerationTime = 0.3;
  params.weightTcpSpeed = 1.0;
  const toolpath::Toolpath path = test::polyline({{-40, 30, 2}, {0, 0, 2}, {40, 30, 2}}, 1.0);
  PlannedMotion planned = planMotion(path, cell, params, "op", JobContext());
  double sum = 0.0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < planned.motion.waypoints.size(); ++i) {
    const Waypoint& point = planned.motion.waypoints[i];
    points += point.point >= 0 ? 1U : 0U;
    if (point.point > 0) {
      sum += std::pow(1.0 - point.tcpSpeed / point.speed, 2);
    }
  }
  const double loss = sum / static_cast<double>(points);
  EXPECT_GT(loss, 1e-3);
  EXPECT_NEAR(planned.statistics.evaluation.value(Objective::TcpSpeed), loss, 1e-9);
  EXPECT_NEAR(evaluateMotion(planned.motion, cell, params).value(Objective::TcpSpeed), loss, 1e-9);
  // What the candidates are compared by is the same, before they have times.
  for (Waypoint& point : planned.motion.waypoints) {
    point.time = 0.0;
    point.tcpSpeed = 0.0;
  }
  const Evaluation untimed = evaluateMotion(planned.motion, cell, params);
  EXPECT_NEAR(untimed.value(Objective::TcpSpeed), loss, 1e-9);
  EXPECT_GE(untimed.cost, loss);
}

TEST(Cable, LimitOfTheCellHoldsInEveryModeThatChoosesTheRotation) {
  cell::Cell cell = shippedCell(kCell);
  ASSERT_TRUE(cell.cable);
  EXPECT_NEAR(radToDeg(cell.cable->limit), 120.0, 1e-9);
  // A rotation that twists the cable beyond a narrow limit; others do not.
  const toolpath::Toolpath path = circles(2, 60.0, 48, Vec3(60, 0, 0));
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  double most = 0.0;
  for (int k = 0; k < 12; ++k) {
    params.torchRotation = Angle(degToRad(30.0 * k));
    const double twist =
        planMotion(path, cell, params, "op", JobContext()).statistics.maxCableTwist;
    if (twist > most) {
      most = twist;
    }
  }
  ASSERT_GT(most, degToRad(60.0));
  cell.cable->limit = degToRad(40.0);
  for (int k = 0; k < 12; k += 3) {
    params.torchRotation = Angle(degToRad(30.0 * k));
    for (const RedundancyMode mode :
         {RedundancyMode::PointByPoint, RedundancyMode::Polynomial, RedundancyMode::Optimized}) {
      params.mode = mode;
      JobContext context;
      const PlannedMotion planned = planMotion(path, cell, params, "op", context);
      EXPECT_LE(planned.statistics.maxCableTwist, cell.cable->limit + 1e-6)
          << redundancyKey(mode) << " from " << 30 * k;
      // On beads; travel moves follow the bead beside them.
      for (const Diagnostic& finding : context.diagnostics().items()) {
        EXPECT_FALSE(finding.code == "motion.cable_twist" && finding.place.point >= 0);
      }
    }
  }
}

TEST(Table, ASubstrateBesideItIsAViolation) {
  const cell::Cell cell = shippedCell(kCell);
  for (const auto& [x, beside] :
       {std::pair(0.0, false), std::pair(150.0, false), std::pair(1000.0, true)}) {
    geometry::Pose pose = geometry::Pose::Identity();
    pose.translation().x() = x;
    const toolpath::Substrate plate(pose, Vec3(300, 300, 10));
    MotionParams params;
    params.mode = RedundancyMode::Constant;
    JobContext context;
    planCheckedMotion(circles(1, 40.0, 24, Vec3(x, 0, 0)), cell, &plate, params, "op", context);
    const auto finding = first(context, "motion.beside_table");
    EXPECT_EQ(finding.has_value(), beside) << x;
    if (finding) {
      EXPECT_EQ(finding->severity, Severity::Violation);
      EXPECT_GT(finding->data[0].second, 400.0);
    }
  }
}

}  // namespace
}  // namespace wcam::motion
