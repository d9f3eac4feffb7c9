// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/motion/collisions.hpp"
#include "wcam/motion/explain.hpp"

#include "paths.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

namespace wcam::motion::test {
namespace {

using collision::CellCollision;
using collision::ToolState;
using testing::HasSubstr;

const toolpath::Substrate& plate() {
  static const toolpath::Substrate substrate(geometry::Pose::Identity(), Vec3(200, 200, 10));
  return substrate;
}

void setBead(toolpath::Toolpath& path, double width) {
  for (toolpath::Layer& layer : path.layers) {
    for (toolpath::Bead& bead : layer.beads) {
      for (toolpath::PathPoint& point : bead.points) {
        point.width = width;
      }
    }
  }
}

/// Rings of a dome of radius 45 whose tool axis is the surface's own build direction, from latitude
/// 0 to `top`: a tube that closes, as the end of a joystick (Diourté).
toolpath::Toolpath dome(double top, int layers, int points, bool tangentAxis) {
  constexpr double kRadius = 45.0;
  toolpath::Toolpath path;
  for (int l = 1; l <= layers; ++l) {
    const double latitude = top * l / layers;
    toolpath::Layer layer;
    layer.level = kRadius * latitude;
    toolpath::Bead bead;
    bead.closed = true;
    for (int i = 0; i <= points; ++i) {
      const double a = 2 * kPi * (i % points) / points;
      const Vec3 radial(std::cos(a), std::sin(a), 0);
      toolpath::PathPoint point;
      point.n = std::cos(latitude) * radial + std::sin(latitude) * Vec3::UnitZ();
      point.p = kRadius * point.n;
      point.b = -std::sin(latitude) * radial + std::cos(latitude) * Vec3::UnitZ();
      point.t = Vec3(-std::sin(a), std::cos(a), 0);
      point.up = Vec3::UnitZ();
      point.axis = tangentAxis ? point.b : Vec3::UnitZ();
      point.height = kRadius * top / layers;
      point.width = 4.0;
      point.speed = 10.0;
      point.wireSpeed = 80.0;
      bead.points.push_back(point);
    }
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// The tool of every point, without a robot.
Motion toolMotion(const toolpath::Toolpath& path) {
  Motion motion;
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    const auto& points = path.layers[l].beads[0].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Waypoint waypoint;
      waypoint.layer = static_cast<int>(l);
      waypoint.bead = 0;
      waypoint.point = static_cast<int>(i);
      waypoint.T_part_tcp.linear() = cell::frameWithZ(points[i].axis, 0.0);
      waypoint.T_part_tcp.translation() = points[i].p;
      motion.waypoints.push_back(waypoint);
    }
  }
  return motion;
}

std::vector<float> torchClearance(const CellCollision& collision, const Motion& motion) {
  std::vector<ToolState> tools;
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    tools.push_back({motion.waypoints[i].T_part_tcp, i});
  }
  std::vector<float> clearance(tools.size());
  collision.evaluateTorch(tools, clearance);
  return clearance;
}

std::size_t countBelowZero(const std::vector<float>& values) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](float v) { return v < 0.0F; }));
}

/// Only a straight nozzle of radius 12 from 14 mm on: what the arm does is not looked at.
cell::Cell straightNozzle() {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.shapes = {};
  cell::Shape nozzle;
  nozzle.name = "nozzle";
  nozzle.kind = cell::ShapeKind::Cylinder;
  nozzle.frame = "tcp";
  nozzle.radius = 12.0;
  nozzle.length = 60.0;
  nozzle.T_frame_shape.translation() = Vec3(0, 0, 14.0 + 30.0);
  cell.shapes.torch.push_back(nozzle);
  return cell;
}

MotionParams exitParams() {
  MotionParams params;
  params.exitRotations = true;
  params.exitLateral = Angle(degToRad(60));
  params.exitLead = Angle(degToRad(10));
  params.exitRate = 3.0;
  params.safetyDistance = Length(2.0);
  return params;
}

/// Diourté A38, first half: no collision at a vertical wall.
TEST(ExitRotations, verticalWallNeedsNone) {
  const cell::Cell cell = straightNozzle();
  toolpath::Toolpath path = circles(20, 40.0, 120, Vec3::Zero());
  setBead(path, 5.0);
  collision::CollisionSettings settings;
  settings.safetyDistance = 2.0;
  const CellCollision collision(cell, path, &plate(), settings);
  const Motion motion = toolMotion(path);
  EXPECT_EQ(countBelowZero(torchClearance(collision, motion)), 0U);
  const ExitRotations exits = findExits(motion, path, collision, exitParams(), {}, JobContext());
  EXPECT_FALSE(exits.changed);
}

