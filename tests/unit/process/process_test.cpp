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
  params.wireSpeedMin = params.wireSpeed;
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

/// Straight beads along x at the given places across, one layer at the given height.
toolpath::Toolpath straightBeads(const std::vector<double>& across,
                                 double height,
                                 toolpath::BeadFeature feature = toolpath::BeadFeature::Wall) {
  toolpath::Layer layer;
  for (const double y : across) {
    toolpath::Bead bead;
    bead.feature = feature;
    for (int i = 0; i <= 20; ++i) {
      toolpath::PathPoint point;
      point.p = {5.0 * i, y, height};
      point.height = height;
      point.distance = height;
      bead.points.push_back(point);
    }
    layer.beads.push_back(std::move(bead));
  }
  return {{layer}};
}

/// Wire per length of bead at the middle of its length, mm².
double wireSection(const toolpath::Bead& bead, const ProcessParams& params) {
  const toolpath::PathPoint& point = bead.points[bead.points.size() / 2];
  const double wire = kPi / 4.0 * params.wireDiameter.value() * params.wireDiameter.value();
  return wire * point.wireSpeed / point.speed;
}

TEST(TouchingBeads, ShareWhatLiesBetweenThem) {
  ProcessParams params;
  params.speedMax = 20.0_mm_s;
  params.beadWidth = 6.0_mm;
  const toolpath::Toolpath path =
      applyProcess(straightBeads({0.0, 4.0, 8.5, 40.0}, 2.0), params, JobContext());
  const auto& beads = path.layers[0].beads;
  const double free = 0.5 * wallSection(2.0, 6.0);
  EXPECT_NEAR(wireSection(beads[0], params), free + 2.0 * 2.0, 1e-3);
  EXPECT_NEAR(wireSection(beads[1], params), (2.0 + 2.25) * 2.0, 1e-3);
  EXPECT_NEAR(wireSection(beads[2], params), free + 2.25 * 2.0, 1e-3);
  EXPECT_EQ(beads[3].points[7].fillWidth, 0.0);
  EXPECT_NEAR(wireSection(beads[3], params), wallSection(2.0, 6.0), 1e-9);
  for (const toolpath::Bead& bead : beads) {
    EXPECT_EQ(bead.points[7].width, 6.0);
  }
}

TEST(TouchingBeads, CladdingEndsInDingsParabola) {
  ProcessParams params;
  params.speedMax = 20.0_mm_s;
  params.beadWidth = 6.0_mm;
  const double spacing = 0.667 * 6.0;
  const toolpath::Toolpath path = applyProcess(
      straightBeads({0.0, spacing, 2.0 * spacing}, 2.0, toolpath::BeadFeature::Cladding), params,
      JobContext());
  const auto& beads = path.layers[0].beads;
  EXPECT_NEAR(wireSection(beads[0], params), (2.0 + 0.5 * spacing) * 2.0, 1e-3);
  EXPECT_NEAR(wireSection(beads[1], params), spacing * 2.0, 1e-3);
}

TEST(TouchingBeads, ABeadThatComesBackIsItsOwnNeighbour) {
  ProcessParams params;
  params.beadWidth = 6.0_mm;
  toolpath::Toolpath there = straightBeads({0.0}, 2.0);
  toolpath::Toolpath back = straightBeads({4.0}, 2.0);
  auto& points = there.layers[0].beads[0].points;
  const auto& other = back.layers[0].beads[0].points;
  points.insert(points.end(), other.rbegin(), other.rend());
  const toolpath::Toolpath path = applyProcess(there, params, JobContext());
  EXPECT_NEAR(path.layers[0].beads[0].points[8].fillWidth, 0.5 * wallSection(2.0, 6.0) / 2.0 + 2.0,
              1e-3);
}

TEST(TouchingBeads, WallsAndSpiralsThatStandAloneKeepTheirSection) {
  const ProcessParams params;
  toolpath::Toolpath path = applyProcess(elbowPath(), params, JobContext());
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::PathPoint& point : layer.beads[0].points) {
      ASSERT_EQ(point.fillWidth, 0.0);
    }
  }
  path = straightBeads({0.0, 4.0}, 2.0);
  path.layers[0].beads[0].revolutions = 3;
  path = applyProcess(path, params, JobContext());
  EXPECT_EQ(path.layers[0].beads[0].points[5].fillWidth, 0.0);
}

