// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_axis.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"

#include <cmath>

namespace wcam::motion::detail {

namespace {

/// A direction this near to the axis (sine), or a point this near (the last digit of programs, mm),
/// has no azimuth: rounding would choose it.
constexpr double kAlongAxis = 1e-6;
constexpr double kOnAxis = 1e-3;
constexpr std::size_t kCheckEvery = 1024;

}  // namespace

TableAxis::TableAxis(const Cell& cell, bool inPlane)
    : cell_(cell), last_(static_cast<std::size_t>(cell.positionerJoints() - 1)) {
  WCAM_ASSERT(cell.positionerJoints() > 0);
  const PositionerValues zero{};
  const cell::ChainAxes axes = cell::chainAxes(cell.positioner, zero.data());
  const Pose T_table_root = axes.T_root_tip.inverse();
  axis_ = T_table_root.linear() * axes.directions[last_];
  origin_ = T_table_root * axes.points[last_];
  tilt_ = axes.directions[0];
  Vec3 x = Vec3::UnitX() - axis_ * axis_.x();
  if (inPlane && last_ > 0) {
    const Vec3 across = axis_.cross(T_table_root.linear() * tilt_);
    if (across.norm() > kAlongAxis) {
      x = across.dot(x) < 0.0 ? Vec3(-across) : across;
    }
  }
  zero_ = x.norm() > kAlongAxis ? Vec3(x.normalized()) : Vec3(axis_.unitOrthogonal());
  side_ = axis_.cross(zero_);
}

std::optional<double> TableAxis::azimuth(const Vec3& inTable, double least) const {
  const double x = inTable.dot(zero_);
  const double y = inTable.dot(side_);
  if (std::hypot(x, y) < least) {
    return std::nullopt;
  }
  return std::atan2(y, x);
}

std::optional<double> TableAxis::azimuthOf(const Vec3& direction) const {
  return azimuth(cell_.T_table_part.linear() * direction, kAlongAxis);
}

std::optional<double> TableAxis::azimuthOfPoint(const Vec3& point) const {
  return azimuth(cell_.T_table_part * point - origin_, kOnAxis);
}

double TableAxis::angleTo(const Vec3& direction) const {
  const Vec3 inTable = cell_.T_table_part.linear() * direction;
  return std::atan2(axis_.cross(inTable).norm(), std::abs(axis_.dot(inTable)));
}

double TableAxis::turnOf(const PositionerValues& values) const {
  const cell::Joint& joint = cell_.positioner.joints[last_];
  double turn = joint.sign * values[last_];
  if (last_ > 0 && !joint.coupling.empty()) {
    turn += joint.coupling[0] * values[0];
  }
  return turn;
}

PositionerValues TableAxis::values(double turn,
                                   const Vec3& up,
                                   const PositionerValues& previous) const {
  const cell::Joint& joint = cell_.positioner.joints[last_];
  PositionerValues values = previous;
  if (last_ > 0) {
    // `up` in the base with the tilting axis at zero and the table turned.
    const PositionerValues zero{};
    const Eigen::Matrix3d base = cell::chainAxes(cell_.positioner, zero.data()).T_root_tip.linear();
    const Vec3 turned =
        base * (Eigen::AngleAxisd(turn, axis_) * (cell_.T_table_part.linear() * up));
    const Vec3 vertical = cell_.verticalInBase();
    const Vec3 a = turned - tilt_ * tilt_.dot(turned);
    const Vec3 b = vertical - tilt_ * tilt_.dot(vertical);
    if (a.norm() > kAlongAxis && b.norm() > kAlongAxis) {
      const double tilt = std::atan2(tilt_.dot(a.cross(b)), a.dot(b));
      values[0] = cell::turnInLimits(cell_.joint(cell_.robotJoints()),
                                     tilt / cell_.positioner.joints[0].sign, previous[0]);
    }
    turn -= joint.coupling.empty() ? 0.0 : joint.coupling[0] * values[0];
  }
  values[last_] = turn / joint.sign;
  return values;
}

Resolution resolveTable(const Task& task,
                        const TableAxis& table,
                        const JobContext& context,
                        const TableTurn& turn) {
  const Cell& cell = task.cell;
  std::vector<PositionerValues> values(task.targets.size());
  PositionerValues previous{};
  double before = 0.0;
  const int last = cell.jointCount() - 1;
  for (const Segment& segment : task.runs.segments) {
    for (std::size_t i = segment.first; i <= segment.last; ++i) {
      if (i % kCheckEvery == 0) {
        context.check();
      }
      before = turn(i, before);
      previous = table.values(before, task.targets[i].up, previous);
      // A limited table takes another full turn where it can, at the start of a bead only.
      if (i == segment.first && cell::periodicJoint(cell, last)) {
        const auto k = static_cast<std::size_t>(cell.positionerJoints() - 1);
        previous[k] = cell::turnInLimits(cell.joint(last), previous[k], previous[k]);
        before = table.turnOf(previous);
      }
      values[i] = previous;
    }
  }
  Resolution resolution;
  resolution.choices = constantRotation(task, values);
  spreadToTravel(task.runs, resolution.choices);
  resolution.branches = oneBranch(task, resolution.choices, context);
  return resolution;
}

}  // namespace wcam::motion::detail
