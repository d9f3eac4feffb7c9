// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Long paths: searched on some of their targets, long operations on some of their beads.

#include "coarse_targets.hpp"

#include "wcam/cell/kinematics.hpp"

#include "paths.hpp"
#include "random_source.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {
namespace {

using test::circles;
using test::leaningCircles;
using test::shippedCell;

Task taskOf(const cell::Cell& cell, const MotionParams& params, std::vector<Target> targets) {
  Runs runs = findRuns(targets);
  std::vector<Positioning> aligned = {positionPart(cell, targets, 0, JobContext())};
  return {cell, params, std::move(targets), std::move(runs), aligned, aligned};
}

Resolution pick(const Resolution& all, const std::vector<std::size_t>& kept) {
  Resolution some;
  some.branches = all.branches;
  for (const std::size_t i : kept) {
    some.choices.push_back(all.choices[i]);
  }
  return some;
}

/// The rotation of the tool in the base, at free choices.
Eigen::Matrix3d toolInBase(const Task& task, std::size_t i, const FreeChoice& choice) {
  Pose T_part_tcp;
  const Pose flange = flangePose(task.cell, task.targets[i], choice, &T_part_tcp);
  return flange.linear();
}

double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return std::abs(Eigen::AngleAxisd(a.transpose() * b).angle());
}

TEST(CoarseTargets, ShortPathsKeepAllOfTheirTargets) {
  const std::vector<Target> targets =
      makeTargets(circles(3, 40.0, 200, Vec3::Zero()), MotionParams(), JobContext());
  EXPECT_TRUE(coarseTargets(targets).empty());
  EXPECT_TRUE(coarseTargets(targets, targets.size()).empty());
}

TEST(CoarseTargets, KeepEndsTravelAndBends) {
  const toolpath::Toolpath path = circles(4, 40.0, 3600, Vec3::Zero());
  const std::vector<Target> targets = makeTargets(path, MotionParams(), JobContext());
  const std::vector<std::size_t> kept = coarseTargets(targets, 400);
  ASSERT_FALSE(kept.empty());
  // The direction of travel turns by 6 degrees at most: 60 of 3600 points in each circle.
  EXPECT_GE(kept.size(), 4U * 60);
  EXPECT_LE(kept.size(), 4U * 110);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const WantedMove& move = targets[i].waypoint;
    const bool end = move.point <= 0 || move.point == 3600;
    EXPECT_TRUE(!end || std::binary_search(kept.begin(), kept.end(), i)) << i;
  }
  for (std::size_t k = 1; k < kept.size(); ++k) {
    const Target& a = targets[kept[k - 1]];
    const Target& b = targets[kept[k]];
    if (a.waypoint.point >= 0 && b.waypoint.point >= 0 && a.waypoint.bead == b.waypoint.bead &&
        a.waypoint.layer == b.waypoint.layer) {
      EXPECT_LE(std::acos(std::min(1.0, a.along.dot(b.along))), degToRad(6.1));
    }
  }
}

TEST(CoarseTargets, ChoicesBetweenFollowSmoothOnes) {
  for (const char* name : {"fanuc_arcmate120ic", "fanuc_arcmate120ic_part_carried"}) {
    const cell::Cell cell = shippedCell(name);
    testing::RandomSource random(20261201);
    for (int run = 0; run < 5; ++run) {
      const MotionParams params;
      const Task task = taskOf(
          cell, params,
          makeTargets(leaningCircles(3, random.real(20.0, 60.0), 2000, random.real(0.0, 8.0)),
                      params, JobContext()));
      // Smooth courses of everything that is free.
      const double turns = random.real(-1.0, 1.0);
      const double lean = random.real(0.0, 0.2);
      Resolution all;
      for (const Target& target : task.targets) {
        const double s = std::max(0, target.waypoint.point) / 2000.0;
        FreeChoice choice;
        choice.torchRotation = 0.3 + turns * std::sin(2.0 * kPi * s);
        choice.positioner = {0.1 * std::sin(4.0 * s), 0.2 * s};
        choice.lead = lean * std::cos(3.0 * s);
        choice.lateral = lean * s * s;
        all.choices.push_back(choice);
      }
      all.branches.assign(task.runs.count(), 0);
      const std::vector<std::size_t> kept = coarseTargets(task.targets, 600);
      ASSERT_FALSE(kept.empty());
      const Resolution spread = spreadOverTargets(task, kept, pick(all, kept), JobContext());
      ASSERT_EQ(spread.choices.size(), all.choices.size());
      double worst = 0.0;
      for (std::size_t i = 0; i < all.choices.size(); ++i) {
        worst = std::max(worst, angleBetween(toolInBase(task, i, spread.choices[i]),
                                             toolInBase(task, i, all.choices[i])));
      }
      EXPECT_LT(radToDeg(worst), 0.1) << name << ", seed " << random.seed() << ", run " << run;
    }
  }
}

