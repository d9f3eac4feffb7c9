// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/from_motion.hpp"

#include "wcam/base/quantity.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace wcam::program {
namespace {

/// Configurations as a program of these values of axis 5 tells them: that of the cell, then one for
/// each target, empty where it stays.
std::vector<std::string> configurations(const std::vector<double>& fifthDegrees) {
  const cell::Cell cell =
      cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/fanuc_arcmate120ic.json");
  motion::PlannedMotion planned;
  for (const double degrees : fifthDegrees) {
    motion::Waypoint waypoint;
    waypoint.joints = cell::JointVector::Zero(cell.jointCount());
    waypoint.joints(4) = degToRad(degrees);
    waypoint.speed = 10.0;
    planned.motion.waypoints.push_back(waypoint);
  }
  const Program program = programFromMotion(planned, cell, {}, "op", "project", JobContext());
  std::vector<std::string> found = {program.cell.configuration};
  for (const Instruction& instruction : program.instructions) {
    if (const auto* move = std::get_if<MoveLinear>(&instruction.action)) {
      found.push_back(move->target.configuration);
    }
  }
  return found;
}

TEST(ProgramFromMotion, namesTheConfigurationWhereItChanges) {
  const std::vector<std::string> found = configurations({-40, -30, 30, 40, -20});
  ASSERT_EQ(found.size(), 6U);
  const std::string first = found[0];
  EXPECT_EQ(found[1], "");
  EXPECT_EQ(found[2], "");
  EXPECT_NE(found[3], first);
  EXPECT_EQ(found[3].substr(1), first.substr(1));  // the wrist alone
  EXPECT_EQ(found[4], "");
  EXPECT_EQ(found[5], first);
}

TEST(ProgramFromMotion, keepsTheConfigurationInASingularity) {
  // Rounding around 0 names no other one; the same values with the other start keep the other.
  for (const double start : {-40.0, 40.0}) {
    const std::vector<std::string> found = configurations({start, 1e-9, -1e-9, 0.0, start});
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_EQ(found[i], "") << start << ", target " << i;
    }
  }
  EXPECT_NE(configurations({-40.0})[0], configurations({40.0})[0]);
}

}  // namespace
}  // namespace wcam::program
