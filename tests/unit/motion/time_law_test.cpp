// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/motion/reversals.hpp"

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

PlannedMotion plan(const toolpath::Toolpath& path,
                   const cell::Cell& cell,
                   const MotionParams& params,
                   const JobContext& context = JobContext()) {
  return planMotion(path, cell, params, "op", context);
}

TEST(TimeLaw, neverFasterThanWantedWithAccelerations) {
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  MotionParams params;
  params.accelerationTime = 0.3;
  params.tcpAcceleration = 50;
  JobContext context;
  const PlannedMotion planned = plan(polyline(square(50), 1.0), cell, params, context);
  const auto& points = planned.motion.waypoints;
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_GE(points[i].time, points[i - 1].time);
    if (points[i].kind == MoveKind::Linear) {
      ASSERT_LE(points[i].tcpSpeed, points[i].speed * 1.001);
    }
    if (points[i].arc && points[i].point == 100) {
      // The first corner: a/√2·ℓ/|Δt| with a zone of ℓ = 1 mm.
      EXPECT_NEAR(points[i].tcpSpeed, 5.0, 1e-6);
    }
  }
  EXPECT_EQ(context.diagnostics().count("motion.speed_dip"), 1U);
  EXPECT_EQ(context.diagnostics().count("motion.speed_peak"), 0U);
}

TEST(TimeLaw, dipAtACornerIsToldWithItsPlace) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.tcpAcceleration = 20;
  JobContext context;
  const PlannedMotion planned =
      plan(polyline({{-40, 0, 2}, {0, 0, 2}, {0, 40, 2}}, 1.0), cell, params, context);
  ASSERT_EQ(context.diagnostics().count("motion.speed_dip"), 1U);
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == "motion.speed_dip") {
      EXPECT_EQ(d.severity, Severity::Warning);
      EXPECT_EQ(d.place.point, 40);
      EXPECT_EQ(d.data[1].first, "speed_ratio");
      // a/√2·ℓ/|Δt| with ℓ = 1 mm between half-way points and |Δt| = √2.
      EXPECT_NEAR(d.data[1].second, std::sqrt(20.0 * 1.0 / 2) / kSpeed, 1e-6);
    }
  }
  EXPECT_EQ(context.diagnostics().count("motion.speed_limited"), 0U);
}

TEST(TimeLaw, theTorchRestsWhereTheArcGoesOnAndOff) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.accelerationTime = 0.2;
  const PlannedMotion planned = plan(polyline({{-40, 0, 2}, {40, 0, 2}}, 1.0), cell, params);
  const auto& points = planned.motion.waypoints;
  int switches = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].arc != points[i + 1].arc) {
      EXPECT_EQ(points[i].tcpSpeed, 0.0) << i;
      ++switches;
    }
  }
  EXPECT_EQ(switches, 2);
}

TEST(TimeLaw, repeatedPointsAndNoLength) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  for (const double accelerationTime : {0.0, 0.2}) {
    MotionParams params;
    params.accelerationTime = accelerationTime;
    toolpath::Toolpath path = polyline({{-10, 0, 2}, {10, 0, 2}}, 2.0);
    auto& points = path.layers[0].beads[0].points;
    points.insert(points.begin() + 4, 3, points[4]);
    JobContext context;
    const PlannedMotion planned = plan(path, cell, params, context);
    const auto& w = planned.motion.waypoints;
    for (std::size_t i = 1; i < w.size(); ++i) {
      ASSERT_TRUE(std::isfinite(w[i].time) && std::isfinite(w[i].tcpSpeed)) << i;
      ASSERT_GE(w[i].time, w[i - 1].time);
    }
    toolpath::Toolpath dot = polyline({{0, 0, 2}, {0, 0, 2}}, 1.0);
    for (const Waypoint& point : plan(dot, cell, params).motion.waypoints) {
      ASSERT_TRUE(std::isfinite(point.time) && std::isfinite(point.tcpSpeed));
    }
  }
  Motion empty;
  applyTimeLaw(empty, cell, {}, 0.3);
  EXPECT_TRUE(empty.waypoints.empty());
}

TEST(TimeLaw, aJointWithoutSpeedIsNamed) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.robot.joints[2].maxSpeed = 0.0;
  Motion motion;
  motion.waypoints.resize(2);
  for (Waypoint& point : motion.waypoints) {
    point.joints = cell::JointVector::Zero(8);
  }
  try {
    applyTimeLaw(motion, cell, {}, 0.3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    EXPECT_NE(std::string(error.what()).find("joint J3 has no greatest speed"), std::string::npos);
  }
}

TEST(TimeLaw, turningOnTheSpotTakesTheTimeOfTheJoints) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  Motion motion;
  for (int i = 0; i < 3; ++i) {
    Waypoint point;
    point.joints = cell::JointVector::Zero(8);
    point.joints(5) = 0.1 * i;
    point.speed = kSpeed;
    motion.waypoints.push_back(point);
  }
  for (const double accelerationTime : {0.0, 0.2}) {
    TimeLawParams params;
    params.accelerationTime = accelerationTime;
    applyTimeLaw(motion, cell, params, 0.3);
    const double least = 0.2 / cell.joint(5).maxSpeed;
    EXPECT_GE(motion.waypoints[2].time, least * (1 - 1e-9));
    EXPECT_LE(motion.waypoints[2].time, accelerationTime > 0 ? 1.0 : least * (1 + 1e-9));
    EXPECT_EQ(motion.waypoints[1].tcpSpeed, 0.0);
  }
}

