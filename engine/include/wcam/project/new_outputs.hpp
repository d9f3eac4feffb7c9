// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"
#include "wcam/plugin/host.hpp"

#include <filesystem>

namespace wcam::project {

/// The list of outputs of a new project: the post-processor that writes for the controller of its
/// cell. Without a cell, or where the file does not name a controller: FANUC's; empty where no
/// post-processor writes for it.
/// @param cell the cell file; empty for none
Value newOutputs(const plugin::PluginHost& plugins, const std::filesystem::path& cell);

/// The cell of a new project that names none, without folder and ending.
inline constexpr const char* kDefaultCell = "fanuc_arcmate120ic";

/// The plate of a new project: of 10 mm; where the robot carries the part, as thick as the holder
/// on the flange whose place it takes.
Value newPlate(const std::filesystem::path& cell);

}  // namespace wcam::project
