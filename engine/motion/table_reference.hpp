// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

namespace wcam::motion::detail {

/// References of a two-axis positioner that the speed of its last axis allows.
///
/// Where the build direction passes the last axis (the table's) closely, turning it exactly to the
/// vertical takes up to half a turn of the table within a few millimetres. But there the turn
/// hardly matters: with the best tilt for a turn ψ of the table the build direction leans by
/// |asin(k1·R(k2, ψ)·up) − asin(k1·vertical)|, k1 and k2 the axes. The turns that lean by less than
/// an angle are two arcs (the two solutions of the exact problem), which join near the axis, so
/// that the way may also lead straight through it, the tilt changing its sign. Through these arcs
/// the way with the least square of the table's speed is chosen over the whole operation (dynamic
/// programming over samples of the arcs) and pulled taut (taut_string.hpp). Exact everywhere but
/// near the steps that would be too fast; there it leans by a part of the vertical tolerance, the
/// smallest of a few that suffices. Where the direction leans so little from the table's axis that
/// every turn will do, the table rests, in travel moves as well.
///
/// @param aligned exact references, for the least lean of each target
/// @returns up to two references that start a half turn apart, or none where the exact ones are
/// slow enough and never turn over there, where the cell has no two rotary axes or the second is
/// coupled to the first, or where a limited last axis finds no way
std::vector<Positioning> slowerReferences(const Cell& cell,
                                          const MotionParams& params,
                                          const std::vector<Target>& targets,
                                          const Runs& runs,
                                          const Positioning& aligned,
                                          const JobContext& context);

}  // namespace wcam::motion::detail
