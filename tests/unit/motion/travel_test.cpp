// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::circles;
using test::leaningCircles;
using test::shippedCell;

PlannedMotion plan(const toolpath::Toolpath& path, const MotionParams& params = {}) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
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
