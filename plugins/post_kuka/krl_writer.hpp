// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"
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

/// What printProgram() writes around the moves.
struct Frame {
  std::string name;
  std::string comment;
  bool main = true;  ///< with INI, tool and base; else a part that a main program calls
};

/// Text of one KRL program with motion.
std::string printProgram(const Frame& frame,
                         const wcam::program::Program& program,
                         std::span<const wcam::program::Instruction> instructions,
                         const Dialect& dialect,
                         ModalState& state,
                         const wcam::JobContext& context);

/// Text of a main program that calls its parts in order.
std::string printMain(const Frame& frame,
                      const wcam::program::Program& program,
                      std::span<const std::string> parts,
                      const Dialect& dialect);

}  // namespace kuka
