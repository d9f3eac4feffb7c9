// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"

namespace wcam::geometry {

/// How far a mesh lies from the smooth shape that it stands for, mm: the mean over its curved edges
/// of the sagitta of a facet, w·θ/8, θ the angle between the two triangles of an edge and w their
/// mean extent across it. Flat and sharp edges are shape, not error. 0 for a part with an exact
/// surface and for a mesh without curved edges. Cost: O(n).
double meshDeviation(const PartSurface& part);

}  // namespace wcam::geometry
