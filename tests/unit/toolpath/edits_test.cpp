// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/edits.hpp"

#include "wcam/process/process.hpp"
#include "wcam/toolpath/edit_findings.hpp"

#include "error_matchers.hpp"
#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {
namespace {

using test::circle;
using test::layerOf;
using ::testing::HasSubstr;

constexpr double kRadius = 20.0;
constexpr double kStep = 2.0;

/// Circles above each other; the first one lies a step above the plate.
Toolpath stack(int layers, const std::string& params = "{}", bool closed = true) {
  SlicedLayers sliced;
  for (int l = 1; l <= layers; ++l) {
    Contour contour = circle(kRadius, kStep * l);
    contour.closed = closed;
    sliced.layers.push_back(layerOf(kStep * l, {contour}));
  }
  return buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                       JobContext());
}

Edit edit(const std::string& type, const std::string& params) {
  return readEdit("e", editTypeOf(type).value(), parseJson(params));
}

Toolpath edited(const Toolpath& path,
                const std::string& type,
                const std::string& params,
                const std::string& pathParams = "{}",
                const JobContext& context = JobContext()) {
  return applyEdit(path, edit(type, params),
                   PathParams::schema().read(parseJson(pathParams)).zones(), context);
}

double lengthOf(const Toolpath& path) {
  double length = 0.0;
  for (const Layer& layer : path.layers) {
    for (const Bead& bead : layer.beads) {
      length += bead.length();
    }
  }
  return length;
}

const std::vector<PathPoint>& points(const Toolpath& path, std::size_t layer = 0) {
  return path.layers[layer].beads[0].points;
}

void expectFrames(const Toolpath& path) {
  for (const Layer& layer : path.layers) {
    for (const Bead& bead : layer.beads) {
      for (const PathPoint& point : bead.points) {
        ASSERT_NEAR((point.t.cross(point.n) - point.b).norm(), 0.0, 1e-12);
        ASSERT_NEAR(point.axis.norm(), 1.0, 1e-12);
        ASSERT_NEAR(point.t.norm(), 1.0, 1e-12);
      }
    }
  }
}

bool same(const Toolpath& a, const Toolpath& b, double tolerance) {
  if (a.layers.size() != b.layers.size() || a.pointCount() != b.pointCount()) {
    return false;
  }
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    for (std::size_t k = 0; k < a.layers[l].beads.size(); ++k) {
      const Bead& x = a.layers[l].beads[k];
      const Bead& y = b.layers[l].beads[k];
      if (x.points.size() != y.points.size() || x.closed != y.closed) {
        return false;
      }
      for (std::size_t i = 0; i < x.points.size(); ++i) {
        const PathPoint& p = x.points[i];
        const PathPoint& q = y.points[i];
        const double worst = std::max(
            {(p.p - q.p).norm(), (p.t - q.t).norm(), (p.n - q.n).norm(), (p.b - q.b).norm(),
             (p.axis - q.axis).norm(), std::abs(p.height - q.height),
             std::abs(p.speedFactor - q.speedFactor), std::abs(p.wireFactor - q.wireFactor)});
        if (worst > tolerance || p.arc != q.arc || p.zone != q.zone) {
          return false;
        }
      }
    }
  }
  return true;
}

std::size_t count(const JobContext& context, const char* code) {
  return context.diagnostics().count(std::string_view(code));
}

// --- seam

TEST(MoveSeam, ByALengthMovesAlongTheBead) {
  const Toolpath path = stack(3);
  const double whole = points(path).size() > 1 ? path.layers[0].beads[0].length() : 0.0;
  for (const double length : {0.0, 1e-9, 3.3, 17.0, whole / 2, whole - 1e-9, 2.5 * whole, -8.0}) {
    const Toolpath moved = edited(
        path, "move_seam",
        "{\"first_layer\": 1, \"last_layer\": 1, \"length\": " + std::to_string(length) + "}");
    EXPECT_TRUE(same({{path.layers[0]}}, {{moved.layers[0]}}, 0.0));
    EXPECT_TRUE(same({{path.layers[2]}}, {{moved.layers[2]}}, 0.0));
    EXPECT_NEAR(moved.layers[1].beads[0].length(), whole, 1e-9);
    EXPECT_EQ(points(moved, 1).front().p, points(moved, 1).back().p);
    // The new start lies that far from the old one, as the bead runs.
    double way = std::fmod(length, whole);
    way += way < 0.0 ? whole : 0.0;
    double along = 0.0;
    const auto& old = points(path, 1);
    for (std::size_t i = 1; i < old.size(); ++i) {
      const double piece = (old[i].p - old[i - 1].p).norm();
      if (way <= along + piece + 1e-6) {
        const Vec3 wanted = old[i - 1].p + (way - along) / piece * (old[i].p - old[i - 1].p);
        EXPECT_NEAR((points(moved, 1).front().p - wanted).norm(), 0.0, 2e-6) << length;
        break;
      }
      along += piece;
    }
    expectFrames(moved);
  }
}

