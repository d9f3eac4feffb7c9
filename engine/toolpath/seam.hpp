// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/build.hpp"

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace wcam::toolpath {

/// A place on a closed contour: a part of the way from a point to the next one.
struct RingPlace {
  std::size_t index = 0;
  double fraction = 0.0;  ///< 0 ≤ fraction < 1
};

/// Index of the point of a contour that is nearest to p; the first of equals.
std::size_t nearestIndex(const Contour& contour, const Vec3& p);

/// The contour with its start moved to a place; between two points one is put there.
Contour startingAt(const Contour& contour, const RingPlace& place);

/// Chooses where closed contours start. Knows the starts of the last layers.
class SeamChooser {
public:
  SeamChooser(const PathParams& params, const Substrate& substrate);

  /// @param lastEnd where the torch is
  RingPlace choose(const Contour& contour,
                   std::size_t layerIndex,
                   std::size_t contourIndex,
                   const std::optional<Vec3>& lastEnd);
  /// Remembers the starts of a finished layer.
  void endLayer();

  /// Starts that could not keep their distance, since the last call.
  std::size_t takeTooClose() { return std::exchange(tooClose_, 0); }

private:
  [[nodiscard]] RingPlace aligned(const Contour& contour) const;
  RingPlace keptAway(const Contour& contour, const std::optional<Vec3>& lastEnd);
  [[nodiscard]] RingPlace corner(const Contour& contour) const;

  PathParams params_;
  geometry::Pose T_part_substrate_;
  std::deque<std::vector<Vec3>> remembered_;  ///< starts of the last layers
  std::vector<Vec3> current_;
  std::size_t tooClose_ = 0;
};

}  // namespace wcam::toolpath
