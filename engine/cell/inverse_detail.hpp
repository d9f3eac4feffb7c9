// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/inverse.hpp"

#include <memory>

/// Kinds of inverse kinematics. Private to this module.
namespace wcam::cell::detail {

/// What a robot without a free rotation must put in place, in the flange frame.
struct Tool {
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

Tool toolOf(const Cell& cell);

/// The kind that fits the robot; cell.arm must have been looked for.
std::shared_ptr<const InverseKinematics> makeInverse(const Cell& cell);

/// Null when the robot is not three prismatic axes followed by two or three rotary ones whose
/// neighbours are not parallel.
std::shared_ptr<const InverseKinematics> makeCartesianInverse(const Chain& robot, const Tool& tool);

std::shared_ptr<const InverseKinematics> makeNumericInverse(const Chain& robot, const Tool& tool);

}  // namespace wcam::cell::detail