TEST(MoveSeam, AtPointsKeepsTheSetOfPoints) {
  const Toolpath path = stack(1);
  const Toolpath moved = edited(path, "move_seam", R"({"length": 31.4, "exact": false})");
  ASSERT_EQ(moved.pointCount(), path.pointCount());
  const auto& before = points(path);
  const auto& after = points(moved);
  const std::size_t n = before.size() - 1;
  std::size_t shift = 0;
  while (before[shift].p != after[0].p) {
    ASSERT_LT(++shift, n);
  }
  EXPECT_GT(shift, 0U);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(after[i].p, before[(i + shift) % n].p);
    EXPECT_EQ(after[i].t, before[(i + shift) % n].t);
  }
  // And back again.
  EXPECT_TRUE(
      same(edited(moved, "move_seam", R"({"length": -31.4, "exact": false})"), path, 1e-12));
}

TEST(MoveSeam, ToAPointOrAnAngle) {
  const Toolpath path = stack(2);
  const Toolpath point = edited(path, "move_seam", R"({"seam": "point", "point": [0, 30, 2]})");
  EXPECT_NEAR((points(point).front().p - Vec3(0, kRadius, kStep)).norm(), 0.0, 1e-9);
  for (const double degrees : {0.0, 37.0, 90.0, 181.0, -45.0, 359.0}) {
    const Toolpath angle = edited(
        path, "move_seam", "{\"seam\": \"angle\", \"angle\": " + std::to_string(degrees) + "}");
    for (std::size_t l = 0; l < 2; ++l) {
      const Vec3 start = points(angle, l).front().p;
      double off = degToRad(degrees) - std::atan2(start.y(), start.x());
      off -= 2.0 * kPi * std::round(off / (2.0 * kPi));
      EXPECT_NEAR(off, 0.0, 1e-9) << degrees;
    }
  }
}

TEST(MoveSeam, MakesTheEndsAnew) {
  const std::string zones =
      R"({"overlap": 5, "lead_in": 3, "ramp_in": 4, "ramp_in_speed": 0.5, "wipe": 6})";
  const Toolpath path = stack(1, zones);
  const Toolpath moved = edited(path, "move_seam", R"({"length": 20})", zones);
  const auto zone = [](const Toolpath& p, BeadZone wanted) {
    double length = 0.0;
    const auto& all = points(p);
    for (std::size_t i = 1; i < all.size(); ++i) {
      length += all[i].zone == wanted ? (all[i].p - all[i - 1].p).norm() : 0.0;
    }
    return length;
  };
  for (const BeadZone wanted : {BeadZone::Body, BeadZone::LeadIn, BeadZone::Overlap}) {
    EXPECT_NEAR(zone(moved, wanted), zone(path, wanted), 1e-9);
  }
  EXPECT_EQ(points(moved).front().zone, BeadZone::LeadIn);
  EXPECT_FALSE(points(moved)[1].arc);
  EXPECT_LT(points(moved)[2].speedFactor, 0.6);
  // The old ramp is gone.
  std::size_t ramped = 0;
  for (const PathPoint& point : points(moved)) {
    ramped += point.speedFactor < 1.0 ? 1U : 0U;
  }
  std::size_t before = 0;
  for (const PathPoint& point : points(path)) {
    before += point.speedFactor < 1.0 ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(ramped), static_cast<double>(before), 2.0);
}

TEST(MoveSeam, OpenBeadsStayAndSayNothingIsThere) {
  const Toolpath path = stack(2, "{}", false);
  const JobContext context;
  EXPECT_TRUE(same(edited(path, "move_seam", "{}", "{}", context), path, 0.0));
  EXPECT_EQ(count(context, "edit.selects_nothing"), 1U);
  EXPECT_THAT(context.diagnostics().items()[0].message, HasSubstr("'e' (move_seam)"));
}

// --- layers