TEST(TouchingBeads, LessWireAtTheMaximumSpeedKeepsTheSection) {
  JobContext context;
  ProcessParams params;
  params.beadWidth = 6.0_mm;
  params.speedMax = 10.0_mm_s;
  const auto beads = straightBeads({0.0, 3.0, 6.0, 9.0, 12.0}, 2.0);
  toolpath::Toolpath path = applyProcess(beads, params, context);
  const double wire = path.layers[0].beads[0].points[10].wireSpeed;
  EXPECT_LT(wire, params.wireSpeed.value());
  for (std::size_t b = 0; b < 5; ++b) {
    const toolpath::PathPoint& point = path.layers[0].beads[b].points[10];
    EXPECT_LE(point.speed, 10.0);
    EXPECT_EQ(point.wireSpeed, wire);
  }
  // At most a percent too much, of all.
  EXPECT_NEAR(wireSection(path.layers[0].beads[2], params), 3.0 * 2.0, 0.03 * 6.0);
  const ProcessStatistics s = processStatistics(path, params);
  EXPECT_NEAR(s.wireVolume / s.wantedVolume, 1.0, 0.0101);
  EXPECT_EQ(operationWireSpeed(path, params), wire);
  EXPECT_EQ(context.diagnostics().count("process.wire_lowered"), 1U);
  // A feed that must not change deposits too much, and says so.
  params.wireSpeedMin = params.wireSpeed;
  JobContext constant;
  path = applyProcess(beads, params, constant);
  EXPECT_EQ(path.layers[0].beads[1].points[10].wireSpeed, params.wireSpeed.value());
  EXPECT_EQ(constant.diagnostics().count("process.wire_lowered"), 0U);
  EXPECT_EQ(constant.diagnostics().count("process.speed_clamped"), 1U);
}

TEST(WireFeed, SingleBeadsThatAreTooThinForTheMaximumSpeedLowerItToo) {
  ProcessParams params;
  params.beadWidth = 6.0_mm;
  params.speedMax = 5.0_mm_s;
  params.wireSpeed = 4.0_m_min;
  params.wireSpeedMin = 1.0_m_min;
  // Walls far apart: what they hold at 5 mm/s is their own section.
  const auto walls = straightBeads({0.0, 40.0, 80.0}, 1.6);
  JobContext context;
  const toolpath::Toolpath path = applyProcess(walls, params, context);
  const double feed = 5.0 * wallSection(1.6, 6.0) / (kPi / 4.0 * 1.2 * 1.2);
  EXPECT_LT(feed, params.wireSpeed.value());
  EXPECT_NEAR(path.layers[0].beads[0].points[10].wireSpeed, feed, 0.02 * feed);
  const ProcessStatistics s = processStatistics(path, params);
  EXPECT_NEAR(s.wireVolume / s.wantedVolume, 1.0, 0.0101);
  EXPECT_EQ(context.diagnostics().count("process.wire_lowered"), 1U);
  // Within the window nothing changes.
  JobContext wide;
  params.speedMax = 50.0_mm_s;
  (void)applyProcess(walls, params, wide);
  EXPECT_EQ(wide.diagnostics().count("process.wire_lowered"), 0U);
}

TEST(WireFeed, ThickPlacesAreNotStarvedForThinOnes) {
  // A thin bead of 1 mm beside nine high ones that leave the process no slower travel.
  ProcessParams params;
  params.beadWidth = 6.0_mm;
  params.speedMin = 4.0_mm_s;
  params.speedMax = 5.0_mm_s;
  params.wireSpeed = 4.0_m_min;
  params.wireSpeedMin = 1.0_m_min;
  toolpath::Toolpath path =
      straightBeads({0.0, 40.0, 80.0, 120.0, 160.0, 200.0, 240.0, 280.0, 320.0, 360.0}, 3.2);
  for (toolpath::PathPoint& point : path.layers[0].beads[0].points) {
    point.height = 1.0;
  }
  const double fed = kPi / 4.0 * 1.2 * 1.2 * params.wireSpeed.value();
  ASSERT_GT(wallSection(3.2, 6.0), fed / 4.5);
  const toolpath::Toolpath done = applyProcess(path, params, JobContext());
  double missing = 0.0;
  for (const toolpath::Bead& bead : done.layers[0].beads) {
    missing += std::max(0.0, beadSection(bead.points[10]) - wireSection(bead, params));
  }
  EXPECT_LT(missing / (9.0 * wallSection(3.2, 6.0)), 0.03);
}

}  // namespace
}  // namespace wcam::process
