// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "modes.hpp"

#include "wcam/base/error.hpp"

namespace wcam::motion::detail {

std::vector<FreeChoice> constantRotation(const Task& task,
                                         const std::vector<PositionerValues>& positioner) {
  std::vector<FreeChoice> choices(task.targets.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    choices[i].torchRotation = task.params.torchRotation.value();
    choices[i].positioner = positioner[i];
  }
  return choices;
}

void spreadToTravel(const Runs& runs, std::vector<FreeChoice>& choices) {
  for (const Segment& segment : runs.segments) {
    for (std::size_t i = segment.begin; i < segment.first; ++i) {
      choices[i] = choices[segment.first];
    }
    for (std::size_t i = segment.last + 1; i < segment.end; ++i) {
      choices[i] = choices[segment.last];
    }
  }
}

bool lacksPositioner(RedundancyMode mode, const Cell& cell) {
  switch (mode) {
    case RedundancyMode::ConstantToolAxis:
    case RedundancyMode::FixedToolTip:
    case RedundancyMode::Homogeneous:
    case RedundancyMode::PlanarVertical:
      return cell.partCarried() || cell.positionerJoints() == 0;
    default:
      return false;
  }
}

Resolution resolveNamed(RedundancyMode mode, const Task& task, const JobContext& context) {
  if (lacksPositioner(mode, task.cell)) {
    throw Error(
        ErrorCode::JobFailed,
        text(task.cell.partCarried() ? "the mode %1 turns the last axis of the positioner, and the "
                                       "cell has none: the robot carries the part"
                                     : "the mode %1 turns the last axis of the positioner, "
                                       "and the cell has none",
             {std::string(redundancyKey(mode))}),
        text("cell %1", {task.cell.name}),
        "use a cell with a positioner, or the mode optimized, constant, point_by_point or "
        "polynomial");
  }
  switch (mode) {
    case RedundancyMode::PointByPoint:
      return resolvePointByPoint(task, context);
    case RedundancyMode::Polynomial:
      return resolvePolynomial(task, context);
    case RedundancyMode::Fixed:
      return resolveFixed(task, context);
    case RedundancyMode::ConstantToolAxis:
      return resolveConstantToolAxis(task, context);
    case RedundancyMode::FixedToolTip:
      return resolveFixedToolTip(task, context);
    case RedundancyMode::Homogeneous:
      return resolveHomogeneous(task, context);
    case RedundancyMode::PlanarVertical:
      return resolvePlanarVertical(task, context);
    case RedundancyMode::Optimized:
    case RedundancyMode::Constant:
      break;
  }
  return resolveConstant(task, context);
}

}  // namespace wcam::motion::detail