TEST(CoarseTargets, FramesTurnEvenlyWhereTheFreeAngleJumps) {
  // A horizontal torch that swings past the X axis of the base: equal frames have far angles.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  toolpath::Toolpath path;
  path.layers.emplace_back();
  toolpath::Bead bead;
  for (int i = 0; i <= 3000; ++i) {
    const double swing = degToRad(-15.0 + 30.0 * i / 3000.0);
    toolpath::PathPoint point;
    point.p = Vec3(0, 0.02 * i, 100);
    point.t = Vec3::UnitY();
    point.axis = Vec3(std::cos(swing), std::sin(swing), 0.004);
    point.axis.normalize();
    point.up = Vec3::UnitZ();
    point.speed = 5.0;
    bead.points.push_back(point);
  }
  path.layers[0].beads.push_back(bead);
  const MotionParams params;
  const Task task = taskOf(cell, params, makeTargets(path, params, JobContext()));
  const std::vector<std::size_t> kept = coarseTargets(task.targets, 100);
  ASSERT_FALSE(kept.empty());
  // Choices of the kept ones: the tool's x is as near to the vertical as it can be.
  Resolution coarse;
  for (const std::size_t i : kept) {
    FreeChoice best;
    double height = -2.0;
    for (int k = 0; k < 3600; ++k) {
      FreeChoice choice;
      choice.torchRotation = degToRad(0.1 * k);
      Pose T_part_tcp;
      flangePose(cell, task.targets[i], choice, &T_part_tcp);
      const double own = T_part_tcp.linear()(2, 0);
      if (own > height) {
        height = own;
        best = choice;
      }
    }
    coarse.choices.push_back(best);
  }
  coarse.branches.assign(task.runs.count(), 0);
  const Resolution spread = spreadOverTargets(task, kept, coarse, JobContext());
  double worst = 0.0;
  for (std::size_t i = 1; i < spread.choices.size(); ++i) {
    worst = std::max(worst, angleBetween(toolInBase(task, i - 1, spread.choices[i - 1]),
                                         toolInBase(task, i, spread.choices[i])));
  }
  // 30 degrees over 3000 points, and the tenths of a degree of the scan.
  EXPECT_LT(radToDeg(worst), 0.15);
}

TEST(CoarseTargets, SampledBeadsAreWhole) {
  const std::vector<Target> targets =
      makeTargets(circles(50, 10.0, 12, Vec3::Zero()), MotionParams(), JobContext());
  const Runs runs = findRuns(targets);
  const std::vector<std::size_t> sampled = sampledBeads(runs, 10);
  ASSERT_EQ(sampled.size(), targets.size() / 5);
  for (std::size_t k = 0; k < sampled.size(); ++k) {
    EXPECT_EQ(targets[sampled[k]].waypoint.layer % 5, 0);
  }
}

TEST(CoarseTargets, ALongPathMovesAsAShortOneDoes) {
  // The same circles in points so fine that only some are searched, and in a thirtieth of them.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.checkCollisions = false;
  const PlannedMotion fine =
      planMotion(circles(2, 60.0, 40000, Vec3::Zero()), cell, params, "fine", JobContext());
  const PlannedMotion rough =
      planMotion(circles(2, 60.0, 1350, Vec3::Zero()), cell, params, "rough", JobContext());
  ASSERT_GT(fine.motion.waypoints.size(), kSearchedTargets);
  ASSERT_LT(rough.motion.waypoints.size(), kSearchedTargets);
  EXPECT_EQ(fine.statistics.unreachableWaypoints, 0U);
  EXPECT_TRUE(fine.statistics.evaluation.feasible());
  EXPECT_EQ(fine.statistics.branch, rough.statistics.branch);
  EXPECT_NEAR(fine.statistics.totalTime, rough.statistics.totalTime,
              0.01 * rough.statistics.totalTime);
  params.mode = RedundancyMode::Constant;
  const PlannedMotion constant =
      planMotion(circles(2, 60.0, 40000, Vec3::Zero()), cell, params, "fine", JobContext());
  EXPECT_TRUE(fine.statistics.evaluation.betterThan(constant.statistics.evaluation));
  // No joint jumps between neighbours: 0.009 mm of path.
  double step = 0.0;
  for (std::size_t i = 1; i < fine.motion.waypoints.size(); ++i) {
    const Waypoint& from = fine.motion.waypoints[i - 1];
    const Waypoint& to = fine.motion.waypoints[i];
    if (from.point >= 0 && to.point >= 0 && from.layer == to.layer) {
      step = std::max(step, (to.joints - from.joints).cwiseAbs().maxCoeff());
      const Vec3 at = cell::T_part_tcp(cell, to.joints).translation();
      ASSERT_LT((at - to.T_part_tcp.translation()).norm(), 1e-6);
    }
  }
  EXPECT_LT(radToDeg(step), 0.05);
}

}  // namespace
}  // namespace wcam::motion::detail
