// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/placement.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <stop_token>

namespace wcam::motion::test {
namespace {

PlacementSearch coarse() {
  PlacementSearch search;
  search.rangeX = search.rangeY = 400.0;
  search.step = 200.0;
  search.turnStep = degToRad(90.0);
  search.refinements = 1;
  search.samples = 12;
  search.rotationStep = degToRad(60.0);
  return search;
}

/// The cell with its part far off on the table.
cell::Cell farOff() {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.positioner.joints.clear();  // a fixed table: the part cannot turn to the robot
  cell.positioner.T_last_tip.translation().z() += 149.631;
  cell.T_table_part.translation() = Vec3(900, 500, 0);
  cell.T_table_part.linear().setIdentity();
  return cell;
}

TEST(Placement, findsAFeasiblePlaceThatPlanningConfirms) {
  const toolpath::Toolpath path = circles(3, 30.0, 36, Vec3::Zero());
  cell::Cell cell = farOff();
  cell.shapes = {};
  const PlacementMap map =
      searchPlacement(path, cell, nullptr, MotionParams(), coarse(), JobContext());
  EXPECT_GE(map.places.size(), 100U);
  const PartPlace& best = map.places[map.best];
  EXPECT_GT(map.places.front().failing, 0U);
  EXPECT_EQ(best.failing, 0U);
  EXPECT_GT(best.score, 0.0);
  for (const PartPlace& place : map.places) {
    EXPECT_FALSE(place.betterThan(best));
  }
  cell.T_table_part = cell.T_table_part * best.pose();
  MotionParams params;
  params.torchRotation = Angle(best.torchRotation);
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, params, "op", context);
  for (const Waypoint& waypoint : planned.motion.waypoints) {
    if (waypoint.point >= 0) {
      EXPECT_TRUE(waypoint.reachable);
    }
  }
}

/// What stands in the way of a place is seen there.
TEST(Placement, collisionsCount) {
  const toolpath::Toolpath path = circles(2, 20.0, 24, Vec3::Zero());
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell::Shape post;
  post.name = "post";
  post.kind = cell::ShapeKind::Cylinder;
  post.frame = "table";
  post.radius = 30.0;
  post.length = 300.0;
  post.T_frame_shape.translation() = Vec3(0, 0, 150);
  cell.shapes.positioner.push_back(post);
  const collision::CellCollision collision(cell, path, nullptr, collision::CollisionSettings());
  const PlacementMap map =
      searchPlacement(path, cell, &collision, MotionParams(), coarse(), JobContext());
  EXPECT_GT(map.places.front().failing, 0U);
  EXPECT_LT(map.places.front().clearance, 0.0);
  EXPECT_EQ(map.places[map.best].failing, 0U);
  EXPECT_GE(map.places[map.best].clearance, 0.0);
  EXPECT_GT(map.places[map.best].move.norm(), 50.0);
}

TEST(Placement, sameOnAnyNumberOfThreads) {
  const toolpath::Toolpath path = circles(2, 20.0, 24, Vec3::Zero());
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  std::vector<PlacementMap> maps;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const collision::CellCollision collision(cell, path, nullptr, collision::CollisionSettings());
    maps.push_back(searchPlacement(path, cell, &collision, MotionParams(), coarse(), JobContext()));
  }
  ASSERT_EQ(maps[0].places.size(), maps[1].places.size());
  EXPECT_EQ(maps[0].best, maps[1].best);
  for (std::size_t i = 0; i < maps[0].places.size(); ++i) {
    EXPECT_EQ(maps[0].places[i].score, maps[1].places[i].score);
    EXPECT_EQ(maps[0].places[i].clearance, maps[1].places[i].clearance);
  }
}

TEST(Placement, badSearchesAndCancel) {
  const toolpath::Toolpath path = circles(1, 20.0, 24, Vec3::Zero());
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  PlacementSearch search = coarse();
  search.step = 0.0;
  EXPECT_THROW(searchPlacement(path, cell, nullptr, MotionParams(), search, JobContext()), Error);
  EXPECT_EQ(
      searchPlacement(toolpath::Toolpath(), cell, nullptr, MotionParams(), coarse(), JobContext())
          .places.size(),
      1U);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      searchPlacement(path, cell, nullptr, MotionParams(), coarse(), JobContext(stop.get_token())),
      CancelledError);
}

}  // namespace
}  // namespace wcam::motion::test
