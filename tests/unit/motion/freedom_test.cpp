// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Freedoms that are used where nothing else helps: lead and lateral tilt inside their tolerance,
// and as a cure the other configuration of the cell.

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/explain.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::shippedCell;

/// A line across the robot's front, so far out that an upright torch is beyond its reach for every
/// rotation and configuration.
toolpath::Toolpath farLine(const cell::Cell& cell) {
  const Eigen::Matrix3d toPart =
      (cell.positioner.T_root_first * cell.positioner.T_last_tip * cell.T_table_part)
          .linear()
          .transpose();
  toolpath::Toolpath path =
      test::polyline({toPart * Vec3(500, -15, 2), toPart * Vec3(500, 15, 2)}, 2.0);
  for (toolpath::PathPoint& point : path.layers[0].beads[0].points) {
    point.t = toPart * Vec3::UnitY();
  }
  return path;
}

TEST(Tilt, IsUsedWhereAnUprightTorchCannotCome) {
  const cell::Cell cell = shippedCell("kuka_kr16");
  const toolpath::Toolpath path = farLine(cell);
  const auto plan = [&](double tolerance) {
    MotionParams params;
    params.tiltTolerance = Angle(degToRad(tolerance));
    return planMotion(path, cell, params, "op", JobContext());
  };
  const PlannedMotion upright = plan(0.0);
  EXPECT_EQ(upright.statistics.evaluation.count(Constraint::Reach),
            upright.motion.waypoints.size());
  EXPECT_EQ(upright.statistics.maxTilt, 0.0);
  const PlannedMotion leaning = plan(10.0);
  EXPECT_TRUE(leaning.statistics.evaluation.feasible());
  EXPECT_GT(leaning.statistics.maxTilt, degToRad(2.0));
  EXPECT_LE(leaning.statistics.maxTilt, degToRad(10.0));
  for (const Waypoint& w : leaning.motion.waypoints) {
    ASSERT_TRUE(w.reachable);
    const geometry::Pose tool = cell::T_part_tcp(cell, w.joints);
    ASSERT_LE((tool.matrix() - w.T_part_tcp.matrix()).norm(), 1e-9);
    ASSERT_LE(std::acos(std::min(1.0, tool.linear()(2, 2))), degToRad(10.0) + 1e-9);
  }
  // Not where it is not needed.
  EXPECT_LE(plan(1.0).statistics.maxTilt, degToRad(1.0) + 1e-9);
}

Diagnostic explained(const cell::Cell& cell) {
  const toolpath::Toolpath path = test::circles(1, 20, 16, Vec3::Zero());
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  const std::vector<Diagnostic> findings = explainFindings(
      context.diagnostics().items(), planned.motion, path, cell, nullptr, params, JobContext());
  const auto found = std::find_if(findings.begin(), findings.end(), [](const Diagnostic& d) {
    return d.code == "motion.unreachable";
  });
  EXPECT_NE(found, findings.end());
  return found != findings.end() ? *found : Diagnostic();
}

TEST(OtherConfiguration, isACureWhereNothingElseHelps) {
  cell::Cell torch = shippedCell("fanuc_arcmate120ic");
  ASSERT_NE(torch.other, nullptr);
  EXPECT_TRUE(torch.other->partCarried());
  EXPECT_EQ(torch.other->other, nullptr);
  torch.T_table_part.translation() += Vec3(0, 0, 4000);
  const Diagnostic far = explained(torch);
  EXPECT_NE(
      far.remedy.str().find("let the robot carry the part (cell \"FANUC ARC Mate 120iC carrying"),
      std::string::npos)
      << far.remedy;
  EXPECT_TRUE(std::any_of(far.data.begin(), far.data.end(),
                          [](const auto& item) { return item.first == "cure_other_branch"; }));
  cell::Cell part = shippedCell("fanuc_arcmate120ic_part_carried");
  part.T_base_tcp.translation() += Vec3(4000, 0, 0);
  EXPECT_NE(explained(part).remedy.str().find("let the robot carry the torch"), std::string::npos);
  // Without the other cell nothing helps.
  part.other = nullptr;
  EXPECT_NE(explained(part).remedy.str().find("none of these alone"), std::string::npos);
}

/// Every robot with an arm is shipped as a torch-carried and a part-carried cell that name each
/// other.
TEST(OtherConfiguration, everyArmIsShippedInBoth) {
  const std::pair<const char*, const char*> pairs[] = {
      {"fanuc_arcmate120ic", "fanuc_arcmate120ic_part_carried"},
      {"yaskawa_ma1440_mt250", "yaskawa_ma1440_part_carried"},
      {"kuka_kr16_positioner", "kuka_kr16_part_carried"},
      {"kuka_kr360_platter", "kuka_kr360_part_carried"}};
  for (const auto& [torch, part] : pairs) {
    const cell::Cell carried = shippedCell(part);
    const cell::Cell carrying = shippedCell(torch);
    EXPECT_TRUE(carried.partCarried()) << part;
    EXPECT_FALSE(carrying.partCarried()) << torch;
    ASSERT_NE(carried.other, nullptr) << part;
    ASSERT_NE(carrying.other, nullptr) << torch;
    EXPECT_EQ(carried.other->name, carrying.name);
    EXPECT_EQ(carrying.other->name, carried.name);
    ASSERT_EQ(carried.robotJoints(), carrying.robotJoints());
    for (int j = 0; j < carried.robotJoints(); ++j) {
      EXPECT_EQ(carried.joint(j).min, carrying.joint(j).min);
      EXPECT_EQ(carried.joint(j).max, carrying.joint(j).max);
      EXPECT_EQ(carried.joint(j).maxSpeed, carrying.joint(j).maxSpeed);
    }
  }
  EXPECT_TRUE(shippedCell("kuka_kr16").other->partCarried());
}

TEST(OtherConfiguration, ofAFileIsChecked) {
  const std::string folder = std::string(WCAM_RESOURCES) + "/cells";
  const std::string text = readFile(folder + "/fanuc_arcmate120ic.json");
  JobContext context;
  const auto problemOf = [&](const std::string& name) {
    Value file = parseJson(text, "cell");
    file.set("other_configuration", name);
    try {
      (void)cell::cellFromValue(file, "cell", context, folder);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(problemOf("fanuc_arcmate120ic_part_carried.json"), "");
  EXPECT_EQ(problemOf(""), "");
  EXPECT_NE(problemOf("kuka_kr16.json").find("has the same configuration"), std::string::npos);
  // One that is not there is told, and the cell works.
  EXPECT_EQ(context.diagnostics().count("cell.other_configuration_missing"), 0U);
  EXPECT_EQ(problemOf("missing.json"), "");
  EXPECT_EQ(context.diagnostics().count("cell.other_configuration_missing"), 1U);
}

}  // namespace
}  // namespace wcam::motion