/// A38, second half, and A40: a part that bends inward collides, after the rotations nothing does;
/// the TCP stays, the tilts are smooth and within their tolerances.
TEST(ExitRotations, partThatBendsInwardIsFreed) {
  const cell::Cell cell = straightNozzle();
  const toolpath::Toolpath path = dome(degToRad(72), 30, 90, true);
  const MotionParams params = exitParams();
  collision::CollisionSettings settings;
  settings.safetyDistance = params.safetyDistance.value();
  const CellCollision collision(cell, path, nullptr, settings);
  const Motion motion = toolMotion(path);
  const std::size_t before = countBelowZero(torchClearance(collision, motion));
  EXPECT_GT(before, 180U);
  ExitRotations exits;
  toolpath::Toolpath turned = path;
  for (int pass = 0; pass < 4; ++pass) {
    exits = findExits(toolMotion(turned), path, collision, params, exits, JobContext());
    if (!exits.changed) {
      break;
    }
    turned = applyExits(path, exits);
  }
  EXPECT_FALSE(exits.changed);
  EXPECT_EQ(exits.unsolved, 0U);
  EXPECT_EQ(countBelowZero(torchClearance(collision, toolMotion(turned))), 0U);
  std::size_t number = 0;
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    const auto& was = path.layers[l].beads[0].points;
    const auto& is = turned.layers[l].beads[0].points;
    for (std::size_t i = 0; i < was.size(); ++i, ++number) {
      EXPECT_EQ(was[i].p, is[i].p);
      EXPECT_EQ(was[i].up, is[i].up);
      EXPECT_NEAR(is[i].axis.norm(), 1.0, 1e-12);
      EXPECT_LE(std::abs(exits.applied[number].lateral), params.exitLateral.value() + 1e-12);
      EXPECT_LE(std::abs(exits.applied[number].lead), params.exitLead.value() + 1e-12);
      if (i > 0) {
        const double step = (was[i].p - was[i - 1].p).norm();
        const double allowed = degToRad(params.exitRate) * step + 1e-9;
        EXPECT_LE(std::abs(exits.applied[number].lateral - exits.applied[number - 1].lateral),
                  allowed);
        EXPECT_LE(std::abs(exits.applied[number].lead - exits.applied[number - 1].lead), allowed);
      }
    }
    // No jump where a closed bead meets itself.
    EXPECT_EQ(exits.applied[number - was.size()].lateral, exits.applied[number - 1].lateral);
  }
}

TEST(ExitRotations, toleranceThatIsTooSmallIsTold) {
  const cell::Cell cell = straightNozzle();
  const toolpath::Toolpath path = dome(degToRad(72), 15, 60, true);
  MotionParams params = exitParams();
  params.exitLateral = Angle(degToRad(3));
  params.exitLead = Angle(0);
  collision::CollisionSettings settings;
  settings.safetyDistance = 2.0;
  const CellCollision collision(cell, path, nullptr, settings);
  const ExitRotations exits =
      findExits(toolMotion(path), path, collision, params, {}, JobContext());
  EXPECT_GT(exits.unsolved, 30U);
}

/// The whole way with the arm: the finding with the tilt that would be needed, then the tilt
/// itself.
TEST(CheckedMotion, reportsTheTiltAndMakesIt) {
  const cell::Cell cell = straightNozzle();
  const toolpath::Toolpath path = dome(degToRad(72), 20, 60, true);
  MotionParams params = exitParams();
  params.exitRotations = false;
  JobContext told;
  const CheckedMotion plain = planCheckedMotion(path, cell, nullptr, params, "op", told);
  ASSERT_TRUE(plain.collisions.checked);
  EXPECT_FALSE(plain.pathChanged);
  ASSERT_GT(plain.collisions.collidingPoints + plain.collisions.nearPoints, 0U);
  // The distance at every waypoint, which colours the path; the worst is the one that is told.
  const std::vector<float>& distance = plain.collisions.distance;
  ASSERT_EQ(distance.size(), plain.planned.motion.waypoints.size());
  const float least = *std::min_element(distance.begin(), distance.end());
  EXPECT_FLOAT_EQ(least, static_cast<float>(plain.collisions.leastDistance));
  EXPECT_GT(*std::max_element(distance.begin(), distance.end()), least + 5.0F);
  bool lateral = false;
  for (const Diagnostic& finding : told.diagnostics().items()) {
    if (finding.code == "motion.collision" || finding.code == "motion.near_collision") {
      EXPECT_THAT(finding.message, HasSubstr("torch nozzle"));
      EXPECT_THAT(finding.message, HasSubstr("the part (layer "));
      for (const auto& [key, value] : finding.data) {
        lateral = lateral || key == "cure_lateral_deg";
      }
    }
  }
  EXPECT_TRUE(lateral);
  params.exitRotations = true;
  JobContext context;
  const CheckedMotion turned = planCheckedMotion(path, cell, nullptr, params, "op", context);
  EXPECT_TRUE(turned.pathChanged);
  EXPECT_GT(turned.collisions.turnedPoints, 0U);
  EXPECT_EQ(turned.collisions.collidingPoints, 0U);
  EXPECT_EQ(turned.collisions.nearPoints, 0U);
  EXPECT_EQ(context.diagnostics().count("motion.collision"), 0U);
  EXPECT_GE(turned.collisions.leastDistance, params.safetyDistance.value() - 1e-3);
}

