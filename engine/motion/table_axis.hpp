// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

#include <functional>
#include <optional>

namespace wcam::motion::detail {

/// The positioner's last axis as the strategies of Debout see it: azimuths about it, measured in
/// the table's frame at zero from the table's x (or, with `inPlane`, from the direction square to
/// the tilting axis that is nearest to it).
class TableAxis {
public:
  explicit TableAxis(const Cell& cell, bool inPlane = false);

  /// Azimuth of a direction or point of the part; empty where it lies along or on the axis.
  [[nodiscard]] std::optional<double> azimuthOf(const Vec3& direction) const;
  [[nodiscard]] std::optional<double> azimuthOfPoint(const Vec3& point) const;

  /// Angle between a direction of the part and the table's axis as a line, 0 to π/2.
  [[nodiscard]] double angleTo(const Vec3& direction) const;

  /// Values of the positioner with the table at `turn` (physical angle from zero, any turn) and a
  /// tilting axis where `up` is as near to the vertical as it can; continuous from `previous`.
  [[nodiscard]] PositionerValues values(double turn,
                                        const Vec3& up,
                                        const PositionerValues& previous) const;
  /// Physical angle of the table's axis at given values.
  [[nodiscard]] double turnOf(const PositionerValues& values) const;

private:
  [[nodiscard]] std::optional<double> azimuth(const Vec3& inTable, double least) const;

  const Cell& cell_;
  std::size_t last_;
  Vec3 axis_, zero_, side_;  ///< in the table frame
  Vec3 origin_;              ///< a point of the axis, table frame
  Vec3 tilt_;                ///< the tilting axis in the base
};

/// Turn of the table at a target when it was at a turn before, physical angle from zero.
using TableTurn = std::function<double(std::size_t target, double before)>;

/// Positioner values of all targets with the table at `turn` of each bead point in order,
/// constant rotation about the torch, one branch.
Resolution resolveTable(const Task& task,
                        const TableAxis& table,
                        const JobContext& context,
                        const TableTurn& turn);

}  // namespace wcam::motion::detail
