// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"
#include "wcam/motion/placement.hpp"
#include "wcam/project/commands.hpp"

#include <string>
#include <vector>

namespace wcam::project {

/// The commands that move the parts and the substrate of an operation by a pose of the part frame.
/// Other operations that use them move along.
/// @throws Error(ProjectInvalid) when the operation also depends on what does not move with them: a
/// path from a file, or a guide that is a polyline or a formula
std::vector<Command> placementCommands(const Document& document,
                                       const std::string& operation,
                                       const geometry::Pose& move);

/// {"best": index, "places": [{"move_mm", "turn_deg", "failing_points", …}]}.
Value toValue(const motion::PlacementMap& map);
/// One row per place, header line, comma separated, dot decimals, LF.
std::string toCsv(const motion::PlacementMap& map);

}  // namespace wcam::project