TEST(DeleteLayers, LeavesTheOthersAlone) {
  const Toolpath path = stack(6);
  const JobContext context;
  const Toolpath resumed = edited(path, "delete_layers", R"({"last_layer": 1})", "{}", context);
  ASSERT_EQ(resumed.layers.size(), 4U);
  EXPECT_TRUE(same({{resumed.layers[0]}}, {{path.layers[2]}}, 0.0));
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
  EXPECT_NEAR(lengthOf(resumed), lengthOf(path) * 4.0 / 6.0, 1e-9);
  EXPECT_EQ(edited(path, "delete_layers", R"({"first_layer": -2})").layers.size(), 4U);
}

TEST(DeleteLayers, AGapIsMeasuredAndTold) {
  const Toolpath path = stack(6);
  const JobContext context;
  const Toolpath gap =
      edited(path, "delete_layers", R"({"first_layer": 2, "last_layer": 3})", "{}", context);
  ASSERT_EQ(gap.layers.size(), 4U);
  for (const PathPoint& point : points(gap, 2)) {
    EXPECT_NEAR(point.distance, 3.0 * kStep, 1e-9);
    EXPECT_NEAR(point.height, 3.0 * kStep, 1e-9);
  }
  EXPECT_EQ(points(gap, 3)[0].height, points(path, 5)[0].height);
  EXPECT_EQ(count(context, "edit.layer_gap"), 1U);
}

TEST(DeleteLayers, ClosesTheGap) {
  const Toolpath path = stack(6);
  const JobContext context;
  const Toolpath closed =
      edited(path, "delete_layers", R"({"first_layer": 2, "last_layer": 3, "close_gap": true})",
             "{}", context);
  EXPECT_TRUE(same(closed, stack(4), 1e-9));
  EXPECT_TRUE(context.diagnostics().items().empty());
  for (std::size_t l = 0; l < 4; ++l) {
    EXPECT_NEAR(closed.layers[l].level, kStep * static_cast<double>(l + 1), 1e-9);
  }
}

TEST(RepeatLayers, StacksTheRange) {
  const Toolpath path = stack(4);
  const Toolpath repeated =
      edited(path, "repeat_layers", R"({"first_layer": 1, "last_layer": 2, "count": 3})");
  EXPECT_TRUE(same(repeated, stack(10), 1e-9));
  for (std::size_t l = 0; l < repeated.layers.size(); ++l) {
    EXPECT_NEAR(repeated.layers[l].level, kStep * static_cast<double>(l + 1), 1e-9);
  }
  // What was added is taken away again.
  EXPECT_TRUE(same(edited(repeated, "delete_layers",
                          R"({"first_layer": 3, "last_layer": 8, "close_gap": true})"),
                   path, 1e-9));
}

TEST(RepeatLayers, ByAGivenOffsetMeasuresTheHeight) {
  const Toolpath path = stack(2);
  const Toolpath repeated = edited(
      path, "repeat_layers", R"({"count": 1, "offset_mode": "given", "offset": [0, 0, 5.5]})");
  ASSERT_EQ(repeated.layers.size(), 4U);
  EXPECT_NEAR(points(repeated, 2)[0].p.z(), kStep + 5.5, 1e-12);
  EXPECT_NEAR(points(repeated, 2)[0].distance, 3.5, 1e-9);
  EXPECT_NEAR(points(repeated, 2)[0].height, 3.5, 1e-9);
  EXPECT_EQ(points(repeated, 3)[0].height, points(path, 1)[0].height);
}

TEST(RepeatLayers, RefusesToFillTheMemory) {
  EXPECT_THAT(wcam::testing::errorOf(
                  ErrorCode::InvalidArgument,
                  [] { (void)edited(stack(60), "repeat_layers", R"({"count": 10000})"); }),
              HasSubstr("lower count"));
}

// --- speed and wire

process::ProcessParams processParams() {
  process::ProcessParams params;
  params.speedMax = 20.0_mm_s;  // room for edits of the speed
  return params;
}

