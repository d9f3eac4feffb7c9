// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/split.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <optional>

namespace wcam::program {

namespace {

/// The limits that hold: 0 is none.
Text limitText(const SplitLimits& limits) {
  if (limits.positions > 0 && limits.lines > 0) {
    return text("%1 positions and %2 lines",
                {std::to_string(limits.positions), std::to_string(limits.lines)});
  }
  return limits.lines > 0 ? text("%1 lines", {std::to_string(limits.lines)})
                          : text("%1 positions", {std::to_string(limits.positions)});
}

/// What a part has room for.
struct Size {
  std::size_t positions = 0;
  std::size_t lines = 0;

  friend Size operator+(const Size& a, const Size& b) {
    return {a.positions + b.positions, a.lines + b.lines};
  }

  friend Size operator-(const Size& a, const Size& b) {
    return {a.positions - b.positions, a.lines - b.lines};
  }
};

const Target* targetOf(const Action& action) {
  if (const auto* joint = std::get_if<MoveJoint>(&action)) {
    return &joint->target;
  }
  if (const auto* linear = std::get_if<MoveLinear>(&action)) {
    return &linear->target;
  }
  const auto* circular = std::get_if<MoveCircular>(&action);
  return circular != nullptr ? &circular->target : nullptr;
}

/// A mark, a remark or a move: a part may begin with it.
bool opensPart(const Action& action) {
  return std::holds_alternative<Comment>(action) || std::holds_alternative<LayerBegin>(action) ||
         std::holds_alternative<BeadBegin>(action);
}

class Splitter {
public:
  Splitter(const Program& program, const SplitLimits& limits)
      : program_(program), limits_(limits), all_(program.instructions) {
    sizes_.reserve(all_.size() + 1);
    sizes_.push_back({});
    const std::vector<int> lines =
        limits_.linesInOrder ? limits_.linesInOrder(all_) : std::vector<int>();
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Size own = sizeOf(all_[i].action);
      own.lines = lines.empty() ? own.lines : static_cast<std::size_t>(lines[i]);
      sizes_.push_back(sizes_.back() + own);
    }
    findSeams();
  }

  ProgramParts run() {
    ProgramParts result;
    ProgramPart part;
    while (true) {
      const std::size_t farthest = reach(part);
      if (farthest == all_.size()) {
        part.end = farthest;
        result.parts.push_back(std::move(part));
        return result;
      }
      part = cut(std::move(part), farthest, result);
    }
  }

private:
  [[nodiscard]] Size sizeOf(const Action& action) const {
    const int lines = limits_.linesOf ? limits_.linesOf(action) : 1;
    return {static_cast<std::size_t>(targetCount(action)), static_cast<std::size_t>(lines)};
  }

  [[nodiscard]] Size sizeOf(const std::vector<Instruction>& instructions) const {
    Size size;
    for (const Instruction& instruction : instructions) {
      size = size + sizeOf(instruction.action);
    }
    return size;
  }

  [[nodiscard]] bool fits(const Size& size) const {
    const auto below = [](std::size_t value, int limit) {
      return limit <= 0 || value <= static_cast<std::size_t>(limit);
    };
    return below(size.positions, limits_.positions) &&
           below(size.lines + static_cast<std::size_t>(limits_.headLines), limits_.lines);
  }

  /// Where parts may begin: before a joint move with the arc off, and after the torch has been
  /// lifted off a bead.
  void findSeams() {
    bool arc = false;
    bool inBead = false;
    bool lifted = false;  // moved since the arc went off
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const Action& action = all_[i].action;
      if (!arc && !inBead && i > 0 && lifted) {
        if (std::holds_alternative<MoveJoint>(action)) {
          std::size_t begin = i;
          while (begin > 1 && opensPart(all_[begin - 1].action)) {
            --begin;
          }
          own_.push_back(begin);
        } else {
          lifted_.push_back(i);
        }
      }
      arc =
          std::holds_alternative<ArcOn>(action) || (arc && !std::holds_alternative<ArcOff>(action));
      inBead = std::holds_alternative<BeadBegin>(action) ||
               (inBead && !std::holds_alternative<BeadEnd>(action));
      lifted = !arc && (targetOf(action) != nullptr || lifted) &&
               !std::holds_alternative<ArcOff>(action);
    }
  }

