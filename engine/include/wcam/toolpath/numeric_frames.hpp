// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/slicing.hpp"

namespace wcam::toolpath {

/// Outward normals of a path that brings none, from its points alone (Chalvin A16b): at each point
/// the facet through both neighbours and the nearest point of the layers below, and the same
/// above; n is the mean of their normals. The side follows from "below is down", t × n = b, so that
/// no sign has to be propagated. With no layer on either side n lies across the layer's `up`.
///
/// Error: for a quarter torus at 5 mm and 500 points a layer below 1 % (mean of ‖n − exact‖).
/// Cost: O(n log n).
void setNumericNormals(SlicedLayers& layers, const JobContext& context = JobContext());

}  // namespace wcam::toolpath
