// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/types.hpp"

#include <cstddef>
#include <vector>

namespace wcam::toolpath {

using geometry::Vec3;

/// A closed polyline with its arc lengths; the first point is not repeated.
class Loop {
public:
  explicit Loop(std::vector<Vec3> points);

  [[nodiscard]] double length() const noexcept { return arc_.back(); }

  [[nodiscard]] const std::vector<Vec3>& points() const noexcept { return points_; }

  /// Point at an arc length from the first point, any number of times around.
  [[nodiscard]] Vec3 at(double arc) const;
  /// Unit direction of travel at an arc length.
  [[nodiscard]] Vec3 direction(double arc) const;
  /// Arc length of the point nearest to a place.
  [[nodiscard]] double nearest(const Vec3& place) const;
  /// `count` points at equal arc lengths from a start.
  [[nodiscard]] std::vector<Vec3> resampled(std::size_t count, double start) const;
  /// Greatest distance of the loop's points to the polygon of `count` points.
  [[nodiscard]] double deviation(std::size_t count) const;
  [[nodiscard]] Loop reversed() const;

private:
  [[nodiscard]] std::size_t segmentAt(double& arc) const;

  std::vector<Vec3> points_;
  std::vector<double> arc_;  ///< at each point, then the whole length
};

}  // namespace wcam::toolpath
