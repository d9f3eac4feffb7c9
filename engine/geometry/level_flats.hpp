// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/level_set.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wcam::geometry {

/// Decides for whole faces and borders that lie on a level up to a tolerance, on which side of it
/// they are: a face that a file's rounding or a little noise scatters about a level would be torn
/// into pieces otherwise.
///
/// A flat is a connected set of triangles and border edges all of whose vertices lie within four
/// tolerances of one level. It counts as on the level, hence above, when it comes within one
/// tolerance of it; at the level that is the minimum of the field it counts as below. Noise of the
/// tolerance therefore never parts a face. What slopes through the whole range, and the cap of a
/// dome that is as wide as its height makes it, is no flat and keeps its counts.
///
/// @param count per vertex the levels at or below it, HalfEdges::kNone outside the field; corrected
/// @param snap its tolerances of flats and borders; bounded by a part of the levels' distance
/// @return per vertex the level on which it was put, HalfEdges::kNone for none; empty without flats
/// Cost: O(vertices + triangles); nothing is allocated where no triangle is flat.
std::vector<std::uint32_t> settleFlats(const TriangleMesh& mesh,
                                       const HalfEdges& halfEdges,
                                       std::span<const double> scalar,
                                       std::span<const double> levels,
                                       const LevelSnap& snap,
                                       std::vector<std::uint32_t>& count);

}  // namespace wcam::geometry
