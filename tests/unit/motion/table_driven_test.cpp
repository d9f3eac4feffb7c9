// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The diagnosis of the article on the TCP velocity (AT-60, AT-61): a table that leads against the
// length of the path as the master.

#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/motion/trace.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::kSpeed;
using test::polyline;
using test::shippedCell;
using test::square;

/// The Yaskawa whose table turns at constant speed below a bead (article, C:393-398 and M46): the
/// torch stays in the plane of the table's axis.
class TableDriven {
public:
  TableDriven() : cell_(shippedCell("yaskawa_ma1440_mt250")) {
    cell_.T_table_part.linear().setIdentity();
    cell_.T_table_part.translation() = Vec3(0, 0, 45.953);
  }

  [[nodiscard]] const cell::Cell& cell() const { return cell_; }

  /// With the table where the point at the polar angle phi of the part meets the plane.
  cell::JointVector at(const Vec3& p, double phi) {
    cell::JointVector q = cell::JointVector::Zero(8);
    q(7) = -phi;
    const geometry::Pose T_base_part = cell::T_base_part(cell_, q);
    const cell::InverseSolution s =
        cell::solveTool(cell_, T_base_part * p, Vec3::UnitZ(), 0.0, 0, seed_.data());
    EXPECT_TRUE(s.reachable);
    q.head(6) = s.joints;
    seed_ = s.joints;
    return q;
  }

  /// Motor speeds while the table turns by `turning` rad/s and the torch follows `point(phi)`.
  template <class Point>
  MotorTrace record(const std::vector<double>& angles, double turning, const Point& point) {
    constexpr double h = 1e-4;
    MotorTrace motors;
    for (const double phi : angles) {
      const cell::JointVector low = at(point(phi - h), phi - h);
      const cell::JointVector high = at(point(phi + h), phi + h);
      cell::JointVector rpm = (high - low) / (2 * h) * turning;
      for (int j = 0; j < 8; ++j) {
        rpm(j) *= cell_.joint(j).ratio * 60 / (2 * kPi);
      }
      motors.time.push_back((phi - angles.front()) / turning);
      motors.rpm.push_back(rpm);
    }
    return motors;
  }

private:
  cell::Cell cell_;
  cell::JointVector seed_ = cell::JointVector::Zero(6);
};

/// AT-60: twice as fast at the corners of a square bead as in the middle of its sides when the
/// table leads, even when the length of the path does.
TEST(TableDriven, squareBead) {
  constexpr double half = 50;
  constexpr double turning = 0.2;  // rad/s: 10 mm/s in the middle of a side
  constexpr int samples = 400;
  TableDriven scheme;
  std::vector<double> angles;
  for (int i = 0; i <= samples; ++i) {
    angles.push_back(-kPi / 4 + kPi / 2 * i / samples);
  }
  const auto side = [half](double phi) { return Vec3(half, half * std::tan(phi), 2); };
  const MotorTrace motors = scheme.record(angles, turning, side);
  const TcpTrace trace =
      reconstructTcp(motors, scheme.cell(), scheme.at(side(angles.front()), angles.front()));
  EXPECT_NEAR(trace.speed[samples / 2], kSpeed, 1e-3);
  EXPECT_NEAR(trace.speed.front() / trace.speed[samples / 2], 2.0, 1e-3);
  EXPECT_NEAR(trace.speed.back() / trace.speed[samples / 2], 2.0, 1e-3);
  EXPECT_LE((trace.position.back() - Vec3(half, half, 2)).norm(), 0.02);
  // The recording shows it: peaks at both ends, nothing else.
  const TraceSummary summary = summarise(trace, kSpeed, 0.05);
  ASSERT_EQ(summary.events.size(), 2U);
  EXPECT_TRUE(summary.events[0].peak && summary.events[0].atStart);
  EXPECT_TRUE(summary.events[1].peak && summary.events[1].atEnd);
  EXPECT_NEAR(summary.maxSpeed / summary.minSpeed, 2.0, 1e-3);
  // The same bead with its length as the master.
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  const PlannedMotion planned =
      planMotion(polyline(square(half), 1.0), scheme.cell(), params, "op", JobContext());
  for (const Waypoint& w : planned.motion.waypoints) {
    if (w.arc) {
      ASSERT_NEAR(w.tcpSpeed / kSpeed, 1.0, 1e-3);
    }
  }
}

/// Corners of a star: the section of a tulip, whose direction changes abruptly at every corner.
constexpr int kPetals = 5;
constexpr double kOuter = 60.0;
constexpr double kInner = 30.0;
constexpr double kHalfPetal = kPi / kPetals;

Vec3 starCorner(int k) {
  const double radius = k % 2 == 0 ? kInner : kOuter;
  return {radius * std::cos(k * kHalfPetal), radius * std::sin(k * kHalfPetal), 2};
}

