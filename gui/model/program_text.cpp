// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace wcam::gui {

namespace {

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// The line without its number ("  12:") and blanks in front.
std::string_view statementOf(std::string_view line) {
  std::size_t i = line.find_first_not_of(" \t");
  if (i == std::string_view::npos) {
    return {};
  }
  std::size_t digits = i;
  while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) {
    ++digits;
  }
  if (digits > i && digits < line.size() && line[digits] == ':') {
    i = line.find_first_not_of(" \t", digits + 1);
  }
  return i == std::string_view::npos ? std::string_view() : line.substr(i);
}

bool moves(std::string_view line) {
  const std::string_view text = statementOf(line);
  // FANUC: "J P[1] ...", "L P[2] ...", "C P[3]".
  if (text.size() > 4 && (text[0] == 'J' || text[0] == 'L' || text[0] == 'C') &&
      text.substr(1, 3) == " P[") {
    return true;
  }
  static constexpr std::array<std::string_view, 15> kWords = {
      "PTP",   "LIN",   "CIRC", "SPTP", "SLIN", "SCIRC", "MoveAbsJ", "MoveJ",
      "MoveL", "MoveC", "MOVJ", "MOVL", "MOVC", "movej", "movel"};
  return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
    return text.substr(0, word.size()) == word &&
           (text.size() == word.size() || !isWordCharacter(text[word.size()]));
  });
}

/// For every motion instruction of the program the move of the path that it makes.
std::vector<std::int32_t> movesOf(const PathModel& path) {
  std::vector<std::int32_t> moves;
  const program::Program* program = path.result().program.get();
  if (program == nullptr) {
    return moves;
  }
  std::int32_t last = -1;
  for (const program::Instruction& instruction : program->instructions) {
    const bool isMove = std::holds_alternative<program::MoveJoint>(instruction.action) ||
                        std::holds_alternative<program::MoveLinear>(instruction.action) ||
                        std::holds_alternative<program::MoveCircular>(instruction.action);
    if (!isMove) {
      continue;
    }
    const program::Origin& origin = instruction.origin;
    if (origin.point >= 0) {
      // Points follow each other, so the search begins where the last one ended.
      auto i = static_cast<std::size_t>(last + 1);
      while (i < path.size() && !(path.layer(i) == origin.layer && path.bead(i) == origin.bead &&
                                  path.point(i) == origin.point)) {
        ++i;
      }
      if (i < path.size()) {
        last = static_cast<std::int32_t>(i);
      }
      moves.push_back(last);
    } else {
      // Between beads: the next move of the motion that is not a point.
      const auto next = static_cast<std::size_t>(last + 1);
      if (next < path.size() && path.point(next) < 0) {
        last = static_cast<std::int32_t>(next);
      }
      moves.push_back(last);
    }
  }
  return moves;
}

}  // namespace

ProgramText linkProgram(const std::vector<plugin::OutputFile>& files, const PathModel& path) {
  ProgramText program;
  const std::vector<std::int32_t> wanted = movesOf(path);
  std::size_t found = 0;
  for (const plugin::OutputFile& file : files) {
    ProgramText::File shown;
    shown.name = file.name;
    shown.text = file.content;
    for (std::size_t begin = 0; begin <= file.content.size();) {
      std::size_t end = file.content.find('\n', begin);
      end = end == std::string::npos ? file.content.size() : end;
      shown.lineBegin.push_back(static_cast<std::uint32_t>(begin));
      const bool isMove = moves(std::string_view(file.content).substr(begin, end - begin));
      shown.moveOfLine.push_back(isMove ? static_cast<std::int32_t>(found) : -1);
      found += isMove ? 1 : 0;
      begin = end + 1;
    }
    program.files.push_back(std::move(shown));
  }
  program.linked = found == wanted.size() && found > 0;
  for (ProgramText::File& file : program.files) {
    for (std::int32_t& move : file.moveOfLine) {
      if (move >= 0) {
        move = program.linked ? wanted[static_cast<std::size_t>(move)] : -1;
      }
    }
  }
  return program;
}

}  // namespace wcam::gui
