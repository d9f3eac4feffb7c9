// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::circles;
using test::leaningCircles;
using test::shippedCell;

/// Where the torch goes does not depend on how the redundancy is resolved.
PlannedMotion plan(const toolpath::Toolpath& path, MotionParams params = {}) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  params.mode = RedundancyMode::Constant;
  return planMotion(path, cell, params, "op", JobContext());
}

TEST(Travel, sequenceOfABead) {
  const toolpath::Toolpath path = circles(2, 40, 12, Vec3::Zero());
  const auto& points = plan(path).motion.waypoints;
  ASSERT_EQ(points.size(), 2U * (13 + 4));
  for (std::size_t bead = 0; bead < 2; ++bead) {
    const Waypoint* w = &points[bead * 17];
    EXPECT_EQ(w[0].kind, MoveKind::Joint);
    EXPECT_EQ(w[0].point, -1);
    EXPECT_EQ(w[1].point, -1);
    EXPECT_EQ(w[2].point, 0);
    EXPECT_FALSE(w[2].arc);
    EXPECT_TRUE(w[3].arc);
    EXPECT_EQ(w[3].wireSpeed, 80.0);
    EXPECT_EQ(w[14].point, 12);
    EXPECT_TRUE(w[14].arc);
    EXPECT_FALSE(w[15].arc);
    EXPECT_EQ(w[15].point, -1);
    EXPECT_EQ(w[16].point, -1);
    for (int i = 0; i < 17; ++i) {
      EXPECT_EQ(w[i].layer, static_cast<int>(bead));
      EXPECT_EQ(w[i].bead, 0);
      EXPECT_EQ(w[i].kind, i == 0 ? MoveKind::Joint : MoveKind::Linear);
    }
    // A closed bead ends where it started.
    EXPECT_LE((w[14].T_part_tcp.matrix() - w[2].T_part_tcp.matrix()).norm(), 1e-12);
  }
}

TEST(Travel, heights) {
  MotionParams params;
  params.approachHeight = Length(15);
  params.safeHeight = Length(60);
  const toolpath::Toolpath path = circles(3, 40, 12, Vec3::Zero());
  const auto& points = plan(path, params).motion.waypoints;
  const auto z = [&points](std::size_t i) { return points[i].T_part_tcp.translation().z(); };
  for (std::size_t bead = 0; bead < 3; ++bead) {
    const double level = 2.0 * (static_cast<double>(bead) + 1);
    const std::size_t at = bead * 17;
    EXPECT_NEAR(z(at), level + 60, 1e-9);  // above everything, which is the layer itself
    EXPECT_NEAR(z(at + 1), level + 15, 1e-9);
    EXPECT_NEAR(z(at + 15), level + 15, 1e-9);
    EXPECT_NEAR(z(at + 16), level + 60, 1e-9);
  }
}

TEST(Travel, clearsHigherPartsDepositedBefore) {
  // A tower first, then a low ring beside it: travel to the ring passes above the tower.
  toolpath::Toolpath path = circles(20, 10, 12, Vec3(-60, 0, 0));
  path.layers.push_back(circles(1, 10, 12, Vec3(60, 0, 0)).layers[0]);
  const auto& points = plan(path).motion.waypoints;
  const Waypoint& above = points[20 * 17];
  EXPECT_EQ(above.layer, 20);
  EXPECT_NEAR(above.T_part_tcp.translation().z(), 40.0 + 50.0, 1e-9);
}

TEST(Travel, safeHeightAlongALeaningBuildDirection) {
  const toolpath::Toolpath path = leaningCircles(10, 20, 24, 8.0);
  const auto& points = plan(path).motion.waypoints;
  double worst = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].kind != MoveKind::Joint || points[i].layer == 0) {
      continue;
    }
    const auto& layer = path.layers[static_cast<std::size_t>(points[i].layer)];
    const Vec3 up = layer.beads[0].points[0].up;
    double top = -1e9;
    for (int l = 0; l < points[i].layer; ++l) {
      for (const auto& p : path.layers[static_cast<std::size_t>(l)].beads[0].points) {
        top = std::max(top, p.p.dot(up));
      }
    }
    worst = std::min(worst, points[i].T_part_tcp.translation().dot(up) - top);
  }
  EXPECT_GE(worst, 50.0 - 1e-9);
}

toolpath::Toolpath twoIslands(int towerLayers) {
  toolpath::Toolpath path = circles(1, 10, 12, Vec3(-40, 0, 0));
  path.layers[0].beads.push_back(circles(1, 10, 12, Vec3(40, 0, 0)).layers[0].beads[0]);
  // A tower between them, deposited before.
  toolpath::Toolpath whole = circles(towerLayers, 5, 12, Vec3(0, 0, 0));
  whole.layers.push_back(path.layers[0]);
  return whole;
}

