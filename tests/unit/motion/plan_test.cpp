// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/plan.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "paths.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <stop_token>

namespace wcam::motion {
namespace {

using test::circles;
using test::leaningCircles;
using test::shippedCell;

constexpr double kPoseTolerance = 1e-9;

const toolpath::PathPoint& pointOf(const toolpath::Toolpath& path, const Waypoint& w) {
  return path.layers[static_cast<std::size_t>(w.layer)]
      .beads[static_cast<std::size_t>(w.bead)]
      .points[static_cast<std::size_t>(w.point)];
}

void printFindings(const JobContext& context, const PlannedMotion& planned) {
  std::printf("[   INFO   ] branch %s, dexterity %.3f, joint speed ratio %.3f\n",
              planned.statistics.branch.c_str(), planned.statistics.minDexterity,
              planned.statistics.maxJointSpeedRatio);
  for (const Diagnostic& d : context.diagnostics().items()) {
    std::printf("[   INFO   ] %s\n", toLine(d).c_str());
  }
}

/// FK of every waypoint is the wanted pose, positions and axes are the toolpath's.
void expectFollows(const PlannedMotion& planned,
                   const cell::Cell& cell,
                   const toolpath::Toolpath& path) {
  double worst = 0.0;
  std::size_t onBeads = 0;
  for (const Waypoint& w : planned.motion.waypoints) {
    ASSERT_TRUE(w.reachable);
    ASSERT_EQ(w.joints.size(), cell.jointCount());
    const geometry::Pose fk = cell::T_part_tcp(cell, w.joints);
    worst = std::max(worst, (fk.matrix() - w.T_part_tcp.matrix()).cwiseAbs().maxCoeff());
    if (w.point >= 0) {
      ++onBeads;
      const toolpath::PathPoint& p = pointOf(path, w);
      worst = std::max(worst, (w.T_part_tcp.translation() - p.p).norm());
      worst = std::max(worst, (w.T_part_tcp.linear().col(2) - p.axis).norm());
    }
  }
  EXPECT_LE(worst, kPoseTolerance);
  std::size_t expected = 0;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      expected += bead.points.size();
    }
  }
  EXPECT_EQ(onBeads, expected);
}

void expectInsideLimits(const PlannedMotion& planned, const cell::Cell& cell) {
  for (const Waypoint& w : planned.motion.waypoints) {
    for (int j = 0; j < cell.jointCount(); ++j) {
      ASSERT_EQ(cell::limitExcess(cell.joint(j), w.joints(j)), 0.0) << "joint " << j + 1;
    }
  }
}

/// No joint of a linear move steps by more than the angle.
void expectContinuous(const PlannedMotion& planned, double maxStepDeg) {
  const auto& points = planned.motion.waypoints;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].kind == MoveKind::Linear) {
      const double step = (points[i].joints - points[i - 1].joints).cwiseAbs().maxCoeff();
      ASSERT_LE(radToDeg(step), maxStepDeg) << "waypoint " << i;
    }
  }
}

TEST(PlanMotion, circlesOnThePlateOfTheFanuc) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = circles(4, 60, 90, geometry::Vec3::Zero());
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  expectFollows(planned, cell, path);
  expectInsideLimits(planned, cell);
  expectContinuous(planned, 20);
  printFindings(context, planned);
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
  EXPECT_EQ(context.diagnostics().count(Severity::Warning), 0U);
}

TEST(PlanMotion, circlesOnTheTableOfTheYaskawa) {
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  const toolpath::Toolpath path = circles(4, 60, 90, geometry::Vec3::Zero());
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  expectFollows(planned, cell, path);
  expectInsideLimits(planned, cell);
  EXPECT_EQ(planned.statistics.branch, "NUT");
  printFindings(context, planned);
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
}

TEST(PlanMotion, circlesUnderTheFixedTorch) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  const toolpath::Toolpath path = circles(4, 40, 90, geometry::Vec3::Zero());
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  expectFollows(planned, cell, path);
  expectInsideLimits(planned, cell);
  printFindings(context, planned);
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
}

TEST(PlanMotion, leaningLayersAreTurnedUpright) {
  for (const char* name : {"fanuc_arcmate120ic", "yaskawa_ma1440_mt250"}) {
    const cell::Cell cell = shippedCell(name);
    const toolpath::Toolpath path = leaningCircles(15, 15, 60, 5.0);
    JobContext context;
    const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
    expectFollows(planned, cell, path);
    expectInsideLimits(planned, cell);
    printFindings(context, planned);
    for (const Waypoint& w : planned.motion.waypoints) {
      if (w.point >= 0) {
        const Eigen::Vector3d up = cell.T_world_base.linear() *
                                   cell::T_base_part(cell, w.joints).linear() * pointOf(path, w).up;
        ASSERT_LE((up - Eigen::Vector3d::UnitZ()).norm(), 1e-9) << name;
      }
    }
    EXPECT_LE(planned.statistics.maxVerticalError, 1e-9);
  }
}

TEST(PlanMotion, oneBranchForTheWholeOperation) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = leaningCircles(8, 20, 40, 6.0);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  for (const Waypoint& w : planned.motion.waypoints) {
    ASSERT_EQ(cell::branchOf(*cell.arm, w.joints.data()).name(), planned.statistics.branch);
  }
}

TEST(PlanMotion, aFixedBranchIsKept) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = circles(1, 30, 20, geometry::Vec3::Zero());
  MotionParams params;
  params.branch = BranchChoice::Fut;
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  EXPECT_EQ(planned.statistics.branch, "FUT");
  for (const Waypoint& w : planned.motion.waypoints) {
    if (w.reachable) {
      EXPECT_EQ(cell::branchOf(*cell.arm, w.joints.data()).name(), "FUT");
    }
  }
}

