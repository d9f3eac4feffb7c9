// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::program {

/// Number of positions that an instruction needs in a robot program: 0, 1 or 2.
int targetCount(const Action& action) noexcept;

/// Cuts a program into parts of at most `maxTargets` positions (0: one part). A part ends after a
/// closed bead or a travel move with the arc off where that is possible; else in the bead, and the
/// arc burns over the border.
struct ProgramParts {
  std::vector<std::size_t> ends;  ///< index past the last instruction of each part
  std::size_t cutsWithArcOn = 0;
};

/// @throws Error(InvalidArgument) when one instruction alone needs more positions
ProgramParts splitProgram(const Program& program, int maxTargets);

/// One of the controller's programs that a program is written as.
struct NamedPart {
  std::string name;
  std::span<const Instruction> instructions;
};

/// A program cut into programs of the controller.
struct NamedParts {
  std::string main;  ///< name of the program that calls the parts
  std::vector<NamedPart> parts;
  bool chained = false;  ///< false: a single part, which bears the main name

  /// Names of the parts, in the order of the calls.
  [[nodiscard]] std::vector<std::string> calls() const;
};

/// Cuts and names a program as splitProgram and partNames do. A bead that is cut with the arc on is
/// a finding (post.cut_with_arc_on).
/// @param name wanted for the main program; blank takes that of the program
/// @throws Error(InvalidArgument) as splitProgram and partNames
NamedParts splitNamed(const Program& program,
                      int maxTargets,
                      std::string_view name,
                      std::size_t longestName,
                      const JobContext& context);

}  // namespace wcam::program
