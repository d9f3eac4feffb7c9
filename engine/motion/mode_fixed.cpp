// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "modes.hpp"
#include "table_axis.hpp"

namespace wcam::motion::detail {

Resolution resolveFixed(const Task& task, const JobContext& context) {
  PositionerValues rest{};
  if (!task.cell.partCarried() && task.cell.positionerJoints() > 0 && !task.targets.empty()) {
    rest = TableAxis(task.cell).values(task.params.tableAngle.value(), task.targets.front().up, {});
  }
  Resolution resolution;
  resolution.choices =
      constantRotation(task, std::vector<PositionerValues>(task.targets.size(), rest));
  resolution.branches = oneBranch(task, resolution.choices, context);
  return resolution;
}

}  // namespace wcam::motion::detail
