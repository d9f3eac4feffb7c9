// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/process/process.hpp"
#include "wcam/toolpath/build.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::toolpath {
namespace {

using test::circle;
using test::layerOf;

Bead bead(const std::string& params, const Contour& contour = circle(20, 2.0, Vec3::Zero(), 144)) {
  const Toolpath path = buildToolpath({{layerOf(2.0, {contour})}}, *test::plate(),
                                      PathParams::schema().read(parseJson(params)), JobContext());
  return process::applyProcess(path, process::ProcessParams{}, JobContext()).layers[0].beads[0];
}

double lengthOf(const Bead& bead, BeadZone zone) {
  double length = 0.0;
  for (std::size_t i = 1; i < bead.points.size(); ++i) {
    length += bead.points[i].zone == zone ? (bead.points[i].p - bead.points[i - 1].p).norm() : 0.0;
  }
  return length;
}

void expectFrames(const Bead& bead) {
  for (const PathPoint& point : bead.points) {
    EXPECT_NEAR((point.t.cross(point.n) - point.b).norm(), 0.0, 1e-12);
    EXPECT_NEAR(point.axis.norm(), 1.0, 1e-12);
  }
}

TEST(Zones, NoneByDefault) {
  for (const PathPoint& point : bead("{}").points) {
    EXPECT_TRUE(point.arc);
    EXPECT_EQ(point.zone, BeadZone::Body);
    EXPECT_EQ(point.speedFactor, 1.0);
  }
}

TEST(Zones, OverlapRunsPastTheSeamByItsLength) {
  const Bead b = bead(R"({"overlap": 7.3})");
  EXPECT_NEAR(lengthOf(b, BeadZone::Overlap), 7.3, 1e-9);
  EXPECT_TRUE(b.points.back().arc);
  // It follows the bead's own start.
  std::size_t i = 0;
  while (b.points[i].zone == BeadZone::Body) {
    ++i;
  }
  EXPECT_EQ(b.points[i - 1].p, b.points[0].p);
  EXPECT_EQ(b.points[i].p, b.points[1].p);
  expectFrames(b);
  Contour open = circle(20, 2.0);
  open.closed = false;
  EXPECT_EQ(lengthOf(bead(R"({"overlap": 7.3})", open), BeadZone::Overlap), 0.0);
}

TEST(Zones, LeadsAreTangentialAndTheArcIsAsAsked) {
  for (const bool arc : {false, true}) {
    const Bead b = bead(std::string(R"({"lead_in": 5, "lead_out": 8, "lead_arc": )") +
                        (arc ? "true}" : "false}"));
    const auto& points = b.points;
    const std::size_t n = points.size();
    EXPECT_NEAR((points[1].p - points[0].p - 5.0 * points[1].t).norm(), 0.0, 1e-12);
    EXPECT_NEAR((points[n - 1].p - points[n - 2].p - 8.0 * points[n - 2].t).norm(), 0.0, 1e-12);
    EXPECT_EQ(points[1].arc, arc);
    EXPECT_EQ(points[1].zone, BeadZone::LeadIn);
    EXPECT_TRUE(points[2].arc);
    EXPECT_EQ(points[n - 1].arc, arc);
    EXPECT_EQ(points[n - 1].wireSpeed > 0.0, arc);
    EXPECT_TRUE(points[n - 2].arc);
  }
}

TEST(Zones, WipeGoesBackOverTheBeadWithTheArcOff) {
  const Bead b = bead(R"({"wipe": 6.0, "wipe_lift": 1.5})");
  double length = 0.0;
  Vec3 flat = b.points[144].p;
  for (std::size_t i = 145; i < b.points.size(); ++i) {
    const PathPoint& point = b.points[i];
    EXPECT_FALSE(point.arc);
    EXPECT_EQ(point.zone, BeadZone::Wipe);
    const Vec3 down = point.p - Vec3(0, 0, point.p.z() - 2.0);
    length += (down - flat).norm();
    flat = down;
    EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), 20.0, 0.01);
    // Back: against the travel of the bead there.
    EXPECT_LT((b.points[i].p - b.points[i - 1].p).dot(point.t), 0.0);
  }
  EXPECT_NEAR(length, 6.0, 1e-9);
  EXPECT_NEAR(b.points.back().p.z(), 3.5, 1e-9);
}

