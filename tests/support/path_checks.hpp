// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <string>
#include <vector>

namespace wcam::test {

/// What every strategy's layers must hold, whatever the part. Each function gives one line per
/// violation, empty when all is well; every check goes over all points.

/// Layers and contours are not empty, numbers are finite, normals are unit vectors, neighbouring
/// points differ and lie no farther apart than the sampling allows.
std::vector<std::string> brokenContours(const toolpath::SlicedLayers& sliced,
                                        const toolpath::Sampling& sampling);

/// Points of walls that do not lie on any of the parts (exact surface, or mesh of mesh parts)
/// within a tolerance, mm.
std::vector<std::string> pointsOffSurface(
    const toolpath::SlicedLayers& sliced,
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    double tolerance);

std::vector<std::string> pointsInSubstrate(const toolpath::SlicedLayers& sliced,
                                           const toolpath::Substrate& substrate,
                                           double tolerance);

/// Beads that cross themselves.
std::vector<std::string> crossingBeads(const toolpath::SlicedLayers& sliced);

}  // namespace wcam::test
