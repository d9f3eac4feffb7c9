// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/program/program.hpp"

#include <cstddef>
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

}  // namespace wcam::program
