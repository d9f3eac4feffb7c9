// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace wcam::toolpath {

using geometry::Vec3;

/// How densely a curve is sampled: both bounds hold (Chalvin A3, A26).
struct Sampling {
  double chordError = 0.01;  ///< greatest sagitta between neighbouring points, mm
  double maxSpacing = 4.9;   ///< greatest distance between neighbouring points, mm
};

/// What the process can deposit, for strategies that keep inside it.
struct BeadRange {
  double heightMin = 1.0;  ///< least layer height, mm
  double heightMax = 7.0;  ///< greatest layer height, mm
  double width = 8.0;      ///< bead width, mm
};

/// A point of a layer on the part: exact position and outward unit normal, part frame. In a bead
/// that fills a layer n is the direction in the layer across the travel, so that t × n = up.
struct ContourPoint {
  Vec3 p = Vec3::Zero();
  Vec3 n = Vec3::UnitX();
  double height = 0.0;  ///< local layer height where the strategy knows it, mm; 0: the measured δ
  double width = 0.0;   ///< bead width where the strategy chooses it, mm; 0: the process's
  Vec3 axis = Vec3::Zero();  ///< tool axis that comes with the path; zero: by the axis rules
  /// Mean width that the bead fills up to its height beside its neighbours, mm: section = fillWidth
  /// times height. 0: a bead that stands alone.
  double fillWidth = 0.0;
};

/// What a bead is for.
enum class BeadFeature {
  Wall,      ///< on the part's surface
  Inset,     ///< parallel to a wall, inside a bulk part
  Fill,      ///< inside a layer
  Junction,  ///< where branches meet
  Cladding,  ///< on a face, across its normal
  Imported   ///< from a file
};

/// Stable name in reports: "wall", "inset", …
const char* toString(BeadFeature feature) noexcept;

/// A sampled level curve. A closed one does not repeat its first point. Direction: travel t with t
/// × n = up made tangent to the surface (n outward): outer contours run clockwise seen against the
/// build direction.
struct Contour {
  bool closed = false;
  int part = 0;
  std::vector<ContourPoint> points;
  BeadFeature feature = BeadFeature::Wall;
  int group = 0;  ///< contours of a lower group are deposited first
  /// Of a bead that climbs over several revolutions (a spiral): index of the first point of each
  /// revolution, ascending from 0. Empty for a bead of one layer.
  std::vector<std::size_t> turns;
  /// The points run against the direction in which t × n is the build direction, n being outward: a
  /// path that was reversed elsewhere.
  bool back = false;
};

struct SlicedLayer {
  double level = 0.0;             ///< mm along the build direction or the guide
  Vec3 up = Vec3::UnitZ();        ///< direction in which the layer grows (plane normal)
  double nominalHeight = 0.0;     ///< wanted distance to the layer below, mm
  std::vector<Contour> contours;  ///< ordered by part, then by the lowest mesh edge they cross
  /// Indices of the layers that lie directly below; nothing means the layer before. An empty list:
  /// only the substrate.
  std::optional<std::vector<std::size_t>> below;
};

struct SlicedLayers {
  std::vector<SlicedLayer> layers;  ///< in the order of deposition
  bool curved = false;  ///< layers are not planes: the build direction changes along a bead
  /// Order, starts and directions of the contours are kept: a path that was planned elsewhere.
  bool asGiven = false;
  /// False where the part stands on something that the path does not know (a shaft, a core): the
  /// strategy then gives the heights of what lies on that.
  bool onSubstrate = true;
};

}  // namespace wcam::toolpath
