// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/fill.hpp"

#include <vector>

namespace wcam::toolpath::detail {

using geometry::Polyline2;
using geometry::Region2;

/// Zigzag cells of hatching lines: runs of lines that follow each other without a branch, joined
/// along the border of the region. Each may be laid in four ways: from either end, and with the
/// first line in either direction.
struct ZigzagCell {
  Polyline2 forward;   ///< first line towards b
  Polyline2 backward;  ///< first line towards a
};

/// Phase for lines through the region so that the space left at both sides is equal.
double centredPhase(const Region2& region, double angle, double spacing);

/// Lines through each island of the region, all in one direction.
std::vector<Polyline2> rasterLines(const Region2& region, double angle, double spacing);
std::vector<ZigzagCell> zigzagCells(const Region2& region, double angle, double spacing);

/// Loops of each inset, outermost first, joined from outside to inside where one follows another:
/// each loop runs until one spacing before its start and goes over to the next. A loop that splits
/// ends its spiral; its parts begin their own.
/// @param goals where spirals should end, if there are any: each goes to the nearest one
std::vector<Polyline2> spirals(const std::vector<Region2>& insets,
                               double spacing,
                               const std::vector<Vec2>& goals = {});

/// A piece for joining: either way round; a cell offers two polylines.
struct Joinable {
  std::vector<Polyline2> ways;
};

/// Pieces joined end to end where the straight bridge is no longer than `reach` and stays inside
/// the region: greedy from the first piece, nearest first. Deterministic.
std::vector<Polyline2> joinPieces(const std::vector<Joinable>& pieces,
                                  const Region2& region,
                                  double reach);

}  // namespace wcam::toolpath::detail
