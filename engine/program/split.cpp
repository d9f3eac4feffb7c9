// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/split.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/program/names.hpp"

#include <optional>

namespace wcam::program {

namespace {

/// Follows the state of the arc and whether the torch is between two beads.
class Seams {
public:
  void pass(const Action& action) {
    if (std::holds_alternative<ArcOn>(action)) {
      arc_ = true;
    } else if (std::holds_alternative<ArcOff>(action)) {
      arc_ = false;
    } else if (std::holds_alternative<BeadBegin>(action)) {
      inBead_ = true;
    } else if (std::holds_alternative<BeadEnd>(action)) {
      inBead_ = false;
    }
  }

  [[nodiscard]] bool arc() const noexcept { return arc_; }

  /// A part may end here without harm: the arc is off, and not just before it goes on again.
  [[nodiscard]] bool good() const noexcept { return !arc_ && !inBead_; }

private:
  bool arc_ = false;
  bool inBead_ = false;
};

}  // namespace

int targetCount(const Action& action) noexcept {
  if (std::holds_alternative<MoveCircular>(action)) {
    return 2;
  }
  return std::holds_alternative<MoveJoint>(action) || std::holds_alternative<MoveLinear>(action)
             ? 1
             : 0;
}

ProgramParts splitProgram(const Program& program, int maxTargets) {
  const auto limit = static_cast<std::size_t>(maxTargets > 0 ? maxTargets : 0);
  ProgramParts parts;
  std::size_t used = 0;
  // The last place where the part may end, with what follows it and whether it lies between beads.
  std::optional<std::size_t> seam;
  std::size_t usedAfterSeam = 0;
  Seams seams;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Action& action = program.instructions[i].action;
    const auto count = static_cast<std::size_t>(targetCount(action));
    if (limit > 0 && count > limit) {
      throw Error(ErrorCode::InvalidArgument,
                  text("a move needs %1 positions, a program may have %2",
                       {std::to_string(count), std::to_string(limit)}),
                  program.name, "allow more points per program");
    }
    while (limit > 0 && used + count > limit) {
      if (seam) {
        parts.ends.push_back(*seam);
        used = usedAfterSeam;
      } else {
        parts.ends.push_back(i);
        parts.cutsWithArcOn += seams.arc() ? 1 : 0;
        used = 0;
      }
      seam.reset();
    }
    used += count;
    usedAfterSeam += count;
    seams.pass(action);
    if (used > 0 && seams.good() &&
        (count > 0 || std::holds_alternative<BeadEnd>(action) ||
         std::holds_alternative<ArcOff>(action))) {
      seam = i + 1;
      usedAfterSeam = 0;
    }
  }
  parts.ends.push_back(program.instructions.size());
  return parts;
}

std::vector<std::string> NamedParts::calls() const {
  std::vector<std::string> names;
  for (const NamedPart& part : parts) {
    names.push_back(part.name);
  }
  return names;
}

NamedParts splitNamed(const Program& program,
                      int maxTargets,
                      std::string_view name,
                      std::size_t longestName,
                      const JobContext& context) {
  const ProgramParts split = splitProgram(program, maxTargets);
  if (split.cutsWithArcOn > 0) {
    context.add({Severity::Warning,
                 "post.cut_with_arc_on",
                 "a bead is longer than one program: the arc burns while the next one is called",
                 "allow more points per program or sample the bead less densely",
                 {program.name},
                 {{"cuts", static_cast<double>(split.cutsWithArcOn)}}});
  }
  NamedParts result;
  result.chained = split.ends.size() > 1;
  const std::vector<std::string> names =
      partNames(trimText(name).empty() ? std::string_view(program.name) : name,
                result.chained ? split.ends.size() : 0, longestName);
  result.main = names.front();
  const std::span<const Instruction> all(program.instructions);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < split.ends.size(); ++i) {
    result.parts.push_back(
        {names[result.chained ? i + 1 : 0], all.subspan(begin, split.ends[i] - begin)});
    begin = split.ends[i];
  }
  return result;
}

}  // namespace wcam::program
