// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <vector>

namespace wcam::toolpath {

using geometry::Vec3;

/// How densely a curve is sampled: both bounds hold (Chalvin A3, A26).
struct Sampling {
  double chordError = 0.01;  ///< greatest sagitta between neighbouring points, mm
  double maxSpacing = 4.9;   ///< greatest distance between neighbouring points, mm
};

/// A point of a layer on the part: exact position and outward unit normal, part frame.
struct ContourPoint {
  Vec3 p = Vec3::Zero();
  Vec3 n = Vec3::UnitX();
};

/// A sampled level curve. A closed one does not repeat its first point. Direction: travel t with t
/// × n = up made tangent to the surface (n outward): outer contours run clockwise seen against the
/// build direction.
struct Contour {
  bool closed = false;
  int part = 0;
  std::vector<ContourPoint> points;
};

struct SlicedLayer {
  double level = 0.0;             ///< mm along the build direction or the guide
  Vec3 up = Vec3::UnitZ();        ///< direction in which the layer grows (plane normal)
  double nominalHeight = 0.0;     ///< wanted distance to the layer below, mm
  std::vector<Contour> contours;  ///< ordered by part, then by the lowest mesh edge they cross
};

struct SlicedLayers {
  std::vector<SlicedLayer> layers;  ///< in the order of deposition
};

}  // namespace wcam::toolpath
