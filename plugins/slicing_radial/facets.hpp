// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"

#include <functional>
#include <vector>

namespace wcam::radial {

/// Values of a round field at the vertices of a refined part. Facets and border edges of a mesh
/// whose corners all have one value stand for a piece of the round surface through their corners,
/// whose chords dip below it: the whole facet or edge takes the value of its corners. Those that
/// dip by more than a part of the step are flat for themselves, such as the sides of a prism, and
/// keep the field's own values, as does every exact part.
/// @param given the part before it was refined
/// @param tolerance to which corners have the same value
/// Cost: one nearest-facet query per refined vertex near such a facet or edge.
std::vector<double> valuesOnFacets(const geometry::PartSurface& given,
                                   const geometry::PartSurface& refined,
                                   const std::function<double(const geometry::Vec3&)>& field,
                                   double step,
                                   double tolerance);

}  // namespace wcam::radial
