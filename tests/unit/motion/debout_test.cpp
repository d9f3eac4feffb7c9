// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Debout's machine and tables, end to end: the listing of Annex 7 planned again (AT-29), the speed
// that it allows (AT-42), the times of Tables 3-6 and 3-7 (AT-41, AT-43).

#include "wcam/cell/kinematics.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/motion/speed_law.hpp"

#include "annex_seven.hpp"
#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using wcam::test::AnnexSevenRow;
using wcam::test::kAnnexSeven;
using wcam::test::kAnnexSevenBefore;

/// The thesis' part frame has y along the axis of the table, which is z here.
Vec3 fromThesis(const double (&v)[3]) {
  return {v[2], v[0], v[1]};
}

/// A bead through the rows before the two that are incomplete.
toolpath::Toolpath listedPath(double speed) {
  toolpath::Bead bead;
  for (std::size_t i = 0; i < kAnnexSevenBefore; ++i) {
    toolpath::PathPoint point;
    point.p = fromThesis(kAnnexSeven[i].p);
    point.axis = fromThesis(kAnnexSeven[i].n).normalized();
    point.t = fromThesis(kAnnexSeven[i].t).normalized();
    point.up = Vec3::UnitZ();
    point.speed = speed;
    bead.points.push_back(point);
  }
  toolpath::Toolpath path;
  path.layers.emplace_back();
  path.layers.back().beads.push_back(bead);
  return path;
}

/// AT-29: the tool axis at 30 degrees in the machine, as the listing was made.
TEST(Debout, listingOfAnnexSevenPlannedAgain) {
  const cell::Cell cell = test::shippedCell("debout_7axis");
  MotionParams params;
  params.mode = RedundancyMode::ConstantToolAxis;
  params.tableAngle = Angle(degToRad(30.0));
  params.tiltTolerance = Angle(degToRad(1.0));
  JobContext context;
  const PlannedMotion planned = planMotion(listedPath(50.0), cell, params, "op", context);
  std::size_t points = 0;
  for (const Waypoint& w : planned.motion.waypoints) {
    ASSERT_TRUE(w.reachable);
    if (w.point < 0) {
      continue;
    }
    const AnnexSevenRow& row = kAnnexSeven[static_cast<std::size_t>(w.point)];
    EXPECT_NEAR(w.joints(0) - wcam::test::kAnnexSevenX, row.x, 0.25);
    EXPECT_NEAR(w.joints(1), row.y, 0.25);
    EXPECT_NEAR(w.joints(2) - wcam::test::kAnnexSevenZ, row.z, 0.25);
    EXPECT_NEAR(radToDeg(w.joints(3)), row.c1, 0.02);
    EXPECT_NEAR(radToDeg(w.joints(4)), row.a, 0.02);
    // The listing counts B the other way.
    EXPECT_NEAR(radToDeg(w.joints(6)), -row.b, 0.02);
    ++points;
  }
  EXPECT_EQ(points, kAnnexSevenBefore);
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
}

/// AT-42: max |dB/ds| = 0.0446 deg/mm: B holds the torch at 942 mm/s; C1 alone would allow 2.7 m/s.
TEST(Debout, theTableBoundsTheSpeedOfTheListing) {
  cell::Cell cell = test::shippedCell("debout_7axis");
  for (cell::Chain* chain : {&cell.robot, &cell.positioner}) {
    for (cell::Joint& joint : chain->joints) {
      joint.maxAcceleration = joint.maxJerk = std::numeric_limits<double>::infinity();
    }
  }
  Motion motion;
  for (std::size_t i = 0; i < kAnnexSevenBefore; ++i) {
    const AnnexSevenRow& row = kAnnexSeven[i];
    Waypoint w;
    w.layer = w.bead = 0;
    w.point = static_cast<int>(i);
    w.arc = i > 0;
    w.joints.resize(7);
    w.joints << row.x + wcam::test::kAnnexSevenX, row.y, row.z + wcam::test::kAnnexSevenZ,
        degToRad(row.c1), degToRad(row.a), degToRad(row.c2), degToRad(-row.b);
    w.T_part_tcp = cell::T_part_tcp(cell, w.joints);
    w.speed = 1e5;
    motion.waypoints.push_back(w);
  }
  const auto slowest = [&](const cell::Cell& machine) {
    Motion timed = motion;
    applyTimeLaw(timed, machine, {}, 0.3);
    double least = std::numeric_limits<double>::infinity();
    for (const Waypoint& w : timed.waypoints) {
      least = w.arc ? std::min(least, w.tcpSpeed) : least;
    }
    return least;
  };
  EXPECT_NEAR(slowest(cell), 942.0, 2.0);
  cell::Cell without = cell;
  without.positioner.joints[0].maxSpeed = 1e3;
  for (const std::size_t j : {0U, 1U, 2U, 4U, 5U}) {
    without.robot.joints[j].maxSpeed = 1e6;
  }
  EXPECT_NEAR(slowest(without), 2700.0, 30.0);
}

