// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_reference.hpp"

#include "wcam/cell/unwrap.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wcam::motion::detail {
namespace {

using test::shippedCell;

/// The build direction passes the table's axis at a distance (degrees), from `reach` degrees before
/// to as far behind it, with a speed in degrees per second.
toolpath::Bead passage(double distance, double speed, double reach) {
  toolpath::Bead bead;
  for (double x = -reach; x <= reach; x += 1.0) {
    const double lean = degToRad(std::hypot(x, distance));
    const double azimuth = std::atan2(distance, x);
    toolpath::PathPoint point;
    point.p = Vec3(x, 0, 50);
    point.t = Vec3::UnitX();
    point.up = Vec3(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                    std::cos(lean));
    point.axis = point.up;
    point.b = point.up;
    point.speed = speed;  // 1 mm per degree
    bead.points.push_back(point);
  }
  return bead;
}

/// References with what they are made from.
struct Planned {
  Planned(const cell::Cell& ofCell, const std::vector<toolpath::Bead>& beads) : cell(ofCell) {
    toolpath::Toolpath path;
    for (const toolpath::Bead& bead : beads) {
      path.layers.emplace_back();
      path.layers.back().beads.push_back(bead);
    }
    targets = makeTargets(path, params, JobContext());
    runs = findRuns(targets);
    aligned = positionPart(cell, targets, 0, JobContext());
    references = slowerReferences(cell, params, targets, runs, aligned, JobContext());
  }

  /// Greatest speed of an axis on beads over what it can do.
  [[nodiscard]] double speedRatio(const Positioning& reference, int axis) const {
    double ratio = 0.0;
    const auto k = static_cast<std::size_t>(axis);
    for (const Segment& segment : runs.segments) {
      for (std::size_t i = segment.first + 1; i <= segment.last; ++i) {
        const double time = (targets[i].p - targets[i - 1].p).norm() / targets[i].waypoint.speed;
        const double step = std::abs(reference.joints[i][k] - reference.joints[i - 1][k]);
        ratio = std::max(ratio, step / (cell.joint(cell.robotJoints() + axis).maxSpeed * time));
      }
    }
    return ratio;
  }

  [[nodiscard]] double lean(const Positioning& reference, std::size_t target) const {
    return verticalError(cell, targets[target].up, reference.joints[target]);
  }

  [[nodiscard]] double greatestLean(const Positioning& reference) const {
    double greatest = 0.0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      greatest = std::max(greatest, lean(reference, i));
    }
    return greatest;
  }

  [[nodiscard]] double excess(const Positioning& reference) const {
    double sum = 0.0;
    for (const PositionerValues& values : reference.joints) {
      for (int j = 0; j < 2; ++j) {
        sum += cell::limitExcess(cell.joint(cell.robotJoints() + j),
                                 values[static_cast<std::size_t>(j)]);
      }
    }
    return sum;
  }

  cell::Cell cell;
  MotionParams params;
  std::vector<Target> targets;
  Runs runs;
  Positioning aligned;
  std::vector<Positioning> references;
};

constexpr char kCell[] = "fanuc_arcmate120ic";

TEST(TableReference, LeadsStraightThroughTheAxis) {
  const Planned planned(shippedCell(kCell), {passage(0.5, 20.0, 20.0)});
  EXPECT_GT(planned.speedRatio(planned.aligned, 1), 3.0);
  ASSERT_EQ(planned.references.size(), 2U);
  for (const Positioning& reference : planned.references) {
    EXPECT_LE(planned.speedRatio(reference, 0), 0.8);
    EXPECT_LT(planned.speedRatio(reference, 1), 0.1);
    EXPECT_LE(planned.greatestLean(reference), degToRad(1.0));
    const Segment& segment = planned.runs.segments[0];
    EXPECT_LT(reference.joints[segment.first][0] * reference.joints[segment.last][0], 0.0);
  }
  // A half turn apart: tilted to the one and to the other side.
  const std::size_t first = planned.runs.segments[0].first;
  EXPECT_LT(planned.references[0].joints[first][0] * planned.references[1].joints[first][0], 0.0);
}

TEST(TableReference, EasesAPassageBesideTheAxis) {
  const Planned planned(shippedCell(kCell), {passage(5.0, 10.0, 40.0)});
  EXPECT_GT(planned.speedRatio(planned.aligned, 1), 0.85);
  ASSERT_EQ(planned.references.size(), 2U);
  for (const Positioning& reference : planned.references) {
    EXPECT_LE(planned.speedRatio(reference, 1), 0.8 + 1e-9);
    EXPECT_LE(planned.greatestLean(reference), degToRad(1.0));
    EXPECT_GT(planned.greatestLean(reference), degToRad(0.1));
    // Exact far from it.
    EXPECT_LT(planned.lean(reference, planned.runs.segments[0].first), 1e-9);
    EXPECT_LT(planned.lean(reference, planned.runs.segments[0].last), 1e-9);
  }
}