/// An obstacle in the way of a travel move between two beads is found though no waypoint touches
/// it.
TEST(CheckedMotion, travelMovesAreFollowed) {
  cell::Cell cell = straightNozzle();
  toolpath::Toolpath path = circles(1, 10.0, 24, Vec3(-80, 0, 0));
  path.layers[0].beads.push_back(circles(1, 10.0, 24, Vec3(80, 0, 0)).layers[0].beads[0]);
  setBead(path, 5.0);
  MotionParams params;
  params.safetyDistance = Length(1.0);
  JobContext clear;
  EXPECT_EQ(planCheckedMotion(path, cell, nullptr, params, "op", clear).collisions.collidingPoints,
            0U);
  cell::Shape post;
  post.name = "post";
  post.kind = cell::ShapeKind::Cylinder;
  post.frame = "table";
  post.radius = 15.0;
  post.length = 200.0;
  post.T_frame_shape.translation() = Vec3(0, 0, 100);
  cell.shapes.positioner.push_back(post);
  JobContext context;
  const CheckedMotion found = planCheckedMotion(path, cell, nullptr, params, "op", context);
  EXPECT_GE(found.collisions.collidingPoints, 1U);
  const auto items = context.diagnostics().items();
  const auto hit = std::find_if(items.begin(), items.end(),
                                [](const Diagnostic& d) { return d.code == "motion.collision"; });
  ASSERT_NE(hit, items.end());
  EXPECT_EQ(hit->place.point, -1);
  EXPECT_THAT(hit->message, HasSubstr("positioner post"));
  EXPECT_THAT(hit->message, HasSubstr("travel move"));
}

/// A part that stands in an obstacle from the start is a finding, not a crash.
TEST(CheckedMotion, partInsideAnObstacle) {
  cell::Cell cell = straightNozzle();
  cell::Shape block;
  block.name = "block";
  block.kind = cell::ShapeKind::Box;
  block.frame = "base";
  block.size = Vec3(300, 300, 300);
  block.T_frame_shape.translation() = Vec3(920, 820, -150);
  cell.shapes.obstacles.push_back(block);
  toolpath::Toolpath path = circles(3, 20.0, 24, Vec3::Zero());
  setBead(path, 5.0);
  JobContext context;
  const CheckedMotion found =
      planCheckedMotion(path, cell, &plate(), MotionParams(), "op", context);
  EXPECT_GT(found.collisions.collidingPoints, 0U);
  bool substrate = false;
  for (const Diagnostic& finding : context.diagnostics().items()) {
    substrate = substrate || (finding.code == "motion.collision" &&
                              finding.message.str().find("obstacle block") != std::string::npos);
  }
  EXPECT_TRUE(substrate);
}

TEST(CheckedMotion, switchedOffOrWithoutShapes) {
  cell::Cell cell = straightNozzle();
  const toolpath::Toolpath path = dome(degToRad(60), 5, 40, true);
  MotionParams params;
  params.checkCollisions = false;
  EXPECT_FALSE(
      planCheckedMotion(path, cell, nullptr, params, "op", JobContext()).collisions.checked);
  params.checkCollisions = true;
  cell.shapes = {};
  EXPECT_FALSE(
      planCheckedMotion(path, cell, nullptr, params, "op", JobContext()).collisions.checked);
  EXPECT_FALSE(
      planCheckedMotion(toolpath::Toolpath(), straightNozzle(), nullptr, params, "op", JobContext())
          .pathChanged);
}

