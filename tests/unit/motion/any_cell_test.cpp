// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Every kind of cell plans, is explained and placed behind the same interface: arms, Cartesian
// machines with 5 and 7 axes, robots without a closed form.

#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"
#include "wcam/motion/explain.hpp"
#include "wcam/motion/placement.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::motion {
namespace {

using cell::Cell;
using geometry::Vec3;
using test::shippedCell;

/// The FANUC with axis 5 beside the crossing of axes 4 and 6: no spherical wrist.
Cell offsetWrist() {
  Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.robot.joints[4].d = 80.0;
  cell::prepareArm(cell);
  return cell;
}

/// The FANUC without axis 6: no rotation about the torch.
Cell fiveJoints() {
  Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.robot.joints.pop_back();
  cell::prepareArm(cell);
  return cell;
}

/// The Cartesian machine with 7 axes, its head holding the part over a torch that stands where the
/// middle of the strokes puts the part's origin.
Cell carryingCartesian() {
  Cell cell = shippedCell("debout_7axis");
  cell.configuration = cell::Configuration::PartCarried;
  cell.positioner = {};
  cell.T_flange_table = cell.T_flange_tcp;
  cell.T_table_part = geometry::Pose::Identity();
  cell::JointVector middle(cell.robotJoints());
  for (int j = 0; j < cell.robotJoints(); ++j) {
    middle(j) = 0.5 * (cell.joint(j).min + cell.joint(j).max);
  }
  cell.T_base_tcp = cell::T_base_part(cell, middle);
  cell::prepareArm(cell);
  return cell;
}

Cell cellOf(const std::string& name) {
  if (name == "carrying_cartesian") {
    return carryingCartesian();
  }
  if (name == "offset_wrist") {
    return offsetWrist();
  }
  if (name == "five_joints") {
    return fiveJoints();
  }
  return shippedCell(name);
}

toolpath::Toolpath upright() {
  return test::circles(2, 40, 24, Vec3::Zero());
}

/// Layers that lean, a little above the plate.
toolpath::Toolpath leaning() {
  toolpath::Toolpath path = test::leaningCircles(2, 40, 24, 6.0);
  for (toolpath::Layer& layer : path.layers) {
    for (toolpath::PathPoint& point : layer.beads[0].points) {
      point.p += Vec3(0, 0, 20);
    }
  }
  return path;
}

/// Forward kinematics of every state give the planned tool, the tool stands on the path's points
/// with its axis, and nothing leaves its limits.
void expectOnThePath(const PlannedMotion& planned,
                     const toolpath::Toolpath& path,
                     const Cell& cell) {
  std::size_t points = 0;
  for (const Waypoint& w : planned.motion.waypoints) {
    ASSERT_TRUE(w.reachable);
    ASSERT_EQ(w.joints.size(), cell.jointCount());
    const geometry::Pose tool = cell::T_part_tcp(cell, w.joints);
    ASSERT_LE((tool.translation() - w.T_part_tcp.translation()).norm(), 1e-6);
    ASSERT_LE((tool.linear() - w.T_part_tcp.linear()).norm(), 1e-9);
    for (int j = 0; j < cell.jointCount(); ++j) {
      ASSERT_EQ(cell::limitExcess(cell.joint(j), w.joints(j)), 0.0) << cell.joint(j).name;
    }
    for (const cell::JointSum& sum : cell.sums) {
      ASSERT_GE(sum.value(w.joints), sum.min - 1e-9);
      ASSERT_LE(sum.value(w.joints), sum.max + 1e-9);
    }
    if (w.point >= 0) {
      const toolpath::PathPoint& point = path.layers[static_cast<std::size_t>(w.layer)]
                                             .beads[static_cast<std::size_t>(w.bead)]
                                             .points[static_cast<std::size_t>(w.point)];
      ASSERT_LE((tool.translation() - point.p).norm(), 1e-6);
      ASSERT_LE(tool.linear().col(2).cross(point.axis).norm(), 1e-9);
      ASSERT_GT(tool.linear().col(2).dot(point.axis), 0.0);
      ++points;
    }
  }
  EXPECT_EQ(points, path.pointCount());
}

class AnyCell : public ::testing::TestWithParam<const char*> {};

TEST_P(AnyCell, PlansInEveryMode) {
  const Cell cell = cellOf(GetParam());
  for (const bool leans : {false, true}) {
    const toolpath::Toolpath path = leans ? leaning() : upright();
    Evaluation optimized;
    for (int m = 0; m < kRedundancyModes; ++m) {
      MotionParams params;
      params.mode = static_cast<RedundancyMode>(m);
      SCOPED_TRACE(std::string(redundancyKey(params.mode)) + (leans ? ", leaning" : ", upright"));
      JobContext context;
      const bool drivesTable = m >= static_cast<int>(RedundancyMode::ConstantToolAxis);
      if (drivesTable && (cell.partCarried() || cell.positionerJoints() == 0)) {
        EXPECT_THROW(planMotion(path, cell, params, "op", context), Error);
        continue;
      }
      const PlannedMotion planned = planMotion(path, cell, params, "op", context);
      const Evaluation& evaluation = planned.statistics.evaluation;
      if (m == 0) {
        optimized = evaluation;
        EXPECT_TRUE(evaluation.feasible()) << evaluation.allBroken();
        expectOnThePath(planned, path, cell);
      }
      EXPECT_FALSE(evaluation.betterThan(optimized));
      // What is broken is told.
      if (evaluation.violations() > 0) {
        EXPECT_GT(context.diagnostics().count(Severity::Violation), 0U);
      } else if (!evaluation.feasible()) {
        EXPECT_GT(context.diagnostics().count(Severity::Warning), 0U);
      }
    }
  }
}

TEST_P(AnyCell, ExplainsAndPlaces) {
  Cell cell = cellOf(GetParam());
  cell.other = nullptr;
  const geometry::Pose home = cell.T_table_part;
  // Far away: 60 m, beyond the strokes of every machine.
  cell.T_table_part.translation() += Vec3(0, 0, 60000);
  const toolpath::Toolpath path = upright();
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  EXPECT_GT(planned.statistics.evaluation.violations(), 0U);
  const std::vector<Diagnostic> findings = explainFindings(
      context.diagnostics().items(), planned.motion, path, cell, nullptr, params, JobContext());
  const auto violation = std::find_if(findings.begin(), findings.end(), [](const Diagnostic& d) {
    return d.severity == Severity::Violation;
  });
  ASSERT_NE(violation, findings.end());
  EXPECT_NE(violation->remedy.str().find("none of these alone puts it right"), std::string::npos)
      << violation->remedy;

  cell.T_table_part = home;
  PlacementSearch search;
  search.rangeX = search.rangeY = 50.0;
  search.turnStep = kPi;
  search.samples = 8;
  search.refinements = 1;
  const PlacementMap map = searchPlacement(path, cell, nullptr, params, search, JobContext());
  const PartPlace& best = map.places[map.best];
  EXPECT_EQ(best.failing, 0U);
  EXPECT_GE(best.limitMargin, 0.0);
  EXPECT_FALSE(best.branch.empty());
}

INSTANTIATE_TEST_SUITE_P(All,
                         AnyCell,
                         ::testing::Values("fanuc_arcmate120ic",
                                           "fanuc_arcmate120ic_part_carried",
                                           "yaskawa_ma1440_mt250",
                                           "yaskawa_ma1440_part_carried",
                                           "kuka_kr16",
                                           "kuka_kr16_positioner",
                                           "kuka_kr16_part_carried",
                                           "kuka_kr360_platter",
                                           "kuka_kr360_part_carried",
                                           "debout_5axis",
                                           "debout_7axis",
                                           "carrying_cartesian",
                                           "offset_wrist",
                                           "five_joints"));

}  // namespace
}  // namespace wcam::motion
