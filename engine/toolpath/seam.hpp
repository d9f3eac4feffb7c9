// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/build.hpp"

#include <optional>
#include <vector>

namespace wcam::toolpath {

/// A contour that starts at its seam, in the direction in which it is deposited.
struct OrderedContour {
  Contour contour;
  bool reversed = false;  ///< against the direction that the strategy gave
};

/// Orders the contours of each layer (nearest next) and turns closed ones so that they start at
/// their seam. Keeps where the last bead ended from layer to layer.
class SeamChooser {
public:
  SeamChooser(const PathParams& params, const Substrate& substrate);
  std::vector<OrderedContour> arrange(const SlicedLayer& layer,
                                      std::size_t layerIndex,
                                      bool reversed);

private:
  [[nodiscard]] std::size_t seamIndex(const Contour& contour,
                                      std::size_t layerIndex,
                                      std::size_t contourIndex) const;

  PathParams params_;
  geometry::Pose T_part_substrate_;
  std::optional<Vec3> lastEnd_;
};

}  // namespace wcam::toolpath
