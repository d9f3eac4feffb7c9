// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/toolpath.hpp"

namespace wcam::process {

/// Beads of a layer that lie nearer together than their width share what is between them: each
/// fills up to the middle (centre distance times height, Ding 2015). On a free side a wall keeps
/// half the section of a wall that stands alone, a bead of cladding half of Ding's parabola, 2/3 of
/// width times height. Sets PathPoint::fillWidth where a bead has a neighbour on at least one side
/// and the strategy has set none. Neighbours are other beads of the layer and places of the same
/// bead farther along it than its turn to the other side; a spiral that climbs has none.
/// @param width of beads without one of their own, mm
/// Cost: about 1 µs per point.
void shareTouchingBeads(toolpath::Toolpath& path, double width, const JobContext& context);

}  // namespace wcam::process
