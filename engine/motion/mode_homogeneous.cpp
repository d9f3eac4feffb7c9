// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"
#include "table_axis.hpp"

namespace wcam::motion::detail {

Resolution resolveHomogeneous(const Task& task, const JobContext& context) {
  const TableAxis table(task.cell);
  const std::vector<Target>& targets = task.targets;
  // Way along each bead over the bead's length.
  std::vector<double> part(targets.size(), 0.0);
  for (const Segment& segment : task.runs.segments) {
    for (std::size_t i = segment.first + 1; i <= segment.last; ++i) {
      part[i] = part[i - 1] + (targets[i].p - targets[i - 1].p).norm();
    }
    const double length = part[segment.last];
    for (std::size_t i = segment.first; i <= segment.last && length > 0.0; ++i) {
      part[i] /= length;
    }
  }
  return resolveTable(task, table, context, [&](std::size_t i, double before) {
    return targets[i].waypoint.point == 0
               ? cell::nearestTurn(task.params.tableAngle.value(), before)
               : before + task.params.tableTurn.value() * (part[i] - part[i - 1]);
  });
}

}  // namespace wcam::motion::detail
