// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace detail {

double jointTime(const Cell& cell,
                 const cell::JointVector& from,
                 const cell::JointVector& to,
                 double ratio) {
  double time = 0.0;
  for (int j = 0; j < cell.jointCount(); ++j) {
    time = std::max(time, std::abs(to(j) - from(j)) / (ratio * cell.joint(j).maxSpeed));
  }
  return time;
}

}  // namespace detail

void applyTimeLaw(Motion& motion, const cell::Cell& cell, double jointSpeedRatio) {
  double time = 0.0;
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    Waypoint& point = motion.waypoints[i];
    if (i == 0) {
      point.time = 0.0;
      point.tcpSpeed = 0.0;
      continue;
    }
    const Waypoint& before = motion.waypoints[i - 1];
    const double length = (point.T_part_tcp.translation() - before.T_part_tcp.translation()).norm();
    double step = 0.0;
    if (point.kind == MoveKind::Joint) {
      step = detail::jointTime(cell, before.joints, point.joints, jointSpeedRatio);
    } else {
      step = detail::jointTime(cell, before.joints, point.joints, 1.0);
      if (point.speed > 0.0) {
        step = std::max(step, length / point.speed);
      }
    }
    time += step;
    point.time = time;
    point.tcpSpeed = step > 0.0 ? length / step : 0.0;
  }
}

}  // namespace wcam::motion