  /// Index past the last instruction that still fits behind the lead of a part.
  [[nodiscard]] std::size_t reach(const ProgramPart& part) const {
    const Size lead = sizeOf(part.lead);
    std::size_t end = part.begin;
    while (end < all_.size() && fits(lead + (sizes_[end + 1] - sizes_[part.begin]))) {
      ++end;
    }
    if (end == part.begin) {
      const Size needed = lead + sizeOf(all_[end].action);
      throw Error(
          ErrorCode::InvalidArgument,
          text("a program of at most %1 has no room for a move", {limitText(limits_)}),
          program_.name,
          text("allow at least %1 positions and %2 lines per program",
               {std::to_string(std::max<std::size_t>(1, needed.positions)),
                std::to_string(needed.lines + static_cast<std::size_t>(limits_.headLines))}));
    }
    return end;
  }

  static std::optional<std::size_t> lastWithin(const std::vector<std::size_t>& seams,
                                               std::size_t begin,
                                               std::size_t end) {
    const auto after = std::upper_bound(seams.begin(), seams.end(), end);
    if (after == seams.begin() || *(after - 1) <= begin) {
      return std::nullopt;
    }
    return *(after - 1);
  }

  /// Ends a part at the best place before `farthest`. @return the beginning of the next one
  ProgramPart cut(ProgramPart part, std::size_t farthest, ProgramParts& result) const {
    ProgramPart next;
    if (const auto own = lastWithin(own_, part.begin, farthest)) {
      part.end = next.begin = *own;
      addWire(next, *own);
    } else if (const auto seam = lastWithin(lifted_, part.begin, farthest)) {
      part.end = next.begin = *seam;
      const std::size_t last = lastMove(*seam);
      next.lead.push_back(
          {MoveJoint{*targetOf(all_[last].action), ratioBefore(*seam), true}, all_[last].origin});
      addWire(next, *seam);
    } else if (const Lift* lift = lastLift(part, farthest)) {
      interrupt(part, next, *lift);
      ++result.interruptedBeads;
    } else {
      part.end = next.begin = farthest;
      result.cutsWithArcOn += arcAt(farthest) ? 1U : 0U;
      addWire(next, farthest);
    }
    result.parts.push_back(std::move(part));
    return next;
  }

  /// The last lift whose moves off the part still fit.
  [[nodiscard]] const Lift* lastLift(const ProgramPart& part, std::size_t farthest) const {
    const Size lead = sizeOf(part.lead);
    for (auto lift = program_.lifts.rbegin(); lift != program_.lifts.rend(); ++lift) {
      if (lift->instruction <= part.begin || lift->instruction >= farthest) {
        continue;
      }
      const Size tail = sizeOf(leaving(*lift));
      if (fits(lead + (sizes_[lift->instruction] - sizes_[part.begin]) + tail)) {
        return &*lift;
      }
    }
    return nullptr;
  }

  /// To the place with an exact stop, arc off, up to the safe point.
  [[nodiscard]] std::vector<Instruction> leaving(const Lift& lift) const {
    const Instruction& move = all_[lift.instruction];
    Instruction last = move;
    std::get<MoveLinear>(last.action).stop = true;
    double craterTime = 0.0;
    for (std::size_t i = lift.instruction; i < all_.size(); ++i) {
      if (const auto* off = std::get_if<ArcOff>(&all_[i].action)) {
        craterTime = off->craterTime;
        break;
      }
    }
    return {last,
            {ArcOff{craterTime}, move.origin},
            {MoveLinear{lift.above, lift.speed, true}, move.origin}};
  }

  void interrupt(ProgramPart& part, ProgramPart& next, const Lift& lift) const {
    const Instruction& move = all_[lift.instruction];
    part.end = lift.instruction;
    part.tail = leaving(lift);
    next.begin = lift.instruction + 1;
    next.lead.push_back({MoveJoint{lift.above, lift.speedRatio, true}, move.origin});
    next.lead.push_back(
        {MoveLinear{std::get<MoveLinear>(move.action).target, lift.speed, true}, move.origin});
    addWire(next, next.begin);
    for (std::size_t i = lift.instruction; i-- > 0;) {
      if (const auto* on = std::get_if<ArcOn>(&all_[i].action)) {
        next.lead.push_back({ArcOn{on->job}, move.origin});
        break;
      }
    }
  }

  /// The wire speed that holds before an instruction.
  void addWire(ProgramPart& part, std::size_t index) const {
    for (std::size_t i = index; i-- > 0;) {
      if (std::holds_alternative<SetProcess>(all_[i].action)) {
        part.lead.push_back(all_[i]);
        return;
      }
    }
  }