/// Table 3-6: dry times of four plies in s, and Table 3-7: what each way of smoothing gains in %.
/// Columns 43, 104 after the update, 104 on the base surface, 122, 135.
struct DryRun {
  double times[5];
  double gains[5];
  double allPlies;
};

// clang-format off
constexpr DryRun kInterpreter[] = {
    {{11.190, 16.004, 7.463, 14.375, 16.761}, {0, 0, 0, 0, 0}, 0},
    {{7.819, 9.618, 9.055, 9.042, 8.647}, {30.125, 39.903, -21.332, 37.099, 48.410}, 39.781},
    {{7.727, 9.655, 8.990, 8.963, 8.669}, {30.947, 39.671, -20.461, 37.649, 48.279}, 39.973},
    {{10.080, 10.563, 7.499, 10.727, 11.472}, {9.920, 33.998, -0.482, 25.377, 31.555}, 26.552},
    {{6.367, 8.503, 7.499, 8.124, 7.570}, {43.101, 46.870, -0.482, 43.485, 54.836}, 47.602},
    {{6.353, 8.550, 7.503, 8.096, 7.678}, {43.226, 46.576, -0.536, 43.680, 54.191}, 47.408},
    {{8.253, 8.535, 7.519, 8.806, 7.591}, {26.247, 46.670, -0.750, 38.741, 54.710}, 43.108},
    {{9.968, 9.406, 7.514, 8.482, 8.867}, {10.920, 41.227, -0.683, 40.995, 47.097}, 37.043},
    {{6.386, 8.480, 7.488, 8.113, 7.580}, {42.931, 47.013, -0.335, 43.562, 54.776}, 47.610},
    {{6.190, 8.554, 7.534, 8.189, 7.568}, {44.683, 46.551, -0.951, 43.033, 54.848}, 47.710},
    {{7.196, 8.495, 7.497, 8.193, 7.588}, {35.693, 46.920, -0.456, 43.005, 54.728}, 46.045},
    {{9.801, 9.505, 7.517, 8.920, 7.667}, {12.413, 40.609, -0.724, 37.948, 54.257}, 38.466}};

// clang-format on

/// AT-43, and AT-41 on every run: the gains follow from the times, and no gain is larger than the
/// machine's law allows on the length of the ply (at 60 m/min, Table 3-6: 5620, 2994, 6189 and
/// 5539 mm).
TEST(Debout, gainsOfTableThreeSevenAreWithinTheLaw) {
  const double lengths[5] = {2994, 5620, 5623, 6189, 5539};
  const cell::Cell cell = test::shippedCell("debout_5axis");
  const JointBounds x{cell.joint(0).maxSpeed, cell.joint(0).maxAcceleration, cell.joint(0).maxJerk};
  EXPECT_EQ(x.speed, 1000.0);
  const DryRun& initial = kInterpreter[0];
  const auto plies = [](const DryRun& run) {
    return run.times[0] + run.times[1] + run.times[3] + run.times[4];
  };
  for (const DryRun& run : kInterpreter) {
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(100.0 * (1.0 - run.times[k] / initial.times[k]), run.gains[k], 6e-4);
      const double least = restToRest(lengths[k], x);
      EXPECT_LT(run.gains[k], 100.0 * (1.0 - least / initial.times[k]));
    }
    EXPECT_NEAR(100.0 * (1.0 - plies(run) / plies(initial)), run.allPlies, 6e-4);
  }
}

}  // namespace
}  // namespace wcam::motion
