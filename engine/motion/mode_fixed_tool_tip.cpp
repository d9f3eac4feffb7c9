// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"
#include "table_axis.hpp"

namespace wcam::motion::detail {

Resolution resolveFixedToolTip(const Task& task, const JobContext& context) {
  const TableAxis table(task.cell);
  const double alpha = task.params.tableAngle.value();
  // On the table's axis the azimuth is open: the table rests.
  return resolveTable(task, table, context, [&](std::size_t i, double before) {
    const std::optional<double> azimuth = table.azimuthOfPoint(task.targets[i].p);
    return azimuth ? cell::nearestTurn(alpha - *azimuth, before) : before;
  });
}

}  // namespace wcam::motion::detail
