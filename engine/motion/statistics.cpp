// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace {

constexpr std::size_t kGrain = 256;
constexpr std::size_t kCheckEvery = 4096;

void addJoints(const Waypoint& point, bool first, MotionStatistics& statistics) {
  for (std::size_t j = 0; j < statistics.joints.size(); ++j) {
    JointStatistics& joint = statistics.joints[j];
    const double value = point.joints(static_cast<Eigen::Index>(j));
    joint.min = first ? value : std::min(joint.min, value);
    joint.max = first ? value : std::max(joint.max, value);
  }
}

void addSpeeds(const cell::Cell& cell,
               const Waypoint& before,
               const Waypoint& point,
               MotionStatistics& statistics) {
  const double step = point.time - before.time;
  if (!(step > 0.0)) {
    return;
  }
  if (point.arc) {
    statistics.arcTime += step;
  }
  for (int j = 0; j < cell.jointCount(); ++j) {
    const double ratio =
        std::abs(point.joints(j) - before.joints(j)) / (step * cell.joint(j).maxSpeed);
    JointStatistics& joint = statistics.joints[static_cast<std::size_t>(j)];
    joint.maxSpeedRatio = std::max(joint.maxSpeedRatio, ratio);
    statistics.maxJointSpeedRatio = std::max(statistics.maxJointSpeedRatio, ratio);
  }
}

}  // namespace

MotionStatistics motionStatistics(const Motion& motion,
                                  const cell::Cell& cell,
                                  const JobContext& context) {
  MotionStatistics statistics;
  statistics.joints.resize(static_cast<std::size_t>(cell.jointCount()));
  const std::vector<Waypoint>& waypoints = motion.waypoints;
  std::vector<double> dexterity(waypoints.size(), 1.0);
  const detail::CellModel model(cell);
  parallelFor(
      waypoints.size(), kGrain,
      [&](std::size_t i) {
        if (waypoints[i].reachable) {
          dexterity[i] = model.armState(waypoints[i].joints).dexterity;
        }
      },
      context);
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    addJoints(waypoints[i], i == 0, statistics);
    statistics.minDexterity = std::min(statistics.minDexterity, dexterity[i]);
    statistics.unreachableWaypoints += waypoints[i].reachable ? 0 : 1;
    if (i > 0) {
      addSpeeds(cell, waypoints[i - 1], waypoints[i], statistics);
    }
  }
  for (int j = 0; j < cell.jointCount(); ++j) {
    JointStatistics& joint = statistics.joints[static_cast<std::size_t>(j)];
    joint.margin = std::min(cell::limitMargin(cell.joint(j), joint.min),
                            cell::limitMargin(cell.joint(j), joint.max));
  }
  statistics.totalTime = waypoints.empty() ? 0.0 : waypoints.back().time;
  return statistics;
}

}  // namespace wcam::motion
