// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"
#include "wcam/program/split.hpp"
#include "wcam/program/text_writer.hpp"

#include "dialect.hpp"

#include <array>
#include <span>
#include <string>

namespace fanuc {

/// What one operation carries from part to part.
struct ModalState {
  std::string configuration;
  int job = 0;
  std::array<int, 3> turns{};  ///< of the target before
  int farthestTurn = 0;        ///< of any position, and its axis from 0
  int farthestTurnAxis = 0;
  double worstSpeedError = 0.0;  ///< greatest relative error of a printed speed
};

/// Lines that an instruction needs at most.
int linesOf(const wcam::program::Action& action, const Dialect& dialect);

/// Lines of a program before its first instruction.
int headLines(const wcam::program::Program& program, const Dialect& dialect);

/// Text of one TP program with motion.
std::string printPart(const wcam::program::NamedPart& part,
                      const std::string& comment,
                      const wcam::program::Program& program,
                      const Dialect& dialect,
                      ModalState& state,
                      const wcam::JobContext& context);

/// Text of a TP program without motion that calls others in order.
std::string printMain(const std::string& name,
                      const std::string& comment,
                      const wcam::program::Program& program,
                      std::span<const std::string> parts,
                      const Dialect& dialect);

}  // namespace fanuc