TEST(Travel, directLinksWhereTheyAreClear) {
  MotionParams params;
  params.link = LinkMode::Direct;
  const toolpath::Toolpath path = twoIslands(2);
  const auto& points = plan(path, params).motion.waypoints;
  std::size_t joints = 0;
  for (const Waypoint& point : points) {
    joints += point.kind == MoveKind::Joint ? 1U : 0U;
    if (point.point < 0 && point.kind == MoveKind::Linear) {
      EXPECT_FALSE(point.arc);
      EXPECT_EQ(point.speed, params.travelSpeed.value());
    }
  }
  EXPECT_EQ(joints, 1U);  // the way to the first bead
  // Every bead still begins and ends above itself.
  EXPECT_EQ(points.size(), 4U * (13 + 2) + 2);
}

TEST(Travel, directLinksGoOverWhatStandsInTheWay) {
  MotionParams params;
  params.link = LinkMode::Direct;
  // 30 mm of tower: higher than the approach height of 20 mm above the first layer beside it.
  const auto points = plan(twoIslands(15), params).motion.waypoints;
  const auto last = std::find_if(points.rbegin(), points.rend(), [](const Waypoint& point) {
    return point.kind == MoveKind::Joint;
  });
  ASSERT_NE(last, points.rend());
  EXPECT_EQ(last->layer, 15);
  EXPECT_EQ(last->bead, 1);
  EXPECT_NEAR(last->T_part_tcp.translation().z(), 30.0 + params.safeHeight.value(), 1e-9);
  // A slim torch passes beside a tower that is not on its line.
  params.torchRadius = Length(1.0);
  toolpath::Toolpath beside = twoIslands(15);
  for (int l = 0; l < 15; ++l) {
    for (toolpath::PathPoint& point : beside.layers[static_cast<std::size_t>(l)].beads[0].points) {
      point.p.y() += 25.0;
    }
  }
  const auto past = plan(beside, params).motion.waypoints;
  const Waypoint& link = past[past.size() - 16];
  EXPECT_EQ(link.kind, MoveKind::Linear);
  EXPECT_EQ(link.bead, 1);
  params.torchRadius = Length(30.0);
  const auto over = plan(beside, params).motion.waypoints;
  EXPECT_EQ(over[over.size() - 17].kind, MoveKind::Joint);
}

TEST(Travel, directLinksKeepOutOfTheDepositInRandomScenes) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-80.0, 80.0);
  std::uniform_int_distribution<int> height(1, 12);
  MotionParams params;
  params.link = LinkMode::Direct;
  params.torchRadius = Length(15.0);
  toolpath::Toolpath path;
  for (int i = 0; i < 12; ++i) {
    for (const toolpath::Layer& layer :
         circles(height(random), 6, 12, Vec3(place(random), place(random), 0)).layers) {
      path.layers.push_back(layer);
    }
  }
  const auto points = plan(path, params).motion.waypoints;
  std::size_t direct = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool changesBead = points[i].layer != points[i - 1].layer;
    if (!changesBead || points[i].kind == MoveKind::Joint) {
      continue;
    }
    ++direct;
    const Vec3 a = points[i - 1].T_part_tcp.translation();
    const Vec3 b = points[i].T_part_tcp.translation();
    for (int s = 0; s <= 100; ++s) {
      const Vec3 at = a + (b - a) * s / 100.0;
      for (int l = 0; l < points[i].layer; ++l) {
        for (const auto& point : path.layers[static_cast<std::size_t>(l)].beads[0].points) {
          const double beside = std::hypot(point.p.x() - at.x(), point.p.y() - at.y());
          EXPECT_TRUE(beside > 15.0 || point.p.z() <= at.z() - params.linkClearance.value() + 1e-9)
              << "seed " << kSeed;
        }
      }
    }
  }
  EXPECT_GT(direct, 20U);
}

TEST(Travel, jointMovesTakeTheirShareOfTheSpeed) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  toolpath::Toolpath path = circles(1, 10, 12, Vec3(-60, 0, 0));
  path.layers.push_back(circles(1, 10, 12, Vec3(60, 0, 0)).layers[0]);
  MotionParams params;
  params.jointSpeedRatio = 0.2;
  const auto& points = planMotion(path, cell, params, "op", JobContext()).motion.waypoints;
  const Waypoint& from = points[16];
  const Waypoint& to = points[17];
  double ratio = 0.0;
  for (int j = 0; j < cell.jointCount(); ++j) {
    ratio = std::max(ratio, std::abs(to.joints(j) - from.joints(j)) / (to.time - from.time) /
                                cell.joint(j).maxSpeed);
  }
  EXPECT_NEAR(ratio, 0.2, 1e-12);
}

}  // namespace
}  // namespace wcam::motion
