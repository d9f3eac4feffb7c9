// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/plugin/post.hpp"

#include "path_model.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace wcam::gui {

/// A posted program with the move that each line makes.
struct ProgramText {
  struct File {
    std::string name;
    std::string text;
    std::vector<std::uint32_t> lineBegin;  ///< offset of each line
    std::vector<std::int32_t> moveOfLine;  ///< −1: the line moves nothing
  };

  std::vector<File> files;
  bool linked = false;  ///< lines and moves belong together one by one
};

/// Finds the lines that move the robot (FANUC LS, KUKA KRL and the other languages of DESIGN 9 by
/// their motion words) and ties them to the moves in order. When their number differs from that of
/// the program's motion instructions, nothing is linked.
ProgramText linkProgram(const std::vector<plugin::OutputFile>& files, const PathModel& path);

}  // namespace wcam::gui