TEST(SetSpeed, CutsExactlyAtTheBorderAndKeepsLengths) {
  const Toolpath path = stack(2);
  const double whole = lengthOf(path);

  struct Case {
    const char* region;
    double angle;  ///< of the arc of the circle that lies inside
  };

  const double polygon = whole / 2.0;
  for (const Case& c :
       {Case{R"("region": "half_space", "plane_normal": [1, 0, 0])", kPi},
        Case{R"("region": "box", "box_min": [-100, 10, -1], "box_max": [100, 100, 9])",
             2.0 * kPi / 3.0},
        Case{R"("region": "sphere", "centre": [20, 0, 2], "radius": 20)", 2.0 * kPi / 3.0},
        Case{R"("region": "length", "from": 10, "to": 40)", 30.0 / kRadius}}) {
    const Toolpath slow = edited(
        path, "set_speed", std::string("{\"last_layer\": 0, \"factor\": 0.5, ") + c.region + "}");
    EXPECT_NEAR(lengthOf(slow), whole, 1e-9) << c.region;
    EXPECT_TRUE(same({{slow.layers[1]}}, {{path.layers[1]}}, 0.0));
    double inside = 0.0;
    const auto& all = points(slow);
    for (std::size_t i = 1; i < all.size(); ++i) {
      inside += all[i].change.speed == 0.5 ? (all[i].p - all[i - 1].p).norm() : 0.0;
    }
    // The polygon of 72 sides and its circle differ by 0.03 % in length.
    EXPECT_NEAR(inside, c.angle * kRadius, 4e-4 * polygon) << c.region;
    expectFrames(slow);
  }
}

TEST(SetSpeed, PutsPointsOnTheBorder) {
  const Toolpath slow = edited(stack(1), "set_speed",
                               R"({"factor": 2, "region": "half_space", "plane_point": [3.3, 0, 0],
                                   "plane_normal": [2, 0, 0]})");
  std::size_t on = 0;
  const auto& all = points(slow);
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    if (all[i].change.speed != all[i + 1].change.speed) {
      EXPECT_NEAR(all[i].p.x(), 3.3, 1e-12);
      ++on;
    }
  }
  EXPECT_EQ(on, 2U);
}

TEST(SetSpeed, TheWidthFollowsTheSection) {
  const process::ProcessParams params = processParams();
  const Toolpath plain = process::applyProcess(stack(2), params, JobContext());
  const double planned = points(plain)[5].speed;
  const JobContext context;
  const Toolpath fast = process::applyProcess(
      edited(stack(2), "set_speed", R"({"last_layer": 0, "factor": 1.25})"), params, context);
  const PathPoint& point = points(fast)[5];
  EXPECT_NEAR(point.speed, 1.25 * planned, 1e-12);
  EXPECT_EQ(point.wireSpeed, params.wireSpeed.value());
  const double area = kPi / 4.0 * 1.2 * 1.2;
  EXPECT_NEAR(process::wallSection(point.height, point.width), area * point.wireSpeed / point.speed,
              1e-9);
  EXPECT_LT(point.width, params.beadWidth.value());
  EXPECT_EQ(points(fast, 1)[5].speed, points(plain, 1)[5].speed);
  EXPECT_EQ(points(fast, 1)[5].width, points(plain, 1)[5].width);
  EXPECT_TRUE(context.diagnostics().items().empty());
}

TEST(SetSpeed, TheWireFollowsAndTheSectionStays) {
  const process::ProcessParams params = processParams();
  const Toolpath fast = process::applyProcess(
      edited(stack(1), "set_speed", R"({"mode": "value", "speed": 12.5, "follow": "wire"})"),
      params, JobContext());
  const PathPoint& point = points(fast)[5];
  EXPECT_EQ(point.speed, 12.5);
  EXPECT_EQ(point.width, params.beadWidth.value());
  const process::ProcessStatistics s = process::processStatistics(fast, params);
  EXPECT_NEAR(s.wireVolume, s.wantedVolume, 1e-9 * s.wantedVolume);
}

TEST(SetWire, TheSpeedFollowsAndTheSectionStays) {
  const process::ProcessParams params = processParams();
  const Toolpath plain = process::applyProcess(stack(1), params, JobContext());
  const Toolpath more = process::applyProcess(
      edited(stack(1), "set_wire", R"({"factor": 1.5, "follow": "speed"})"), params, JobContext());
  EXPECT_NEAR(points(more)[5].wireSpeed, 1.5 * params.wireSpeed.value(), 1e-12);
  EXPECT_NEAR(points(more)[5].speed, 1.5 * points(plain)[5].speed, 1e-12);
  const process::ProcessStatistics s = process::processStatistics(more, params);
  EXPECT_NEAR(s.wireVolume, s.wantedVolume, 1e-9 * s.wantedVolume);
}

