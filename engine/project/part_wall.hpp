// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/io/import.hpp"

#include <string>
#include <vector>

namespace wcam::project {

/// Replaces the surface of a part by one side of its solid wall, and reports the wall's thickness
/// (part.wall_thickness). @throws Error of geometry::solidWall
void takeSide(io::ImportedPart& part,
              geometry::WallSide side,
              const std::string& id,
              const JobContext& context);

/// Finding part.bead_does_not_fit_wall for a wall that is more than a quarter thicker or thinner
/// than the bead is wide.
std::vector<Diagnostic> compareWithBead(const io::ImportedPart& part,
                                        const std::string& id,
                                        double beadWidth);

}  // namespace wcam::project