TEST(TimeLaw, wireFollowsTheSpeedDownToItsLeast) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.tcpAcceleration = 20;
  params.wireFollowsSpeed = true;
  params.leastWireRatio = 0.6;
  const PlannedMotion planned =
      plan(polyline({{-40, 0, 2}, {0, 0, 2}, {0, 40, 2}}, 1.0), cell, params);
  double least = 1e9;
  for (const Waypoint& w : planned.motion.waypoints) {
    if (w.arc) {
      EXPECT_LE(w.wireSpeed, 80.0);
      least = std::min(least, w.wireSpeed);
      if (w.point == 25) {
        EXPECT_NEAR(w.wireSpeed, 80.0, 1e-6);
      }
    }
  }
  EXPECT_NEAR(least, 48.0, 1e-9);
  params.wireFollowsSpeed = false;
  for (const Waypoint& w :
       plan(polyline({{-40, 0, 2}, {0, 0, 2}, {0, 40, 2}}, 1.0), cell, params).motion.waypoints) {
    EXPECT_EQ(w.wireSpeed, w.arc ? 80.0 : 0.0);
  }
}

TEST(TimeLaw, machinesWithTheirOwnAccelerations) {
  const cell::Cell cell = shippedCell("debout_5axis");
  Motion motion;
  for (int i = 0; i <= 200; ++i) {
    Waypoint point;
    point.joints = cell::JointVector::Zero(5);
    point.joints(0) = 10.0 * i;
    point.joints(3) = 0.3 * std::sin(0.05 * i);
    point.T_part_tcp.translation() = Vec3(10.0 * i, 0, 0);
    point.speed = 1000;
    motion.waypoints.push_back(point);
  }
  applyTimeLaw(motion, cell, {}, 0.3);
  const auto& w = motion.waypoints;
  double turn = 0.0;
  for (std::size_t i = 1; i < w.size(); ++i) {
    const double step = w[i].time - w[i - 1].time;
    ASSERT_GT(step, 0.0);
    for (int j = 0; j < 5; ++j) {
      ASSERT_LE(std::abs(w[i].joints(j) - w[i - 1].joints(j)) / step,
                cell.joint(j).maxSpeed * (1 + 1e-9));
    }
    if (i > 1) {
      const double before = w[i - 1].time - w[i - 2].time;
      const double gain = 2 *
                          ((w[i].joints(3) - w[i - 1].joints(3)) / step -
                           (w[i - 1].joints(3) - w[i - 2].joints(3)) / before) /
                          (step + before);
      turn = std::max(turn, std::abs(gain));
    }
  }
  EXPECT_LE(turn, cell.joint(3).maxAcceleration * 1.01);
  EXPECT_EQ(w.back().tcpSpeed, 0.0);
  // Joint moves: from rest to rest.
  motion.waypoints.resize(2);
  motion.waypoints[1].kind = MoveKind::Joint;
  motion.waypoints[1].joints = motion.waypoints[0].joints;
  motion.waypoints[1].joints(0) += 1000;
  applyTimeLaw(motion, cell, {}, 0.5);
  EXPECT_NEAR(motion.waypoints[1].time, 1000.0 / 500 + 500.0 / 1200 + 1200.0 / 5000, 1e-9);
}

/// AT-41: joints 2 and 3 turn round where a sinusoid does.
TEST(Reversals, atTheExtremesOfASinusoid) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.robot.joints[1].backlash = 1e-4;
  Motion motion;
  constexpr int points = 400;
  cell::JointVector seed = cell::JointVector::Zero(6);
  for (int i = 0; i <= points; ++i) {
    // On a cylinder about axis 1, so that joints 2 and 3 know the height only.
    const double a = -0.4 + 0.8 * i / points;
    const double z = 50 * std::sin(4 * kPi * i / points);
    const Vec3 p(900 * std::cos(a), 900 * std::sin(a), z);
    Waypoint w;
    w.joints = cell::JointVector::Zero(8);
    geometry::Pose flange = geometry::Pose::Identity();
    flange.linear() = (Eigen::AngleAxisd(a, Vec3::UnitZ()) * Eigen::AngleAxisd(kPi, Vec3::UnitX()))
                          .toRotationMatrix();
    flange.translation() = p;
    const cell::InverseSolution s = cell.inverse->solve(flange, 0, seed.data());
    ASSERT_TRUE(s.reachable);
    seed = s.joints;
    w.joints.head(6) = s.joints;
    w.time = 0.1 * i;
    w.arc = i > 0;
    motion.waypoints.push_back(w);
  }
  const std::vector<Reversal> reversals = jointReversals(motion, cell);
  const std::size_t extremes[] = {50, 150, 250, 350};
  for (const int joint : {1, 2}) {
    std::vector<Reversal> own;
    std::copy_if(reversals.begin(), reversals.end(), std::back_inserter(own),
                 [joint](const Reversal& r) { return r.joint == joint; });
    // Joint 3 of the FANUC may have further turning points of its own near none of them.
    for (const std::size_t extreme : extremes) {
      const auto near = std::find_if(own.begin(), own.end(), [extreme](const Reversal& r) {
        return r.waypoint + 1 >= extreme && r.waypoint <= extreme + 1;
      });
      ASSERT_NE(near, own.end()) << joint << " " << extreme;
      EXPECT_NEAR(near->time, 0.1 * static_cast<double>(near->waypoint), 1e-12);
      if (joint == 1) {
        const Vec3 column =
            cell::partJacobian(cell, motion.waypoints[near->waypoint].joints).col(1);
        EXPECT_LE((near->effect + near->direction * 1e-4 * column).norm(), 1e-12);
        EXPECT_GT(near->effect.norm(), 0.01);
      } else {
        EXPECT_EQ(near->effect.norm(), 0.0);
      }
    }
    EXPECT_EQ(own.size(), 4U) << joint;
  }
}

