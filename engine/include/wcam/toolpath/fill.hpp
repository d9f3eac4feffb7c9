// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/polygon2d.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <cstddef>
#include <vector>

namespace wcam::toolpath {

using geometry::Vec2;

/// How the inside of a layer is filled (Diourté M05).
enum class FillPattern {
  None,        ///< walls only
  Raster,      ///< parallel lines, all in one direction
  Zigzag,      ///< parallel lines joined along the border
  Contour,     ///< concentric insets until full
  Spiral,      ///< the insets joined, from outside to inside
  Hybrid,      ///< further insets, zigzag inside them
  Continuous,  ///< zigzag cells and walls joined into as few beads as there can be
  Medial       ///< insets, and beads of local width on the medial axis of what is left
};

/// What lies on the border of the section.
enum class BeadReference {
  Inside,  ///< the outer side of the outermost bead: the bead stays inside
  Centre,  ///< its centre
  Outside  ///< its inner side
};

enum class InsetOrder { Automatic, OutsideFirst, InsideFirst };

/// Lengths in mm, angles in rad.
struct FillOptions {
  FillPattern pattern = FillPattern::Zigzag;
  int walls = 1;           ///< contours along the border before the pattern
  int insets = 2;          ///< further contours of the hybrid pattern
  double width = 8.0;      ///< bead width
  double overlap = 0.667;  ///< centre distance of neighbouring beads, in widths (Ding 2015)
  double minWidth = 4.0;   ///< of beads whose width is chosen
  double maxWidth = 12.0;
  double angle = 0.0;      ///< of hatching lines
  double minLength = 5.0;  ///< shorter open beads are left out
  bool fillNarrow = true;  ///< a bead where the section is narrower than one, down to minWidth
  BeadReference reference = BeadReference::Inside;
  InsetOrder order =
      InsetOrder::Automatic;  ///< automatic: medial inside first, others outside first
  double tolerance = 0.01;

  [[nodiscard]] double spacing() const { return overlap * width; }

  /// Centre line of the outermost bead, inwards from the border, mm.
  [[nodiscard]] double firstCentreLine() const;
};

struct FillBead {
  geometry::Polyline2 points;  ///< material of closed ones on the left
  std::vector<double> widths;  ///< one per point; empty: the width of the options
  bool closed = false;
  BeadFeature feature = BeadFeature::Fill;
  int group = 0;  ///< order of deposition
};

/// A place where the section is narrower than a bead.
struct NarrowPlace {
  Vec2 p = Vec2::Zero();
  double thickness = 0.0;  ///< mm
  bool filled = false;
};

struct FillCoverage {
  double area = 0.0;     ///< of the region, mm²
  double covered = 0.0;  ///< part of it that beads cover, mm²
  Vec2 largestVoid = Vec2::Zero();
  double largestVoidArea = 0.0;

  [[nodiscard]] double coveredPart() const { return area > 0.0 ? covered / area : 1.0; }
};

struct FillResult {
  std::vector<FillBead> beads;  ///< by group, then in the order of making
  std::vector<NarrowPlace> narrow;
};

/// Beads that fill a region: walls along its border, then the pattern. Neighbouring beads lie
/// overlap·width apart; hatching lines exactly so. No centre line leaves the region shrunk by the
/// reference (by more than the tolerance), and none crosses itself.
/// @throws Error(InvalidArgument) for options out of range
/// Cost: dominated by the offsets, some µs per border point and inset.
FillResult fillRegion(const geometry::Region2& region, const FillOptions& options);

/// How much of the region the beads cover. @param width of beads without widths of their own
FillCoverage fillCoverage(const geometry::Region2& region,
                          const std::vector<FillBead>& beads,
                          const FillOptions& options);

}  // namespace wcam::toolpath