TEST(Zones, RampsAreLinearAndMeetTheBead) {
  const process::ProcessParams process;
  const Bead plain = bead("{}");
  const Bead b = bead(R"({"ramp_in": 10, "ramp_in_speed": 0.6, "ramp_in_wire": 0.8,
                          "ramp_out": 5, "ramp_out_speed": 1.4, "ramp_out_wire": 0.5})");
  const double whole = plain.length();
  EXPECT_NEAR(b.length(), whole, 1e-9);
  const double speed = plain.points[5].speed;
  double at = 0.0;
  int inRamp = 0;
  for (std::size_t i = 1; i < b.points.size(); ++i) {
    const double piece = (b.points[i].p - b.points[i - 1].p).norm();
    const double middle = at + 0.5 * piece;
    at += piece;
    double speedFactor = 1.0;
    double wireFactor = 1.0;
    if (middle < 10) {
      speedFactor = 0.6 + 0.04 * middle;
      wireFactor = 0.8 + 0.02 * middle;
      ++inRamp;
    } else if (whole - middle < 5) {
      speedFactor = 1.4 - 0.08 * (whole - middle);
      wireFactor = 0.5 + 0.1 * (whole - middle);
      ++inRamp;
    }
    EXPECT_NEAR(b.points[i].speed, speed * speedFactor, 1e-9) << i;
    EXPECT_NEAR(b.points[i].wireSpeed, process.wireSpeed.value() * wireFactor, 1e-9) << i;
  }
  EXPECT_GE(inRamp, 10);
  expectFrames(b);
}

TEST(Zones, RampsLongerThanTheBeadAreShortened) {
  Contour line;
  line.points = {{Vec3(0, 0, 2), Vec3::UnitY()}, {Vec3(6, 0, 2), Vec3::UnitY()}};
  const Bead b = bead(R"({"ramp_in": 20, "ramp_in_speed": 0.5, "ramp_out": 10})", line);
  EXPECT_NEAR(b.length(), 6.0, 1e-12);
  for (std::size_t i = 1; i < b.points.size(); ++i) {
    const double middle = 0.5 * (b.points[i].p.x() + b.points[i - 1].p.x());
    EXPECT_NEAR(b.points[i].speedFactor, middle < 4.0 ? 0.5 + 0.5 * middle / 4.0 : 1.0, 1e-9);
  }
}

TEST(Zones, AllTogetherInTheirOrder) {
  const Bead b = bead(R"({"lead_in": 3, "overlap": 4, "lead_out": 5, "wipe": 6, "ramp_in": 2,
                          "ramp_in_speed": 0.7})");
  int last = -1;
  const auto rank = [](BeadZone zone) {
    switch (zone) {
      case BeadZone::LeadIn:
        return 0;
      case BeadZone::Body:
        return 1;
      case BeadZone::Overlap:
        return 2;
      case BeadZone::LeadOut:
        return 3;
      case BeadZone::Wipe:
        return 4;
    }
    return 5;
  };
  for (const PathPoint& point : b.points) {
    EXPECT_GE(rank(point.zone), last);
    last = rank(point.zone);
  }
  EXPECT_EQ(last, 4);
  EXPECT_NEAR(lengthOf(b, BeadZone::LeadIn), 3.0, 1e-9);
  EXPECT_NEAR(lengthOf(b, BeadZone::LeadOut), 5.0, 1e-9);
}

TEST(Zones, StatisticsCountTheArcOnly) {
  const SlicedLayers sliced{{layerOf(2.0, {circle(20, 2.0)})}};
  const process::ProcessParams process;
  const auto statistics = [&](const std::string& params) {
    return process::processStatistics(
        process::applyProcess(
            buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                          JobContext()),
            process, JobContext()),
        process);
  };
  EXPECT_NEAR(statistics(R"({"lead_in": 9, "wipe": 9})").length, statistics("{}").length, 1e-9);
  EXPECT_NEAR(statistics(R"({"lead_in": 9, "lead_arc": true})").length,
              statistics("{}").length + 9.0, 1e-9);
}

}  // namespace
}  // namespace wcam::toolpath
