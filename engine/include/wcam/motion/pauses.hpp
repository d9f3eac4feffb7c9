// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/motion.hpp"
#include "wcam/toolpath/toolpath.hpp"

namespace wcam::motion {

/// Does any bead wait before or after itself?
bool hasPauses(const toolpath::Toolpath& path) noexcept;

/// The motion with the pauses of the beads (Bead::pauseBefore, pauseAfter): the torch stands at the
/// last point of the move that leads above the start of the bead, and at the last point of the
/// bead's own moves, where it has been lifted off; times behind it are later. Linear.
PlannedMotion withPauses(PlannedMotion planned, const toolpath::Toolpath& path);

/// The motion with the crater fill at the end of each bead: the torch stands there with the arc on,
/// and times behind it are later. Linear.
/// @param seconds of one crater
PlannedMotion withCraters(PlannedMotion planned, double seconds);

}  // namespace wcam::motion
