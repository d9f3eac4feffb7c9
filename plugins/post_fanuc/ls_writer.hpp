// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"
#include "wcam/program/text_writer.hpp"

#include "dialect.hpp"

#include <span>
#include <string>

namespace fanuc {

/// What one operation carries from part to part.
struct ModalState {
  std::string configuration;
  int job = 0;
  double worstSpeedError = 0.0;  ///< greatest relative error of a printed speed
};

/// Text of one TP program with motion.
std::string printPart(const std::string& name,
                      const std::string& comment,
                      const wcam::program::Program& program,
                      std::span<const wcam::program::Instruction> instructions,
                      const Dialect& dialect,
                      ModalState& state,
                      const wcam::JobContext& context);

/// Text of a TP program without motion that calls others in order.
std::string printMain(const std::string& name,
                      const std::string& comment,
                      std::span<const std::string> parts,
                      const Dialect& dialect);

}  // namespace fanuc
