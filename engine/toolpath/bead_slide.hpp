// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

namespace wcam::toolpath {

/// Slides the contours of layers that follow a wall along it, after they were moved across it by
/// half a bead (bead_reference.hpp): the first until it is as high above the substrate as the
/// contour it comes from, those above by as much as what lies below them.
///
/// @param sliced the contours before they were moved
/// @param moved the same layers with the moved contours; changed
/// @param sign +1 where the contours were moved along the outward normals, −1 against them
/// @param width of the bead, mm, where a point has none of its own
/// Findings: toolpath.top_moved.
void slideToSubstrate(const SlicedLayers& sliced,
                      const Substrate& substrate,
                      double sign,
                      double width,
                      SlicedLayers& moved,
                      const JobContext& context);

}  // namespace wcam::toolpath
