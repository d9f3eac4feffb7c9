// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace wcam::test {

/// Circle about z in a plane of height z, travelled as t × n = z asks for (clockwise from above).
inline toolpath::Contour circle(double radius,
                                double z,
                                const geometry::Vec3& centre = geometry::Vec3::Zero(),
                                int points = 72) {
  toolpath::Contour contour;
  contour.closed = true;
  for (int i = 0; i < points; ++i) {
    const double a = -2.0 * kPi * i / points;
    const geometry::Vec3 n(std::cos(a), std::sin(a), 0.0);
    contour.points.push_back({centre + radius * n + geometry::Vec3(0, 0, z), n});
  }
  return contour;
}

/// Climbs over `revolutions` about z from z = 0 on.
inline toolpath::Contour helix(double radius, double pitch, double revolutions, int perTurn) {
  toolpath::Contour contour;
  const int points = static_cast<int>(revolutions * perTurn) + 1;
  for (int i = 0; i < points; ++i) {
    const double a = -2.0 * kPi * i / perTurn;
    const geometry::Vec3 n(std::cos(a), std::sin(a), 0.0);
    contour.points.push_back({radius * n + geometry::Vec3(0, 0, pitch * i / perTurn), n});
    if (i % perTurn == 0) {
      contour.turns.push_back(static_cast<std::size_t>(i));
    }
  }
  return contour;
}

/// Closed polygon in the plane z with outward normals of its corners (mean of the two sides), given
/// clockwise from above.
inline toolpath::Contour polygon(const std::vector<geometry::Vec2>& corners, double z = 0.0) {
  toolpath::Contour contour;
  contour.closed = true;
  const std::size_t n = corners.size();
  const auto normal = [](const geometry::Vec2& from, const geometry::Vec2& to) {
    const geometry::Vec2 d = (to - from).normalized();
    return geometry::Vec2(-d.y(), d.x());
  };
  for (std::size_t i = 0; i < n; ++i) {
    const geometry::Vec2 m =
        (normal(corners[(i + n - 1) % n], corners[i]) + normal(corners[i], corners[(i + 1) % n]))
            .normalized();
    contour.points.push_back(
        {geometry::Vec3(corners[i].x(), corners[i].y(), z), geometry::Vec3(m.x(), m.y(), 0.0)});
  }
  return contour;
}

inline toolpath::SlicedLayer layerOf(double level, std::vector<toolpath::Contour> contours) {
  toolpath::SlicedLayer layer;
  layer.level = level;
  layer.nominalHeight = 2.0;
  layer.contours = std::move(contours);
  return layer;
}

}  // namespace wcam::test