TEST(CheckedMotion, cancelIsAnswered) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(planCheckedMotion(dome(1.0, 5, 40, true), straightNozzle(), nullptr, exitParams(),
                                 "op", JobContext(stop.get_token())),
               CancelledError);
}

double figure(const Diagnostic& finding, const std::string& key, double missing) {
  for (const auto& [name, value] : finding.data) {
    if (name == key) {
      return value;
    }
  }
  return missing;
}

/// What the remedy says is done to the cell or the parameters: the violation is gone.
TEST(Explain, theCureCures) {
  MotionParams params;
  params.branch = BranchChoice::Nut;
  const toolpath::Toolpath path = circles(2, 20.0, 24, Vec3::Zero());
  // Far out: the part must come nearer.
  cell::Cell cell = straightNozzle();
  cell.positioner.T_root_first.translation() += Vec3(900, 500, 0);
  JobContext far;
  planCheckedMotion(path, cell, nullptr, params, "op", far);
  const auto items = far.diagnostics().items();
  const auto missing = std::find_if(items.begin(), items.end(), [](const Diagnostic& d) {
    return d.code == "motion.unreachable";
  });
  ASSERT_NE(missing, items.end());
  EXPECT_THAT(missing->remedy, HasSubstr("serves all points tried of this bead"));
  const auto vectorOf = [&](const std::string& frame) {
    return Vec3(figure(*missing, "cure_" + frame + "_x_mm", 0),
                figure(*missing, "cure_" + frame + "_y_mm", 0),
                figure(*missing, "cure_" + frame + "_z_mm", 0));
  };
  EXPECT_GT(vectorOf("base").norm() + vectorOf("table").norm(), 0.0);
  cell.positioner.T_root_first.translation() += vectorOf("base");
  cell.T_table_part.translation() += vectorOf("table");
  JobContext near;
  const CheckedMotion cured = planCheckedMotion(path, cell, nullptr, params, "op", near);
  for (const Waypoint& waypoint : cured.planned.motion.waypoints) {
    if (waypoint.point >= 0) {
      EXPECT_TRUE(waypoint.reachable);
    }
  }
}

TEST(Explain, limitIsCuredByARotationAboutTheTorch) {
  MotionParams params;
  params.mode = RedundancyMode::Constant;  // the search would find the rotation by itself
  params.branch = BranchChoice::Nut;
  const toolpath::Toolpath path = circles(2, 20.0, 24, Vec3::Zero());
  cell::Cell cell = straightNozzle();
  const CheckedMotion free = planCheckedMotion(path, cell, nullptr, params, "op", JobContext());
  double low = 1e9;
  double high = -1e9;
  for (const Waypoint& waypoint : free.planned.motion.waypoints) {
    low = std::min(low, waypoint.joints(3));
    high = std::max(high, waypoint.joints(3));
  }
  // Axis 4 may not come where it would.
  cell.robot.joints[3].min = high + degToRad(8);
  cell.robot.joints[3].max = high + degToRad(120);
  cell::prepareArm(cell);
  JobContext context;
  planCheckedMotion(path, cell, nullptr, params, "op", context);
  const auto items = context.diagnostics().items();
  const auto limit = std::find_if(items.begin(), items.end(), [](const Diagnostic& d) {
    return d.code == "motion.joint_limit";
  });
  ASSERT_NE(limit, items.end()) << low << " " << high;
  EXPECT_THAT(limit->remedy, HasSubstr("rotate the torch about its axis by "));
  params.torchRotation = Angle(degToRad(figure(*limit, "cure_rotation_deg", 0)));
  // Choices begin with the automatic one.
  params.branch = static_cast<BranchChoice>(
      1 + static_cast<int>(figure(*limit, "cure_branch", static_cast<int>(params.branch) - 1)));
  JobContext after;
  planCheckedMotion(path, cell, nullptr, params, "op", after);
  for (const Diagnostic& finding : after.diagnostics().items()) {
    EXPECT_NE(finding.code, "motion.joint_limit") << toLine(finding) << " after " << toLine(*limit);
  }
}

TEST(Explain, nothingHelpsIsSaid) {
  cell::Cell cell = straightNozzle();
  cell.positioner.T_root_first.translation() += Vec3(9000, 0, 0);
  cell.other.reset();
  JobContext context;
  planCheckedMotion(circles(1, 20.0, 12, Vec3::Zero()), cell, nullptr, MotionParams(), "op",
                    context);
  const auto items = context.diagnostics().items();
  ASSERT_FALSE(items.empty());
  EXPECT_THAT(items.front().remedy, HasSubstr("none of these alone puts it right"));
}

}  // namespace
}  // namespace wcam::motion::test