TEST(SetWire, EditsFollowEachOther) {
  const process::ProcessParams params = processParams();
  Toolpath path = edited(stack(1), "set_wire", R"({"mode": "value", "wire_speed": 3})");
  path = edited(path, "set_wire", R"({"factor": 1.5})");
  path = edited(path, "set_speed", R"({"factor": 0.5})");
  path = edited(path, "set_speed", R"({"factor": 1.5})");
  const Toolpath plain = process::applyProcess(stack(1), params, JobContext());
  const Toolpath changed = process::applyProcess(path, params, JobContext());
  EXPECT_NEAR(points(changed)[5].wireSpeed, 4.5 * 1000.0 / 60.0, 1e-12);
  EXPECT_NEAR(points(changed)[5].speed, 0.75 * points(plain)[5].speed, 1e-12);
}

TEST(SetSpeed, OutsideTheWindowIsClampedAndTold) {
  const process::ProcessParams params = processParams();
  const JobContext context;
  const Toolpath fast = process::applyProcess(
      edited(stack(1), "set_speed", R"({"mode": "value", "speed": 90})"), params, context);
  EXPECT_EQ(points(fast)[5].speed, params.speedMax.value());
  EXPECT_EQ(count(context, "process.speed_clamped"), 1U);
  const JobContext starved;
  (void)process::applyProcess(edited(stack(1), "set_wire", R"({"factor": 0.05})"), params, starved);
  EXPECT_EQ(count(starved, "process.section_too_small"), 1U);
}

TEST(SetSpeed, ARegionBesideThePartSelectsNothing) {
  const JobContext context;
  const Toolpath path = stack(2);
  EXPECT_TRUE(
      same(edited(path, "set_speed", R"({"region": "sphere", "centre": [500, 0, 0], "radius": 3})",
                  "{}", context),
           path, 0.0));
  EXPECT_EQ(count(context, "edit.selects_nothing"), 1U);
}

// --- pause and direction

TEST(Pause, StandsBeforeAndAfterBeads) {
  const Toolpath path =
      edited(edited(stack(3), "pause", R"({"first_layer": 1, "last_layer": 1, "time": 12})"),
             "pause", R"({"where": "after", "time": 3, "last_layer": 0})");
  EXPECT_EQ(path.layers[1].beads[0].pauseBefore, 12.0);
  EXPECT_EQ(path.layers[0].beads[0].pauseAfter, 3.0);
  EXPECT_EQ(path.layers[2].beads[0].pauseBefore + path.layers[2].beads[0].pauseAfter, 0.0);
}

TEST(Pause, AtALengthCutsTheBead) {
  const std::string zones = R"({"lead_in": 3, "lead_out": 4, "overlap": 5, "ramp_out": 2,
                               "ramp_out_speed": 0.5})";
  const Toolpath path = stack(1, zones);
  const Toolpath cut =
      edited(path, "pause", R"({"where": "at_length", "length": 33.3, "time": 5})", zones);
  ASSERT_EQ(cut.layers[0].beads.size(), 2U);
  const Bead& first = cut.layers[0].beads[0];
  const Bead& second = cut.layers[0].beads[1];
  EXPECT_EQ(first.pauseBefore, 0.0);
  EXPECT_EQ(second.pauseBefore, 5.0);
  EXPECT_FALSE(first.closed || second.closed);
  // Two more runs onto and off a bead.
  EXPECT_NEAR(first.length() + second.length(), path.layers[0].beads[0].length() + 7.0, 1e-9);
  EXPECT_EQ(first.points.back().zone, BeadZone::LeadOut);
  EXPECT_EQ(second.points.front().zone, BeadZone::LeadIn);
  const Vec3 end = first.points[first.points.size() - 2].p;
  EXPECT_NEAR((end - second.points[1].p).norm(), 0.0, 1e-12);
  EXPECT_LT(first.points[first.points.size() - 2].speedFactor, 0.6);
  EXPECT_EQ(first.points[2].speedFactor, 1.0);
  const JobContext context;
  EXPECT_EQ(
      edited(path, "pause", R"({"where": "at_length", "length": 999})", zones, context).beadCount(),
      1U);
  EXPECT_EQ(count(context, "edit.selects_nothing"), 1U);
}

TEST(Reverse, TwiceIsNothing) {
  for (const bool closed : {true, false}) {
    const std::string zones = R"({"lead": 8, "lateral_tilt": 5, "lead_in": 2, "overlap": 4})";
    const Toolpath path = stack(2, zones, closed);
    const Toolpath once = edited(path, "reverse", "{}", zones);
    EXPECT_FALSE(same(once, path, 1.0));
    EXPECT_NEAR(lengthOf(once), lengthOf(path), 1e-9);
    EXPECT_TRUE(same(edited(once, "reverse", "{}", zones), path, 1e-12)) << closed;
    expectFrames(once);
  }
}

