// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/types.hpp"

#include <optional>
#include <vector>

namespace wcam::toolpath {

using geometry::Vec3;

/// Tool axis with lead angle θn (in the travel plane, positive leans forward along t) and lateral
/// tilt θt (towards n): T = (tan θn·t + tan θt·n + b) / √(1 + tan²θn + tan²θt). (t, n, b)
/// orthonormal. Chalvin A16 (closed form).
Vec3 tiltedAxis(const Vec3& t, const Vec3& n, const Vec3& b, Angle lead, Angle lateral);

/// The unit direction itself while it leans at most `limit` from the vertical, else the direction
/// of that lean in the plane of both (Chalvin A16c corrected: for b in the plane of n and the
/// vertical this is the tilt θt = β − limit). A direction straight down leans along any.
Vec3 limitedAxis(const Vec3& direction, const Vec3& vertical, Angle limit);

/// Unit projection of a direction on the plane of a normal (Chalvin A16c); nothing when it is
/// parallel to the normal.
std::optional<Vec3> projectedAxis(const Vec3& direction, const Vec3& normal);

struct SmoothedAxes {
  std::vector<Vec3> axes;
  double maxDeviation = 0.0;  ///< greatest angle between a wanted and a smoothed axis, rad
};

/// Axes that turn by at most `rate` between neighbours, each as near to its wanted one as its
/// neighbours then allow: the mean of the two fields that follow the wanted axes from either end at
/// this rate, drawn back towards the wanted axes as far as the bound lets them. Axes that hold the
/// bound are returned as they are.
/// @param positions of the points, mm; a closed path repeats its first point and axis as the last
/// @param rate rad per mm of path, positive
/// Cost: O(n) per pass, at most a few dozen passes over what moves.
SmoothedAxes smoothedAxes(const std::vector<Vec3>& positions,
                          const std::vector<Vec3>& wanted,
                          bool closed,
                          double rate);

}  // namespace wcam::toolpath