  [[nodiscard]] bool arcAt(std::size_t index) const {
    for (std::size_t i = index; i-- > 0;) {
      if (std::holds_alternative<ArcOn>(all_[i].action)) {
        return true;
      }
      if (std::holds_alternative<ArcOff>(all_[i].action)) {
        return false;
      }
    }
    return false;
  }

  [[nodiscard]] std::size_t lastMove(std::size_t index) const {
    std::size_t i = index;
    while (i > 0 && targetOf(all_[i - 1].action) == nullptr) {
      --i;
    }
    return i - 1;  // seams lie behind a move
  }

  [[nodiscard]] double ratioBefore(std::size_t index) const {
    for (std::size_t i = index; i-- > 0;) {
      if (const auto* joint = std::get_if<MoveJoint>(&all_[i].action)) {
        return joint->speedRatio;
      }
    }
    return MoveJoint{}.speedRatio;
  }

  const Program& program_;
  const SplitLimits& limits_;
  std::span<const Instruction> all_;
  std::vector<Size> sizes_;  ///< of the instructions before each
  std::vector<std::size_t> own_;
  std::vector<std::size_t> lifted_;
};

void tell(const Program& program,
          const ProgramParts& split,
          const SplitLimits& limits,
          const JobContext& context) {
  if (split.interruptedBeads > 0) {
    context.add({Severity::Warning,
                 "post.bead_interrupted",
                 text("a bead is longer than one program: the arc stops and starts again at %1 "
                      "places in it",
                      {std::to_string(split.interruptedBeads)}),
                 "allow more points or lines per program, or sample the bead less densely",
                 {program.name},
                 {{"cuts", static_cast<double>(split.interruptedBeads)}}});
  }
  if (split.cutsWithArcOn > 0) {
    context.add({Severity::Violation,
                 "post.cut_with_arc_on",
                 text("a bead is longer than one program of at most %1: it would be cut with the "
                      "arc on, into parts that cannot be started alone",
                      {limitText(limits)}),
                 "allow more points or lines per program, or sample the bead less densely",
                 {program.name},
                 {{"cuts", static_cast<double>(split.cutsWithArcOn)}}});
  }
}

}  // namespace

int targetCount(const Action& action) noexcept {
  if (std::holds_alternative<MoveCircular>(action)) {
    return 2;
  }
  return targetOf(action) != nullptr ? 1 : 0;
}

ProgramParts splitProgram(const Program& program, const SplitLimits& limits) {
  return Splitter(program, limits).run();
}

std::vector<std::string> NamedParts::calls() const {
  std::vector<std::string> names;
  for (const NamedPart& part : parts) {
    names.push_back(part.name);
  }
  return names;
}

NamedParts splitNamed(const Program& program,
                      const SplitLimits& limits,
                      std::string_view name,
                      const NameRules& rules,
                      const JobContext& context) {
  ProgramParts split = splitProgram(program, limits);
  tell(program, split, limits, context);
  NamedParts result;
  result.chained = split.parts.size() > 1;
  const std::string_view wanted =
      trimText(name).empty() ? std::string_view(program.name) : trimText(name);
  const std::vector<std::string> names =
      partNames(wanted, result.chained ? split.parts.size() : 0, rules);
  result.main = names.front();
  if (const std::string plain = controllerName(wanted, rules.longest); isReserved(plain, rules)) {
    context.add({Severity::Information,
                 "post.name_changed",
                 text("'%1' is a word of the language or of the file system: the program is named "
                      "%2",
                      {plain, result.main}),
                 "set program_name to another name",
                 {program.name},
                 {}});
  } else if (!keepsName(wanted, result.main)) {
    context.add({Severity::Information,
                 "post.name_changed",
                 text("'%1' becomes %2: names of programs have letters from A to Z, digits and _, "
                      "begin with a letter and have at most %3 characters",
                      {std::string(wanted), result.main, std::to_string(rules.longest)}),
                 "set program_name to a name of this form",
                 {program.name},
                 {}});
  }
  const std::span<const Instruction> all(program.instructions);
  for (std::size_t i = 0; i < split.parts.size(); ++i) {
    ProgramPart& part = split.parts[i];
    result.parts.push_back({names[result.chained ? i + 1 : 0], std::move(part.lead),
                            all.subspan(part.begin, part.end - part.begin), std::move(part.tail)});
  }
  return result;
}

}  // namespace wcam::program
