// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/names.hpp"
#include "wcam/program/program.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::program {

/// Number of positions that an instruction needs in a robot program: 0, 1 or 2.
int targetCount(const Action& action) noexcept;

/// How long one program of a controller may be.
struct SplitLimits {
  int positions = 0;  ///< 0: no limit
  int lines = 0;      ///< 0: no limit
  /// Lines that an instruction needs at most; empty: one.
  std::function<int(const Action&)> linesOf = {};
  int headLines = 0;  ///< lines of every program beside those of its instructions
  /// Lines of each of some instructions that follow one another in one program, where that is less
  /// than linesOf tells of them alone (modal values); empty: linesOf. What a part that begins among
  /// them writes again counts as lines of the head.
  std::function<std::vector<int>(std::span<const Instruction>)> linesInOrder = {};
};

/// A part of a program that can be started alone: `lead`, the instructions from `begin` to `end`,
/// `tail`.
struct ProgramPart {
  std::vector<Instruction> lead;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<Instruction> tail;
};

struct ProgramParts {
  std::vector<ProgramPart> parts;
  std::size_t interruptedBeads = 0;  ///< cuts at Program::lifts: the arc stops and starts again
  std::size_t cutsWithArcOn = 0;     ///< the arc burns over the border
};

/// Cuts a program into parts within the limits. A part begins with a joint move to a safe point:
/// the one of the way between two beads, else one more to where the part before ended, with the
/// torch lifted off. A bead that is longer than a part is interrupted at one of Program::lifts;
/// where there is none it is cut with the arc on. Wire speeds are set anew in each part.
/// @throws Error(InvalidArgument) when one instruction alone needs more than a part
ProgramParts splitProgram(const Program& program, const SplitLimits& limits);

/// One of the controller's programs that a program is written as.
struct NamedPart {
  std::string name;
  std::vector<Instruction> lead;
  std::span<const Instruction> body;
  std::vector<Instruction> tail;

  /// All instructions in order.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const std::span<const Instruction> piece :
         {std::span<const Instruction>(lead), body, std::span<const Instruction>(tail)}) {
      for (const Instruction& instruction : piece) {
        visit(instruction);
      }
    }
  }

  [[nodiscard]] std::size_t size() const noexcept {
    return lead.size() + body.size() + tail.size();
  }
};

/// A program cut into programs of the controller.
struct NamedParts {
  std::string main;  ///< name of the program that calls the parts
  std::vector<NamedPart> parts;
  bool chained = false;  ///< false: a single part, which bears the main name

  /// Names of the parts, in the order of the calls.
  [[nodiscard]] std::vector<std::string> calls() const;
};

/// Cuts and names a program as splitProgram and partNames do. Findings: post.bead_interrupted (a
/// warning), post.cut_with_arc_on (a violation: such a part cannot be started alone) and
/// post.name_changed (the wanted name is a word of the language, or loses or changes characters).
/// @param name wanted for the main program; blank takes that of the program
/// @throws Error(InvalidArgument) as splitProgram and partNames
NamedParts splitNamed(const Program& program,
                      const SplitLimits& limits,
                      std::string_view name,
                      const NameRules& rules,
                      const JobContext& context);

}  // namespace wcam::program
