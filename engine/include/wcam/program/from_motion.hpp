// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/motion/motion.hpp"
#include "wcam/program/program.hpp"

#include <string>

namespace wcam::program {

/// What the program takes from the process.
struct ArcSettings {
  int job = 1;
  double craterTime = 0.0;       ///< s
  double jointSpeedRatio = 0.1;  ///< of joint moves
  double wireDiameter = 0.0;     ///< mm
  double wireSpeed = 0.0;        ///< of the process, mm/s
  double liftHeight = 50.0;      ///< of the safe points of long beads above them, mm
  double liftSpeed = 30.0;       ///< to them, mm/s
};

/// Turns a motion into the robot-neutral program: arc on where a bead starts, arc off with crater
/// fill where it ends, exact stops there, layer and bead marks around; exact stops and waits where
/// the torch pauses. Long beads get places where the program may be cut (Program::lifts).
Program programFromMotion(const motion::PlannedMotion& planned,
                          const cell::Cell& cell,
                          const ArcSettings& arc,
                          const std::string& operation,
                          const std::string& projectName,
                          const JobContext& context);

}  // namespace wcam::program
