// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"
#include "wcam/program/split.hpp"
#include "wcam/program/text_writer.hpp"

#include "dialect.hpp"

#include <optional>
#include <span>
#include <string>

namespace kuka {

/// What one operation carries from part to part.
struct ModalState {
  std::string configuration;
  int job = 0;
  std::optional<Eigen::Vector3d> abc;  ///< angles of the target before, rad
  std::optional<wcam::program::Target> target;
  double worstAxisSpeedError = 0.0;  ///< greatest relative error of a speed in joint mode
};

/// Lines that an instruction needs at most.
int linesOf(const wcam::program::Action& action, const Dialect& dialect);

/// Lines of each of some instructions that follow one another in one program.
std::vector<int> linesInOrder(std::span<const wcam::program::Instruction> instructions,
                              const Dialect& dialect);

/// Lines of a program beside those of its instructions.
int headLines(const wcam::program::Program& program, const Dialect& dialect);

/// Text of one KRL program with motion.
std::string printProgram(const wcam::program::NamedPart& part,
                         const wcam::program::Program& program,
                         const Dialect& dialect,
                         ModalState& state,
                         const wcam::JobContext& context);

/// Text of a main program that calls its parts in order.
std::string printMain(const std::string& name,
                      const wcam::program::Program& program,
                      std::span<const std::string> parts,
                      const Dialect& dialect);

}  // namespace kuka