TEST(Reverse, LeadStaysRelativeToTheTravel) {
  const Toolpath path = stack(1, R"({"lead": 10})");
  const Toolpath once = edited(path, "reverse", "{}", R"({"lead": 10})");
  for (const PathPoint& point : points(once)) {
    EXPECT_NEAR(std::atan2(point.axis.dot(point.t), point.axis.dot(point.up)), degToRad(10.0),
                1e-12);
    EXPECT_NEAR(point.b.z(), 1.0, 1e-12);
  }
}

TEST(Reverse, LateralTiltStaysOutwards) {
  const Toolpath path = stack(1, R"({"lateral_tilt": 10})");
  const Toolpath once = edited(path, "reverse", "{}", R"({"lateral_tilt": 10})");
  for (const Toolpath* of : {&path, &once}) {
    const Bead& bead = of->layers[0].beads[0];
    for (const PathPoint& point : bead.points) {
      EXPECT_NEAR(point.axis.dot(bead.outward(point)), std::sin(degToRad(10.0)), 1e-9);
    }
  }
  EXPECT_NE(path.layers[0].beads[0].back, once.layers[0].beads[0].back);
}

TEST(Reverse, ABeadThatClimbsStays) {
  const SlicedLayers sliced{{layerOf(2.0, {test::helix(kRadius, 2.0, 3.0, 72)})}};
  const Toolpath path = buildToolpath(sliced, *test::plate(), {}, JobContext());
  const JobContext context;
  EXPECT_TRUE(same(edited(path, "reverse", "{}", "{}", context), path, 0.0));
  EXPECT_EQ(count(context, "edit.selects_nothing"), 1U);
}

// --- tool axis

double leadOf(const PathPoint& point) {
  return radToDeg(std::atan2(point.axis.dot(point.t), point.axis.dot(point.up)));
}

TEST(SetLead, AddsAndReplaces) {
  const std::string params = R"({"lead": 10, "lateral_tilt": 4})";
  const Toolpath path = stack(1, params);
  const Toolpath added = edited(path, "set_lead", R"({"angle": 7})", params);
  for (const PathPoint& point : points(added)) {
    EXPECT_NEAR(leadOf(point), 17.0, 1e-9);
  }
  const Toolpath replaced = edited(path, "set_lead", R"({"mode": "replace", "angle": -7})", params);
  const Toolpath wanted = stack(1, R"({"lead": -7, "lateral_tilt": 4})");
  EXPECT_TRUE(same(replaced, wanted, 1e-12));
  EXPECT_TRUE(same(edited(path, "set_lateral", R"({"mode": "replace", "angle": 9})", params),
                   stack(1, R"({"lead": 10, "lateral_tilt": 9})"), 1e-12));
}

TEST(SetLead, FadesOutsideTheRegion) {
  const Toolpath path = stack(1);
  const double whole = lengthOf(path);
  const Toolpath leaned = edited(
      path, "set_lead", R"({"angle": 12, "region": "length", "from": 40, "to": 60, "blend": 8})");
  EXPECT_NEAR(lengthOf(leaned), whole, 1e-9);
  double way = 0.0;
  const auto& all = points(leaned);
  for (std::size_t i = 0; i < all.size(); ++i) {
    way += i > 0 ? (all[i].p - all[i - 1].p).norm() : 0.0;
    const double away = std::max({40.0 - way, way - 60.0, 0.0});
    EXPECT_NEAR(leadOf(all[i]), 12.0 * std::clamp(1.0 - away / 8.0, 0.0, 1.0), 1e-6) << way;
  }
}

TEST(SetLead, IsLimited) {
  const JobContext context;
  const Toolpath leaned =
      edited(stack(1, R"({"lead": 30})"), "set_lead", R"({"angle": 60})", "{}", context);
  EXPECT_NEAR(leadOf(points(leaned)[3]), 80.0, 1e-9);
  EXPECT_EQ(count(context, "edit.tilt_limited"), 1U);
}

// --- selection and bad input

