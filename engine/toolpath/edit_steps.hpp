// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/edits.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wcam::toolpath::detail {

/// "the edit 'slow' (set_speed)".
Text nameOf(const Edit& edit);

/// First and last index of the layers that an edit means; nothing when there are none of them.
std::optional<std::pair<std::size_t, std::size_t>> layersOf(std::size_t layers, const Edit& edit);
/// The same. Finding: edit.range_clipped
std::optional<std::pair<std::size_t, std::size_t>> layersOf(const Toolpath& path,
                                                            const Edit& edit,
                                                            const JobContext& context);

// Each returns how many layers, beads or moves it changed.

std::size_t moveSeam(Bead& bead, const Vec3& up, const Edit& edit, const ZoneParams& zones);
std::size_t reverseBead(Bead& bead, const Edit& edit, const ZoneParams& zones);
/// May cut the bead: the second part is added behind it in the list.
std::size_t pauseBead(std::vector<Bead>& beads,
                      std::size_t bead,
                      const Edit& edit,
                      const ZoneParams& zones);
/// Marks the moves inside the region.
std::size_t changeProcess(Bead& bead, const Edit& edit);
/// @param limited counts points whose lean was limited
std::size_t tiltAxes(Bead& bead, const Edit& edit, std::size_t& limited);

std::size_t deleteLayers(Toolpath& path, const Edit& edit, const JobContext& context);
std::size_t repeatLayers(Toolpath& path, const Edit& edit, const JobContext& context);

/// A bead whose moves are split at the border of a region.
struct SplitBead {
  std::vector<PathPoint> points;
  std::vector<bool> inside;  ///< the move that ends at the point; of the first point: false
};

SplitBead splitAtRegion(const std::vector<PathPoint>& points, const EditParams& params);
/// First and last point of the body: what lies between the runs onto and off the bead.
std::pair<std::size_t, std::size_t> bodyOf(const std::vector<PathPoint>& points);

}  // namespace wcam::toolpath::detail