/// The point of the star at a polar angle.
Vec3 starPoint(double phi) {
  const int k = static_cast<int>(std::floor(phi / kHalfPetal));
  const Vec3 a = starCorner(k);
  const Vec3 d = starCorner(k + 1) - a;
  const Vec3 ray(std::cos(phi), std::sin(phi), 0);
  const double s = (a.y() * ray.x() - a.x() * ray.y()) / (d.x() * ray.y() - d.y() * ray.x());
  return a + s * d;
}

/// AT-61: with the table as the leader the speed dips at every inner corner of the tulip and peaks
/// at every outer one, as the square of the radius; with the length as the master it is never too
/// high and dips where the joints need it.
TEST(TableDriven, tulip) {
  constexpr int perSide = 40;
  TableDriven scheme;
  std::vector<double> angles;
  for (int i = 0; i < 2 * kPetals * perSide; ++i) {
    // Between the corners.
    angles.push_back((i + 0.5) * kHalfPetal / perSide);
  }
  // The distance of all sides from the axis.
  const Vec3 d = (starCorner(1) - starCorner(0)).normalized();
  const double distance = (starCorner(0) - d * d.dot(starCorner(0))).head<2>().norm();
  const auto expected = [&](double phi, double turning) {
    return turning * starPoint(phi).head<2>().squaredNorm() / distance;
  };
  // Just the wanted speed in the middle between the least and the greatest.
  const double turning = kSpeed * distance / (kInner * kOuter);
  const MotorTrace motors = scheme.record(angles, turning, starPoint);
  const TcpTrace trace =
      reconstructTcp(motors, scheme.cell(), scheme.at(starPoint(angles.front()), angles.front()));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    ASSERT_NEAR(trace.speed[i], expected(angles[i], turning), 0.02) << i;
  }
  const TraceSummary summary = summarise(trace, kSpeed, 0.2);
  ASSERT_EQ(summary.events.size(), 2U * kPetals + 1U);
  for (std::size_t k = 0; k < summary.events.size(); ++k) {
    EXPECT_EQ(summary.events[k].peak, k % 2 == 1);
  }
  EXPECT_GT(summary.maxSpeed, 1.9 * kSpeed);
  EXPECT_LT(summary.minSpeed, 0.6 * kSpeed);

  std::vector<Vec3> corners;
  for (int k = 0; k <= 2 * kPetals; ++k) {
    corners.push_back(starCorner(k));
  }
  for (const RedundancyMode mode : {RedundancyMode::PlanarVertical, RedundancyMode::Constant}) {
    MotionParams params;
    params.mode = mode;
    params.accelerationTime = 0.3;
    params.cornerRadius = Length(0.2);
    const PlannedMotion planned =
        planMotion(polyline(corners, 1.0), scheme.cell(), params, "op", JobContext());
    double most = 0.0;
    double least = kSpeed;
    for (const Waypoint& w : planned.motion.waypoints) {
      if (w.arc) {
        most = std::max(most, w.tcpSpeed);
      }
      if (w.arc && w.point > 10 && w.point < 300) {
        least = std::min(least, w.tcpSpeed);
      }
    }
    EXPECT_LE(most, 1.001 * kSpeed);
    EXPECT_GT(most, 0.99 * kSpeed);
    EXPECT_GT(least, 0.0);
  }
}

/// AT-61: an abrupt change of direction in a bead. The axis that leads goes through the corner;
/// with the length as master the torch slows down there and is never too fast.
TEST(TableDriven, abruptChangeOfDirectionDipsAndNeverPeaks) {
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  MotionParams params;
  params.accelerationTime = 5.0;
  params.cornerRadius = Length(0.05);
  JobContext context;
  const PlannedMotion planned = planMotion(polyline({{-40, 30, 2}, {0, 0, 2}, {40, 30, 2}}, 1.0),
                                           cell, params, "op", context);
  double most = 0.0;
  double least = 1e9;
  for (const Waypoint& w : planned.motion.waypoints) {
    if (w.arc) {
      most = std::max(most, w.tcpSpeed);
      if (w.point > 10 && w.point < 90) {
        least = std::min(least, w.tcpSpeed);
      }
    }
  }
  EXPECT_LE(most, 1.001 * kSpeed);
  // It dips, and says so at the corner.
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 0.9 * kSpeed);
  ASSERT_EQ(context.diagnostics().count("motion.speed_dip"), 1U);
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == "motion.speed_dip") {
      EXPECT_NEAR(finding.place.point, 50, 1);
      EXPECT_NEAR(finding.data[0].second, least, 1e-9);
    }
  }
}

}  // namespace
}  // namespace wcam::motion
