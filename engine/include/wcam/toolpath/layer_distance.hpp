// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/types.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <vector>

namespace wcam::toolpath {

/// Local inter-layer distance δ of points to the layer below: the least distance to its segments,
/// vertices and closing segments included (Chalvin A4, Eq. 2.20 completed). Infinity when the layer
/// below has no contour. Cost: O((n + m) log m) for n points over m segments.
std::vector<double> layerDistance(const std::vector<Vec3>& points,
                                  const std::vector<Contour>& below);

/// The same over contours of several layers.
std::vector<double> layerDistance(const std::vector<Vec3>& points,
                                  const std::vector<const Contour*>& below);

/// Distance of the points of a bead that climbs over several revolutions to the bead itself about
/// one revolution before: to its segments from 1.5 to 0.5 revolutions back, counted by arc length
/// inside each revolution. Infinity in the first revolution. Cost: O(n log n).
/// @param points of the bead; the contour's own points or points that replace them one by one
/// @param turns first point of each revolution (Contour::turns)
std::vector<double> revolutionDistance(const std::vector<Vec3>& points,
                                       const std::vector<std::size_t>& turns);

}  // namespace wcam::toolpath
