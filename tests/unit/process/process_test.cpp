// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/process/process.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::process {
namespace {

TEST(WallSection, ValuesOfTheStackedDiscs) {
  // Diourté M27 with w = 5.2.
  EXPECT_NEAR(wallSection(1.8, 5.2), 9.17, 0.005);
  EXPECT_NEAR(wallSection(2.0, 5.2), 10.14, 0.005);
  EXPECT_NEAR(wallSection(2.2, 5.2), 11.09, 0.005);
  EXPECT_NEAR(wallSection(5.2, 5.2), kPi * 2.6 * 2.6, 1e-9);  // the discs only touch
  EXPECT_DOUBLE_EQ(wallSection(6.0, 5.2), wallSection(5.2, 5.2));
  EXPECT_DOUBLE_EQ(wallSection(0.0, 5.2), 0.0);
}

TEST(TravelSpeed, TableOfDiourteM29) {
  ProcessParams params;
  params.wireDiameter = 1.0_mm;
  params.beadWidth = 5.2_mm;
  params.wireSpeed = 2.3_m_min;
  EXPECT_NEAR(travelSpeed(1.8, params), 3.28, 0.005);
  EXPECT_NEAR(travelSpeed(2.0, params), 2.97, 0.005);
  EXPECT_NEAR(travelSpeed(2.2, params), 2.72, 0.006);
  params.wireSpeed = 1.9_m_min;
  EXPECT_NEAR(travelSpeed(1.8, params), 2.71, 0.005);
  EXPECT_NEAR(travelSpeed(2.0, params), 2.45, 0.005);
  EXPECT_NEAR(travelSpeed(2.2, params), 2.24, 0.006);
}

TEST(TravelSpeed, DepositedHeightIsItsInverse) {
  const ProcessParams params;
  for (const double h : {0.3, 1.0, 2.5, 5.0, 7.9}) {
    EXPECT_NEAR(depositedHeight(travelSpeed(h, params), params), h, 1e-9);
  }
}

toolpath::Toolpath elbowPath() {
  plugin::SliceInput input{{test::importSample("elbow/elbow.step")}, test::plate(), nullptr, {}};
  input.guide = geometry::guideFromFormula({"50*cos(t)-50", "0", "50*sin(t)"}, 0.0, kPi / 2.0);
  const auto sliced = test::slice("wcam.slicing.guide", input, R"({"step": 5.0})");
  return toolpath::buildToolpath(sliced, *test::plate(), toolpath::PathParams{}, JobContext());
}

TEST(ApplyProcess, DepositedVolumeIsTheWireVolume) {
  JobContext context;
  const ProcessParams params;
  const toolpath::Toolpath path = applyProcess(elbowPath(), params, context);
  const ProcessStatistics s = processStatistics(path, params);
  EXPECT_EQ(s.clampedPoints, 0U);
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
  EXPECT_NEAR(s.wireVolume / s.wantedVolume, 1.0, 1e-12);
  EXPECT_NEAR(s.wireLength, params.wireSpeed.value() * s.time, 1e-6);
  EXPECT_NEAR(s.mass, s.wireVolume * 7.85e-3, 1e-9);
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::PathPoint& point : layer.beads[0].points) {
      EXPECT_NEAR(point.speed * wallSection(point.height, point.width),
                  kPi / 4.0 * 1.44 * point.wireSpeed, 1e-9);
    }
  }
}

TEST(ApplyProcess, AWidthOfThePathIsKeptAndGivesTheSection) {
  const ProcessParams params;
  toolpath::Toolpath path = elbowPath();
  for (toolpath::PathPoint& point : path.layers[1].beads[0].points) {
    point.width = 7.0;
  }
  path = applyProcess(path, params, JobContext());
  for (const toolpath::PathPoint& point : path.layers[1].beads[0].points) {
    EXPECT_EQ(point.width, 7.0);
    EXPECT_NEAR(point.speed * wallSection(point.height, 7.0), kPi / 4.0 * 1.44 * point.wireSpeed,
                1e-9);
  }
  EXPECT_EQ(path.layers[2].beads[0].points[0].width, 8.0);
  const ProcessStatistics s = processStatistics(path, params);
  EXPECT_NEAR(s.wireVolume / s.wantedVolume, 1.0, 1e-12);
}

TEST(ApplyProcess, SpeedsAreClampedToTheWindowWithAFinding) {
  JobContext context;
  ProcessParams params;
  params.speedMin = 3.0_mm_s;
  params.speedMax = 3.5_mm_s;
  params.heightMax = 6.0_mm;
  const toolpath::Toolpath path = applyProcess(elbowPath(), params, context);
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::PathPoint& point : layer.beads[0].points) {
      EXPECT_GE(point.speed, 3.0);
      EXPECT_LE(point.speed, 3.5);
    }
  }
  EXPECT_EQ(context.diagnostics().count("process.speed_clamped"), path.layers.size());
  EXPECT_EQ(context.diagnostics().count("process.height_out_of_range"), path.layers.size());
  const ProcessStatistics s = processStatistics(path, params);
  EXPECT_GT(s.clampedPoints, 0U);
  EXPECT_NEAR(s.wireLength, params.wireSpeed.value() * s.time, 1e-6);
}

TEST(ApplyProcess, WireSpeedOutsideItsRangeIsNamed) {
  const ParamSchema& schema = ProcessParams::schema().params();
  for (const double metresPerMinute : {0.0, -2.0, 0.04, 61.0, 1e300}) {
    try {
      (void)schema.complete(Value::object({{"wire_speed", metresPerMinute}}), "process 'p'");
      FAIL() << metresPerMinute;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("wire_speed"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("process 'p'"), std::string::npos) << error.what();
    }
  }
  EXPECT_NO_THROW((void)schema.complete(Value::object({{"wire_speed", 8.0}}), "process 'p'"));
}

TEST(ApplyProcess, ContradictoryWindowsAreRefused) {
  ProcessParams params;
  params.speedMin = 30.0_mm_s;
  EXPECT_THROW((void)applyProcess({}, params, JobContext()), Error);
  params = {};
  params.heightMin = 8.0_mm;
  EXPECT_THROW((void)applyProcess({}, params, JobContext()), Error);
}

}  // namespace
}  // namespace wcam::process