TEST(PlanMotion, rotationAboutTheTorchTurnsTheToolOnly) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = circles(1, 30, 20, geometry::Vec3::Zero());
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  JobContext context;
  const PlannedMotion a = planMotion(path, cell, params, "op", context);
  params.torchRotation = Angle(degToRad(25));
  const PlannedMotion b = planMotion(path, cell, params, "op", context);
  for (std::size_t i = 0; i < a.motion.waypoints.size(); ++i) {
    const geometry::Pose d =
        a.motion.waypoints[i].T_part_tcp.inverse() * b.motion.waypoints[i].T_part_tcp;
    EXPECT_LE(d.translation().norm(), 1e-9);
    EXPECT_NEAR(std::atan2(d.linear()(1, 0), d.linear()(0, 0)), degToRad(25), 1e-9);
  }
}

TEST(PlanMotion, endlessTableKeepsTurning) {
  // Beads whose build direction goes round the vertical: the table follows over several turns.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  toolpath::Toolpath path;
  toolpath::Layer layer;
  toolpath::Bead bead;
  constexpr int kPoints = 900;
  for (int i = 0; i < kPoints; ++i) {
    const double a = 3 * 2 * kPi * i / kPoints;
    toolpath::PathPoint point;
    point.p = geometry::Vec3(30 * std::cos(a), 30 * std::sin(a), 0.02 * i);
    point.axis = geometry::Vec3(0.5 * std::cos(a), 0.5 * std::sin(a), std::sqrt(0.75));
    point.up = point.axis;
    point.speed = 8;
    bead.points.push_back(point);
  }
  layer.beads.push_back(bead);
  path.layers.push_back(layer);
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  expectFollows(planned, cell, path);
  expectContinuous(planned, 5);
  const JointStatistics& table = planned.statistics.joints[7];
  EXPECT_NEAR(radToDeg(table.max - table.min), 3 * 360.0, 2.0);
  EXPECT_TRUE(std::isinf(table.margin));
}

TEST(PlanMotion, timeLaw) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = circles(2, 60, 90, geometry::Vec3::Zero());
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  const auto& points = planned.motion.waypoints;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_GE(points[i].time, points[i - 1].time);
    if (points[i].arc) {
      length +=
          (points[i].T_part_tcp.translation() - points[i - 1].T_part_tcp.translation()).norm();
      ASSERT_NEAR(points[i].tcpSpeed, 10.0, 1e-9);
    }
  }
  EXPECT_NEAR(planned.statistics.arcTime, length / 10.0, 1e-9);
  EXPECT_EQ(planned.statistics.totalTime, points.back().time);
  EXPECT_LE(planned.statistics.maxJointSpeedRatio, 1.0 + 1e-12);
  EXPECT_GT(planned.statistics.minDexterity, 0.0);
}

TEST(PlanMotion, independentOfTheNumberOfThreads) {
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  const toolpath::Toolpath path = leaningCircles(12, 20, 200, 4.0);
  std::vector<PlannedMotion> results;
  std::vector<std::string> findings;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    JobContext context;
    results.push_back(planMotion(path, cell, {}, "op", context));
    std::string text;
    for (const Diagnostic& d : context.diagnostics().items()) {
      text += toLine(d) + "\n";
    }
    findings.push_back(text);
  }
  for (std::size_t k = 1; k < results.size(); ++k) {
    EXPECT_EQ(findings[k], findings[0]);
    const auto& a = results[0].motion.waypoints;
    const auto& b = results[k].motion.waypoints;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].joints, b[i].joints);
      ASSERT_EQ(a[i].T_part_tcp.matrix(), b[i].T_part_tcp.matrix());
      ASSERT_EQ(a[i].time, b[i].time);
    }
    EXPECT_EQ(results[k].statistics.minDexterity, results[0].statistics.minDexterity);
  }
}

TEST(PlanMotion, emptyToolpath) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  JobContext context;
  EXPECT_TRUE(planMotion({}, cell, {}, "op", context).motion.waypoints.empty());
  toolpath::Toolpath path;
  path.layers.emplace_back();
  path.layers.back().beads.emplace_back();
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  EXPECT_TRUE(planned.motion.waypoints.empty());
  EXPECT_EQ(planned.statistics.totalTime, 0.0);
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
}

TEST(PlanMotion, cancel) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  std::stop_source stop;
  stop.request_stop();
  const JobContext context(stop.get_token());
  EXPECT_THROW(planMotion(circles(2, 10, 10, geometry::Vec3::Zero()), cell, {}, "op", context),
               CancelledError);
}

TEST(MotionParams, schemaReadsFileUnits) {
  const MotionParams params = MotionParams::schema().read(
      Value::object({{"torch_rotation", 90}, {"branch", "ndb"}, {"travel_speed", "3m/min"}}));
  EXPECT_NEAR(params.torchRotation.value(), kPi / 2, 1e-15);
  EXPECT_EQ(params.branch, BranchChoice::Ndb);
  EXPECT_NEAR(params.travelSpeed.value(), 50, 1e-12);
  for (int k = 0; k < cell::Branch::kCount; ++k) {
    std::string name = cell::Branch::fromIndex(k).name();
    std::string key = MotionParams::schema()
                          .params()
                          .find("branch")
                          ->info.choices[static_cast<std::size_t>(k) + 1]
                          .key;
    for (char& c : name) {
      c = static_cast<char>(c - 'A' + 'a');
    }
    EXPECT_EQ(key, name);
  }
}

}  // namespace
}  // namespace wcam::motion