/// AT-41, the coupon (Carrière E6): the height has extremes of +5 mm at 5.1 s and −7.7 mm at 11.6 s
/// of 13 s; the tool moves in the plane of Y and Z, the platter gives the feed. Joints 2 and 3 turn
/// round there, to one sample of 32 ms.
TEST(Reversals, onTheCoupon) {
  const cell::Cell cell = shippedCell("kuka_kr360_platter");
  constexpr double kSample = 0.032;
  const auto height = [](double t) {
    const auto half = [](double from, double to, double s) {
      return from + (to - from) * 0.5 * (1.0 - std::cos(kPi * s));
    };
    return t < 5.1    ? half(0.0, 5.0, t / 5.1)
           : t < 11.6 ? half(5.0, -7.7, (t - 5.1) / 6.5)
                      : half(-7.7, 0.0, (t - 11.6) / 5.0);
  };
  const geometry::Pose table = cell::T_base_table(cell, cell::JointVector::Zero(cell.jointCount()));
  const Vec3 up = cell.verticalInBase();
  const Vec3 across = up.cross(table.translation()).normalized();
  Motion motion;
  cell::JointVector seed = cell::JointVector::Zero(6);
  for (int i = 0; i * kSample <= 13.0; ++i) {
    Waypoint w;
    w.time = i * kSample;
    w.joints = cell::JointVector::Zero(cell.jointCount());
    w.joints(6) = 0.02 * w.time;
    // Over the axis of the platter, across the robot's plane.
    const Vec3 p =
        table.translation() + (-20.0 + 3.0 * w.time) * across + (60.0 + height(w.time)) * up;
    const cell::InverseSolution s = cell::solveTool(cell, p, up, 0.0, 0, seed.data());
    ASSERT_TRUE(s.reachable);
    w.joints.head(6) = seed = s.joints;
    motion.waypoints.push_back(w);
  }
  const std::vector<Reversal> reversals = jointReversals(motion, cell);
  for (const int joint : {1, 2}) {
    std::vector<double> times;
    for (const Reversal& reversal : reversals) {
      // The start from rest is none of the two.
      if (reversal.joint == joint && reversal.time > 1.0) {
        times.push_back(reversal.time);
      }
    }
    ASSERT_EQ(times.size(), 2U) << joint;
    EXPECT_NEAR(times[0], 5.1, kSample) << joint;
    EXPECT_NEAR(times[1], 11.6, kSample) << joint;
  }
}

TEST(Reversals, restAndRoundingAreNone) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  Motion motion;
  const double values[] = {0, 1, 2, 2, 2, 2 - 1e-9, 2, 3, 3, 2, 2, 1};
  for (const double value : values) {
    Waypoint w;
    w.joints = cell::JointVector::Zero(8);
    w.joints(0) = 0.1 * value;
    motion.waypoints.push_back(w);
  }
  const std::vector<Reversal> reversals = jointReversals(motion, cell);
  ASSERT_EQ(reversals.size(), 1U);
  EXPECT_EQ(reversals[0].waypoint, 8U);
  EXPECT_EQ(reversals[0].joint, 0);
  EXPECT_EQ(reversals[0].direction, -1);
  EXPECT_TRUE(jointReversals({}, cell).empty());
}

TEST(Reversals, largeEffectsAreTold) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  for (cell::Joint& joint : cell.robot.joints) {
    joint.backlash = degToRad(0.05);
  }
  MotionParams params;
  JobContext context;
  plan(test::circles(1, 60, 90, Vec3::Zero()), cell, params, context);
  EXPECT_GT(context.diagnostics().count("motion.reversal"), 0U);
  params.reversalEffect = Length(50);
  JobContext quiet;
  plan(test::circles(1, 60, 90, Vec3::Zero()), cell, params, quiet);
  EXPECT_EQ(quiet.diagnostics().count("motion.reversal"), 0U);
}

}  // namespace
}  // namespace wcam::motion