TEST(Edits, RangesAreCountedFromBothEnds) {
  const Toolpath path = stack(5);
  const auto changed = [&](const std::string& params) {
    const Toolpath after = edited(path, "pause", params);
    std::string text;
    for (const Layer& layer : after.layers) {
      text += layer.beads[0].pauseBefore > 0.0 ? '1' : '0';
    }
    return text;
  };
  EXPECT_EQ(changed("{}"), "11111");
  EXPECT_EQ(changed(R"({"first_layer": 1, "last_layer": 2})"), "01100");
  EXPECT_EQ(changed(R"({"first_layer": -2})"), "00011");
  EXPECT_EQ(changed(R"({"first_layer": -5, "last_layer": -4})"), "11000");
  EXPECT_EQ(changed(R"({"first_layer": 3, "last_layer": -4})"), "00000");
  EXPECT_EQ(changed(R"({"first_layer": 3, "last_layer": 99})"), "00011");
  EXPECT_EQ(changed(R"({"bead": 0})"), "11111");
  EXPECT_EQ(changed(R"({"bead": 1})"), "00000");
  const JobContext context;
  (void)edited(path, "pause", R"({"first_layer": 3, "last_layer": 99})", "{}", context);
  EXPECT_EQ(count(context, "edit.range_clipped"), 1U);
}

std::string problemsOf(const std::string& type, const std::string& params) {
  std::string text;
  for (const ParamProblem& problem :
       validateEdit(editTypeOf(type).value(), parseJson(params), "params")) {
    text += problem.path + ": " + problem.message.str() + "\n";
  }
  return text;
}

TEST(Edits, ContradictionsAreProblemsWithAPlace) {
  EXPECT_THAT(problemsOf("reverse", R"({"first_layer": 4, "last_layer": 2})"),
              HasSubstr("params.last_layer: the range ends before it begins"));
  EXPECT_EQ(problemsOf("reverse", R"({"first_layer": 4, "last_layer": -2})"), "");
  EXPECT_THAT(problemsOf("repeat_layers", R"({"count": 0})"), HasSubstr("params.count"));
  EXPECT_THAT(problemsOf("set_speed", R"({"region": "box", "box_min": [0, 0, 0],
                                          "box_max": [1, 0, 1]})"),
              HasSubstr("params.box_max"));
  EXPECT_THAT(problemsOf("set_wire", R"({"region": "half_space", "plane_normal": [0, 0, 0]})"),
              HasSubstr("params.plane_normal"));
  EXPECT_THAT(problemsOf("set_lead", R"({"region": "length", "from": 9, "to": 3})"),
              HasSubstr("params.to"));
  EXPECT_THAT(problemsOf("pause", R"({"time": 0})"), HasSubstr("params.time"));
  EXPECT_THAT(problemsOf("pause", R"({"tiem": 3})"), HasSubstr("tiem"));
  EXPECT_THAT(wcam::testing::errorOf(ErrorCode::InvalidArgument,
                                     [] { (void)edit("pause", R"({"time": -1})"); }),
              HasSubstr("edit 'e'"));
}

TEST(Edits, EmptyPathsAreNoTrouble) {
  for (const EditTypeInfo& info : editTypes()) {
    const JobContext context;
    const Toolpath none = edited({}, info.key, "{}", "{}", context);
    EXPECT_TRUE(none.layers.empty());
    EXPECT_EQ(count(context, "edit.selects_nothing"), 1U) << info.key;
    Toolpath bare;
    bare.layers.resize(2);
    bare.layers[1].beads.resize(1);
    bare.layers[1].beads[0].points.resize(1);
    (void)edited(bare, info.key, "{}");
    bare.layers[1].beads[0].closed = true;
    (void)edited(bare, info.key, R"({"first_layer": 1})");
  }
}

TEST(Edits, TypesAreComplete) {
  for (std::size_t i = 0; i < editTypes().size(); ++i) {
    const EditTypeInfo& info = editTypes()[i];
    EXPECT_EQ(static_cast<std::size_t>(info.type), i);
    EXPECT_EQ(editTypeOf(info.key), info.type);
    EXPECT_TRUE(validateEdit(info.type, Value::object()).empty()) << info.key;
  }
  EXPECT_FALSE(editTypeOf("move_seams"));
}

Diagnostic findingAt(int layer, int bead = -1, int point = -1) {
  return {Severity::Violation, "slicing.open", "open", {}, {{}, layer, bead, point}};
}

std::vector<Place> placesOf(const std::vector<Diagnostic>& findings) {
  std::vector<Place> places;
  for (const Diagnostic& finding : findings) {
    places.push_back(finding.place);
  }
  return places;
}

