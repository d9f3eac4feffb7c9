// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// The borders of a part by what they are for: vertices of each loop, as HalfEdges::borderLoops
/// gives them.
struct PartEnds {
  std::vector<std::vector<std::uint32_t>> lower;  ///< on which the part stands
  std::vector<std::vector<std::uint32_t>> upper;  ///< where it ends: one, or one per branch
  std::vector<std::vector<std::uint32_t>> holes;  ///< small openings in the wall
};

/// Sorts the borders (Diourté M10). Lower are those whose mean height along `up` is that of the
/// lowest one to 2 % of the part's height. A border shorter than a tenth of the longest is a hole.
PartEnds partEnds(const TriangleMesh& mesh, const HalfEdges& halfEdges, const Vec3& up);

/// A field that grows from the lower end of a part to all its other ends, with no extremum that the
/// shape does not force: harmonic from 0 to 1 where there are upper borders; else the distance from
/// the lower border or, on a closed surface, from its lowest points. Components without an end have
/// no value (NaN).
std::vector<double> endToEndField(const TriangleMesh& mesh,
                                  const HalfEdges& halfEdges,
                                  const PartEnds& ends,
                                  const Vec3& up);

}  // namespace wcam::geometry
