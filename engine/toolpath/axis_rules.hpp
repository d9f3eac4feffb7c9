// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "bead_order.hpp"

#include <vector>

namespace wcam::toolpath {

/// Gives the points of a layer's beads their build direction to be turned upright (`up`) and their
/// tool axis, by the rules of the parameters in this order: direction, projection on a plane, limit
/// from the vertical, smoothing, lead and lateral tilt, smoothing again where these turn. The beads
/// have their frames, and belong one by one to the contours.
/// Findings: toolpath.axis_not_projected, toolpath.axis_smoothed, one of each per layer.
void setAxes(Layer& layer,
             const std::vector<OrderedContour>& contours,
             bool curved,
             const Substrate& substrate,
             const PathParams& params,
             int layerIndex,
             const JobContext& context);

}  // namespace wcam::toolpath
