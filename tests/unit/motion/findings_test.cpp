// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::circles;
using test::shippedCell;

std::optional<Diagnostic> first(const JobContext& context, const std::string& code) {
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == code) {
      return d;
    }
  }
  return std::nullopt;
}

double dataOf(const Diagnostic& diagnostic, const std::string& name) {
  for (const auto& [key, value] : diagnostic.data) {
    if (key == name) {
      return value;
    }
  }
  ADD_FAILURE() << diagnostic.code << " has no " << name;
  return 0.0;
}

/// A bead with given points, axis up.
toolpath::Toolpath beadOf(const std::vector<Vec3>& points, double speed) {
  toolpath::Toolpath path;
  toolpath::Bead bead;
  for (const Vec3& p : points) {
    toolpath::PathPoint point;
    point.p = p;
    point.speed = speed;
    bead.points.push_back(point);
  }
  path.layers.emplace_back();
  path.layers[0].beads.push_back(bead);
  return path;
}

TEST(Findings, unreachablePathTellsTheMissingDistanceOncePerBead) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = circles(3, 50, 30, Vec3(5000, 0, 0));
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "far", context);
  EXPECT_EQ(context.diagnostics().count("motion.unreachable"), 3U);
  const auto d = first(context, "motion.unreachable");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->severity, Severity::Violation);
  EXPECT_EQ(d->place.operation, "far");
  EXPECT_EQ(d->place.layer, 0);
  EXPECT_GT(dataOf(*d, "missing_mm"), 2000);
  EXPECT_EQ(dataOf(*d, "points"), 31 + 4);
  EXPECT_EQ(planned.statistics.unreachableWaypoints, planned.motion.waypoints.size());
  for (const Waypoint& w : planned.motion.waypoints) {
    EXPECT_FALSE(w.reachable);
    EXPECT_TRUE(w.joints.allFinite());
  }
  EXPECT_EQ(context.diagnostics().count("motion.joint_limit"), 0U);
}

TEST(Findings, partlyUnreachablePath) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  std::vector<Vec3> points;
  for (int i = 0; i <= 200; ++i) {
    points.emplace_back(5.0 * i, 0, 0);
  }
  JobContext context;
  MotionParams params;
  params.mode = RedundancyMode::Constant;  // the table could bring all of it into reach
  const PlannedMotion planned = planMotion(beadOf(points, 10), cell, params, "op", context);
  const auto d = first(context, "motion.unreachable");
  ASSERT_TRUE(d);
  EXPECT_GT(dataOf(*d, "points"), 1);
  EXPECT_LT(dataOf(*d, "points"), 203);
  EXPECT_EQ(d->place.point, 200);
  EXPECT_EQ(static_cast<double>(planned.statistics.unreachableWaypoints), dataOf(*d, "points"));
}

TEST(Findings, jointLimitNamesJointAndExcess) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.robot.joints[0].max = degToRad(10);  // the table stands at about 41°
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.branch = BranchChoice::Nut;
  JobContext context;
  const PlannedMotion planned =
      planMotion(circles(2, 40, 30, Vec3::Zero()), cell, params, "op", context);
  EXPECT_EQ(context.diagnostics().count("motion.joint_limit"), 2U);
  const auto d = first(context, "motion.joint_limit");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->severity, Severity::Violation);
  EXPECT_EQ(dataOf(*d, "joint"), 1);
  EXPECT_NEAR(dataOf(*d, "excess_deg"), dataOf(*d, "value_deg") - 10, 1e-9);
  EXPECT_LT(planned.statistics.joints[0].margin, 0);
}

TEST(Findings, wristSingularityAlongThePath) {
  // A straight torch on a fixed table: a tool axis along the forearm is singular.
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.T_flange_tcp = geometry::Pose::Identity();
  cell.T_flange_tcp.translation() = Vec3(0, 0, 300);
  cell.positioner.joints.clear();
  cell.positioner.T_root_first = geometry::Pose::Identity();
  cell.positioner.T_root_first.translation() = Vec3(1200, 0, 0);
  cell.T_table_part = geometry::Pose::Identity();
  const cell::JointVector straight =
      (cell::JointVector(6) << 0.0, 0.3, 0.2, 0.0, 0.0, 0.0).finished();
  const geometry::Pose tcp = cell::T_part_tcp(cell, straight);
  toolpath::Toolpath path;
  path.layers.emplace_back();
  toolpath::Bead bead;
  for (int i = -20; i <= 20; ++i) {
    toolpath::PathPoint point;
    point.p = tcp.translation() + Vec3(0, 1.0 * i, 0);
    point.axis = tcp.linear().col(2);
    point.up = Vec3::UnitZ();
    point.speed = 10;
    bead.points.push_back(point);
  }
  path.layers[0].beads.push_back(bead);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.branch = BranchChoice::Nut;
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  const auto d = first(context, "motion.singularity");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->severity, Severity::Warning);
  EXPECT_LT(dataOf(*d, "wrist_bend_deg"), 1e-3);
  EXPECT_EQ(d->place.point, 20);
  // Axis 4 turns over at the crossing: told as a step, and the torch waits for it.
  EXPECT_TRUE(first(context, "motion.joint_step"));
  EXPECT_TRUE(first(context, "motion.speed_limited"));
  for (const Waypoint& w : planned.motion.waypoints) {
    ASSERT_TRUE(w.reachable);
    EXPECT_LE((cell::T_part_tcp(cell, w.joints).matrix() - w.T_part_tcp.matrix()).norm(), 1e-9);
  }
}

TEST(Findings, jointSpeedLimitsTheTorch) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  JobContext context;
  // 20 m/s is beyond what any joint allows.
  const PlannedMotion planned =
      planMotion(beadOf({{-100, 0, 5}, {0, 0, 5}, {100, 0, 5}}, 20000), cell, {}, "op", context);
  const auto d = first(context, "motion.speed_limited");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->severity, Severity::Warning);
  EXPECT_LT(dataOf(*d, "speed_ratio"), 1.0);
  EXPECT_NEAR(dataOf(*d, "speed_mm_s") / 20000, dataOf(*d, "speed_ratio"), 1e-12);
  EXPECT_EQ(dataOf(*d, "points"), 2);
  EXPECT_NEAR(planned.statistics.maxJointSpeedRatio, 1.0, 1e-9);
}

TEST(Findings, directionThatThePositionerCannotTurnUp) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.positioner.joints.clear();
  toolpath::Toolpath path = circles(1, 30, 20, Vec3::Zero());
  for (auto& point : path.layers[0].beads[0].points) {
    point.up = Vec3(std::sin(0.2), 0, std::cos(0.2));
    point.axis = point.up;
  }
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  const auto d = first(context, "motion.not_vertical");
  ASSERT_TRUE(d);
  EXPECT_NEAR(degToRad(dataOf(*d, "angle_deg")), planned.statistics.maxVerticalError, 1e-12);
  EXPECT_NEAR(planned.statistics.maxVerticalError, 0.2, 0.01);
}

TEST(Findings, lowDexterity) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.minDexterity = 0.9;
  JobContext context;
  const PlannedMotion planned =
      planMotion(circles(1, 30, 20, Vec3::Zero()), cell, params, "op", context);
  const auto d = first(context, "motion.low_dexterity");
  ASSERT_TRUE(d);
  EXPECT_GE(dataOf(*d, "dexterity"), planned.statistics.minDexterity - 1e-6);
}

}  // namespace
}  // namespace wcam::motion
