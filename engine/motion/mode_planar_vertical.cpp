// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"
#include "table_axis.hpp"

#include <cmath>

namespace wcam::motion::detail {

namespace {

/// Cosine of the largest lean that lead and lateral tilt take back: beyond it a vertical torch
/// would point along the layer.
constexpr double kLeastCosine = 0.1;
/// A lean that no robot's accuracy tells from none: part frames are measured to some hundredths of
/// a degree, and the tolerance of the tilt is none by default.
const double kUpright = degToRad(0.1);

/// Lead and lateral tilt that make the tool axis vertical: the remaining lead or lag that the
/// article accepts.
void standUpright(const Cell& cell, const Target& target, FreeChoice& choice) {
  const Eigen::Matrix3d R_base_part =
      cell::chainPose(cell.positioner, choice.positioner.data()).linear() *
      cell.T_table_part.linear();
  const Vec3 vertical = R_base_part.transpose() * cell.verticalInBase();
  const double along = vertical.dot(target.axis);
  if (along < kLeastCosine) {
    return;
  }
  const Vec3 lead = tiltedAxis(target, degToRad(45.0), 0.0);
  const Vec3 lateral = tiltedAxis(target, 0.0, degToRad(45.0));
  const Vec3 e1 = (lead - target.axis * target.axis.dot(lead)).normalized();
  const Vec3 e2 = (lateral - target.axis * target.axis.dot(lateral)).normalized();
  const double ahead = vertical.dot(e1) / along;
  const double across = vertical.dot(e2) / along;
  if (std::hypot(ahead, across) > std::tan(kUpright)) {
    choice.lead = std::atan(ahead);
    choice.lateral = std::atan(across);
  }
}

}  // namespace

Resolution resolvePlanarVertical(const Task& task, const JobContext& context) {
  const TableAxis table(task.cell, true);
  Resolution resolution = resolveTable(task, table, context, [&](std::size_t i, double before) {
    // q8 = −atan2(p'y, p'x) modulo a half turn: of both sides of the plane the nearer one.
    const std::optional<double> azimuth = table.azimuthOfPoint(task.targets[i].p);
    return azimuth ? cell::nearestPeriod(-*azimuth, before, kPi) : before;
  });
  for (std::size_t i = 0; i < task.targets.size(); ++i) {
    standUpright(task.cell, task.targets[i], resolution.choices[i]);
  }
  return resolution;
}

}  // namespace wcam::motion::detail
