// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/objective.hpp"

#include "wcam/motion/plan.hpp"

#include <numeric>

namespace wcam::motion {

const char* objectiveKey(Objective objective) {
  static constexpr std::array<const char*, kObjectiveCount> kKeys = {
      "motion", "positioner", "winding",   "transition", "speed",       "acceleration",
      "jerk",   "gravity",    "dexterity", "limits",     "uncertainty", "tcp_speed"};
  return kKeys[static_cast<std::size_t>(objective)];
}

const char* constraintKey(Constraint constraint) {
  static constexpr std::array<const char*, kConstraintCount> kKeys = {
      "reach",       "limits",   "collision", "speed", "dexterity",
      "singularity", "vertical", "cable",     "tilt"};
  return kKeys[static_cast<std::size_t>(constraint)];
}

const char* redundancyKey(RedundancyMode mode) {
  static constexpr std::array<const char*, kRedundancyModes> kKeys = {
      "optimized",          "constant",       "point_by_point", "polynomial",     "fixed",
      "constant_tool_axis", "fixed_tool_tip", "homogeneous",    "planar_vertical"};
  return kKeys[static_cast<std::size_t>(mode)];
}

std::size_t Evaluation::violations() const {
  return count(Constraint::Reach) + count(Constraint::Limits) + count(Constraint::Collision) +
         count(Constraint::Tilt) + count(Constraint::Cable);
}

std::size_t Evaluation::allBroken() const {
  return std::accumulate(broken.begin(), broken.end(), std::size_t{0});
}

bool Evaluation::betterThan(const Evaluation& other) const {
  if (violations() != other.violations()) {
    return violations() < other.violations();
  }
  if (allBroken() != other.allBroken()) {
    return allBroken() < other.allBroken();
  }
  if (excess != other.excess) {
    return excess < other.excess;
  }
  return cost < other.cost;
}

ObjectiveValues ownObjective(RedundancyMode mode) {
  ObjectiveValues weights{};
  const auto set = [&weights](Objective objective) {
    weights[static_cast<std::size_t>(objective)] = 1.0;
  };
  switch (mode) {
    case RedundancyMode::Optimized:
      return MotionParams().weights();
    case RedundancyMode::Constant:
    case RedundancyMode::PointByPoint:
    case RedundancyMode::Polynomial:
    case RedundancyMode::FixedToolTip:
      set(Objective::Motion);
      break;
    case RedundancyMode::Fixed:
      set(Objective::Positioner);
      break;
    case RedundancyMode::ConstantToolAxis:
    case RedundancyMode::PlanarVertical:
      set(Objective::Gravity);
      break;
    case RedundancyMode::Homogeneous:
      set(Objective::Acceleration);
      break;
  }
  return weights;
}

}  // namespace wcam::motion
