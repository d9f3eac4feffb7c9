// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/build.hpp"

namespace wcam::toolpath {

/// Adds what stands at the start and the end of a bead: overlap of a closed bead past its seam,
/// ramps of speed and wire feed (the factor of each move is that of its middle), tangential runs
/// before and after, and the wipe back over the bead with the arc off. Ramps that together are
/// longer than the bead are shortened in proportion. A bead of fewer than two points stays as it
/// is.
void addZones(Bead& bead, const ZoneParams& zones);

}  // namespace wcam::toolpath