TEST(EditFindings, FindingsOfDeletedLayersAreGoneAndThoseAboveFollow) {
  const std::vector<Diagnostic> all = {findingAt(-1), findingAt(2, 0, 7), findingAt(3),
                                       findingAt(5, 1), findingAt(6, 0, 4)};
  EXPECT_EQ(placesOf(findingsAfter(
                all, 10, {edit("delete_layers", R"({"first_layer": 3, "last_layer": 5})")})),
            (std::vector<Place>{{}, {{}, 2, 0, 7}, {{}, 3, 0, 4}}));
  // Twice, the second time in the numbers that the first one left.
  EXPECT_EQ(placesOf(findingsAfter(
                all, 10,
                {edit("repeat_layers", R"({"first_layer": 2, "last_layer": 3, "count": 2})"),
                 edit("delete_layers", R"({"first_layer": 0, "last_layer": 2})")})),
            (std::vector<Place>{{}, {{}, 0, -1, -1}, {{}, 6, 1, -1}, {{}, 7, 0, 4}}));
  EXPECT_EQ(placesOf(findingsAfter(all, 10, {edit("delete_layers", R"({"first_layer": -10})")})),
            std::vector<Place>{Place{}});
}

TEST(EditFindings, APlaceInsideABeadIsLeftOpenWhereTheBeadChanges) {
  const std::vector<Diagnostic> all = {findingAt(2, 0, 7), findingAt(4, 1, 7)};
  EXPECT_EQ(
      placesOf(findingsAfter(all, 10, {edit("reverse", R"({"first_layer": 2, "last_layer": 2})")})),
      (std::vector<Place>{{{}, 2, 0, -1}, {{}, 4, 1, 7}}));
  EXPECT_EQ(placesOf(findingsAfter(
                all, 10, {edit("pause", R"({"where": "at_length", "at": 10, "bead": 1})")})),
            (std::vector<Place>{{{}, 2, 0, 7}, {{}, 4, -1, -1}}));
}

TEST(EditFindings, AnEditsOwnFindingsFollowTheEditsAfterIt) {
  const Toolpath path = stack(10);
  const JobContext context;
  // The gap lies below layer 4 (from 0), and the next edit takes two layers below it away.
  applyEdits(path,
             {edit("delete_layers", R"({"first_layer": 4, "last_layer": 7})"),
              edit("delete_layers", R"({"first_layer": 0, "last_layer": 1})")},
             PathParams().zones(), context);
  int gaps = 0;
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == "edit.layer_gap") {
      ++gaps;
      EXPECT_EQ(finding.place.layer, 2);
    }
  }
  EXPECT_EQ(gaps, 1);
}

TEST(EditFindings, LayersInWordsAreCountedFromOne) {
  const JobContext context;
  edited(stack(10), "delete_layers", R"({"first_layer": 7, "last_layer": 20})", "{}", context);
  std::vector<std::string> messages;
  for (const Diagnostic& finding : context.diagnostics().items()) {
    messages.push_back(finding.message.str());
  }
  EXPECT_THAT(messages,
              ::testing::Contains(HasSubstr("layers 8 to 21, of which there are 8 to 10")));
}

TEST(OutsidePlate, OfASpiralOnlyTheFirstRevolutionLiesOnThePlate) {
  // A cone that opens upwards: only its upper revolutions lean over the border of the plate.
  SlicedLayers sliced;
  Contour spiral;
  constexpr int kTurns = 40;
  constexpr int kPerTurn = 60;
  for (int i = 0; i <= kTurns * kPerTurn; ++i) {
    const double turn = static_cast<double>(i) / kPerTurn;
    const double r = 30.0 + 5.0 * turn;
    ContourPoint point;
    point.n = {std::cos(2.0 * kPi * turn), -std::sin(2.0 * kPi * turn), 0.0};
    point.p = r * point.n + geometry::Vec3(0.0, 0.0, 2.0 * (turn + 1.0));
    point.height = 2.0;
    if (i % kPerTurn == 0 && i < kTurns * kPerTurn) {
      spiral.turns.push_back(spiral.points.size());
    }
    spiral.points.push_back(point);
  }
  sliced.layers.push_back(layerOf(2.0, {spiral}));
  const JobContext context;
  buildToolpath(sliced, *test::plate(), PathParams(), context);
  EXPECT_EQ(context.diagnostics().count("toolpath.outside_plate"), 0U);
}

}  // namespace
}  // namespace wcam::toolpath