TEST(TableReference, TakesTheLeastGreatestSpeedWhereNoneSuffices) {
  // Twice too fast even a degree further out: v/(d + tolerance) at the nearest point, all of the
  // tolerance but three hundredths used.
  const Planned planned(shippedCell(kCell), {passage(4.0, 20.0, 40.0)});
  ASSERT_FALSE(planned.references.empty());
  const double exact = planned.speedRatio(planned.aligned, 1);
  for (const Positioning& reference : planned.references) {
    EXPECT_LT(planned.speedRatio(reference, 1), exact * 4.0 / 4.9);
    EXPECT_LE(planned.greatestLean(reference), degToRad(1.0));
  }
}

TEST(TableReference, IsNotNeededWhereTheExactOneIsSlow) {
  EXPECT_TRUE(Planned(shippedCell(kCell), {passage(5.0, 1.0, 20.0)}).references.empty());
  // From bead to bead there is time.
  const toolpath::Bead slow = passage(5.0, 1.0, 20.0);
  toolpath::Bead before = slow;
  toolpath::Bead behind = slow;
  before.points.resize(15);
  behind.points.erase(behind.points.begin(), behind.points.begin() + 25);
  EXPECT_TRUE(Planned(shippedCell(kCell), {before, behind}).references.empty());
}

TEST(TableReference, KeepsALimitedTableInside) {
  cell::Cell cell = shippedCell(kCell);
  cell::Joint& table = cell.positioner.joints[1];
  table.endless = false;
  table.min = degToRad(-100.0);
  table.max = degToRad(100.0);
  const Planned planned(cell, {passage(0.5, 20.0, 20.0)});
  ASSERT_FALSE(planned.references.empty());
  for (const Positioning& reference : planned.references) {
    EXPECT_EQ(planned.excess(reference), 0.0);
    EXPECT_LE(planned.greatestLean(reference), degToRad(1.0));
  }
}

TEST(TableReference, StandsStillWhereTheDirectionsAreUprightButForNoise) {
  // The exact turn is then noise.
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1e-7);
  toolpath::Bead bead = passage(0.0, 5.0, 1000.0);
  for (toolpath::PathPoint& point : bead.points) {
    point.up = Vec3(noise(random), noise(random), 1.0).normalized();
    point.axis = point.up;
  }
  const Planned planned(shippedCell(kCell), {bead, bead, bead});
  EXPECT_GT(planned.speedRatio(planned.aligned, 1), 1.0);
  ASSERT_FALSE(planned.references.empty());
  EXPECT_LT(planned.speedRatio(planned.references[0], 0), 1e-3);
  EXPECT_LT(planned.speedRatio(planned.references[0], 1), 1e-3);
  EXPECT_LE(planned.greatestLean(planned.references[0]), degToRad(1.0));
}

TEST(TableReference, TurnsTheTableWhereTheTiltIsLimited) {
  // The tilt cannot change its sign: the table has to turn, as slowly as it can.
  cell::Cell cell = shippedCell(kCell);
  cell.positioner.joints[0].min = degToRad(-5.0);
  const Planned planned(cell, {passage(0.5, 20.0, 20.0)});
  ASSERT_FALSE(planned.references.empty());
  const Positioning& reference = planned.references[0];
  EXPECT_LT(planned.excess(reference), 1e-9);
  EXPECT_LE(planned.greatestLean(reference), degToRad(1.0));
  EXPECT_LT(planned.speedRatio(reference, 1), 0.5 * planned.speedRatio(planned.aligned, 1));
}

TEST(TableReference, NeedsTwoUncoupledTurns) {
  const std::vector<toolpath::Bead> beads = {passage(0.5, 20.0, 20.0)};
  EXPECT_TRUE(Planned(shippedCell("fanuc_arcmate120ic_part_carried"), beads).references.empty());
  cell::Cell coupled = shippedCell(kCell);
  coupled.positioner.joints[1].coupling = {0.5};
  EXPECT_TRUE(Planned(coupled, beads).references.empty());
  cell::Cell parallel = shippedCell(kCell);
  parallel.positioner.joints[1].alpha = 0.0;
  EXPECT_TRUE(Planned(parallel, beads).references.empty());
  EXPECT_TRUE(Planned(shippedCell(kCell), {}).references.empty());
}

}  // namespace
}  // namespace wcam::motion::detail
