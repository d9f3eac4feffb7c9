// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/mesh.hpp"
#include "wcam/toolpath/generatrices.hpp"

#include <vector>

namespace wcam::toolpath {

/// How far the surface lies from the strip between two neighbouring generatrices.
struct StripGap {
  double distance = 0.0;  ///< of the farthest mesh vertex, mm
  std::uint32_t vertex = 0;
};

/// For each pair (i, i+1) of neighbouring curves, the last with the first, the largest gap of the
/// mesh vertices that lie nearest to its strip (Diourté M14, Eq. 3.9 with the distance to the strip
/// instead of its vertices).
std::vector<StripGap> stripGaps(const geometry::TriangleMesh& mesh,
                                const std::vector<Generatrix>& curves,
                                double spacing);

}  // namespace wcam::toolpath
