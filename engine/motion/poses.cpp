// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"

#include "plan_detail.hpp"

#include <cmath>

namespace wcam::motion::detail {

Vec3 tiltedAxis(const Target& target, double lead, double lateral) {
  if (lead == 0.0 && lateral == 0.0) {
    return target.axis;
  }
  // T = (tan θn·t + tan θt·n + b)/|…| (Chalvin A37) with the directions square to the axis.
  Vec3 along = target.along - target.axis * target.axis.dot(target.along);
  along = along.norm() > 0.0 ? Vec3(along.normalized()) : Vec3(target.axis.unitOrthogonal());
  const Vec3 left = target.axis.cross(along);
  return (target.axis + std::tan(lead) * along + std::tan(lateral) * left).normalized();
}

Pose flangePose(const Cell& cell,
                const Target& target,
                const FreeChoice& choice,
                Pose* T_part_tcp) {
  const Vec3 axis = tiltedAxis(target, choice.lead, choice.lateral);
  if (cell.partCarried()) {
    // Chalvin A18a and A20: the part's axis onto the torch's, the point onto the deposition point.
    const Eigen::Matrix3d torch = cell.T_base_tcp.linear();
    Pose T_base_part = Pose::Identity();
    T_base_part.linear() = torch * cell::axisToVertical(axis, choice.torchRotation);
    T_base_part.translation() = cell.T_base_tcp.translation() - T_base_part.linear() * target.p;
    *T_part_tcp = T_base_part.inverse() * cell.T_base_tcp;
    return T_base_part * (cell.T_flange_table * cell.T_table_part).inverse();
  }
  // Chalvin A22 and A18b.
  const Pose T_base_part =
      cell::chainPose(cell.positioner, choice.positioner.data()) * cell.T_table_part;
  Pose T_base_tcp = Pose::Identity();
  T_base_tcp.linear() = cell::frameWithZ(T_base_part.linear() * axis, choice.torchRotation);
  T_base_tcp.translation() = T_base_part * target.p;
  *T_part_tcp = T_base_part.inverse() * T_base_tcp;
  return T_base_tcp * cell.T_flange_tcp.inverse();
}

}  // namespace wcam::motion::detail
