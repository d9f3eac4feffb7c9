// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"
#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"
#include "table_axis.hpp"

namespace wcam::motion::detail {

namespace {

/// Azimuths of the tool axes of a bead. Within the tolerance of the vertical along the table's axis
/// the azimuth says nothing: there it goes evenly from what it was to what it will be, by the
/// shorter way, instead of turning the table over; on a bead that stays there it is open.
void addAzimuths(const Task& task,
                 const TableAxis& table,
                 const Segment& segment,
                 std::vector<std::optional<double>>& azimuths) {
  const double tolerance = task.params.verticalTolerance.value();
  std::vector<double> way(segment.last - segment.first + 1, 0.0);
  std::optional<std::size_t> before;
  for (std::size_t i = segment.first; i <= segment.last; ++i) {
    const std::size_t k = i - segment.first;
    if (k > 0) {
      way[k] = way[k - 1] + (task.targets[i].p - task.targets[i - 1].p).norm();
    }
    if (table.angleTo(task.targets[i].axis) <= tolerance) {
      continue;
    }
    azimuths[i] = table.azimuthOf(task.targets[i].axis);
    if (!azimuths[i]) {
      continue;
    }
    const std::size_t first = before ? *before + 1 : segment.first;
    const double from = before ? *azimuths[*before] : *azimuths[i];
    const double turn = cell::wrapAngle(*azimuths[i] - from);
    const double begin = before ? way[*before - segment.first] : way[k];
    for (std::size_t m = first; m < i; ++m) {
      const double length = way[k] - begin;
      azimuths[m] = from + (length > 0.0 ? turn * (way[m - segment.first] - begin) / length : 0.0);
    }
    before = i;
  }
  for (std::size_t m = before ? *before + 1 : segment.last + 1; m <= segment.last; ++m) {
    azimuths[m] = azimuths[*before];
  }
}

}  // namespace

Resolution resolveConstantToolAxis(const Task& task, const JobContext& context) {
  const TableAxis table(task.cell);
  const double alpha = task.params.tableAngle.value();
  std::vector<std::optional<double>> azimuths(task.targets.size());
  for (const Segment& segment : task.runs.segments) {
    addAzimuths(task, table, segment, azimuths);
  }
  return resolveTable(task, table, context, [&](std::size_t i, double before) {
    return azimuths[i] ? cell::nearestTurn(alpha - *azimuths[i], before) : before;
  });
}

}  // namespace wcam::motion::detail
