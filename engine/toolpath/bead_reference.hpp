// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/build.hpp"

#include <vector>

namespace wcam::toolpath {

/// Moves a contour by half the bead width inside its layer: along the outward normal (sign 1) or
/// against it (−1). Planar layers stay in their plane, curved ones follow the surface normal.
/// Outward corners get an arc, inward ones the point where both sides meet; whatever would lie
/// nearer to the contour than the offset is removed, so that no loop remains; a contour may fall
/// apart into several, or vanish (no contour). A bead of several revolutions is moved point by
/// point. Cost: O(n log n).
/// @param width of the bead, mm, where a point has none of its own
std::vector<Contour> offsetContour(const Contour& contour,
                                   const SlicedLayer& layer,
                                   bool curved,
                                   double sign,
                                   double width,
                                   const Sampling& sampling);

/// All contours of all layers moved so that the contour is the named side of the bead.
///
/// A wall that leans moves across itself and so up or down as well: what its first layer lies above
/// the substrate then is not its height any more. Layers that follow the wall (curved) are slid
/// back along it, the first until it is as high above the substrate as it was, those above by as
/// much as what lies below them, so that they stay a step apart.
///
/// Findings: toolpath.contour_vanished, one per layer; toolpath.top_moved where the last layers end
/// higher or lower than the part by more than half a step.
SlicedLayers withBeadReference(const SlicedLayers& sliced,
                               const Substrate& substrate,
                               const PathParams& params,
                               double width,
                               const JobContext& context);

}  // namespace wcam::toolpath
