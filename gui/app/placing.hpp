// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/project/model.hpp"

namespace wcam::gui {

/// The placement that stands a part in the middle of a substrate's top, z = 0 of its frame.
/// @param surface the part where `T_part_file` has put it
/// @param face this CAD face looks down on the substrate then; −1: the part is not turned
project::Placement placedOn(const geometry::PartSurface& surface,
                            const geometry::Pose& T_part_file,
                            const geometry::Pose& T_part_substrate,
                            int face);

}  // namespace wcam::gui
