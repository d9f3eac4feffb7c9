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

}  // namespace wcam::toolpath
