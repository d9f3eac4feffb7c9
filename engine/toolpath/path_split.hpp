// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/toolpath.hpp"

#include <vector>

namespace wcam::toolpath {

/// Nearer to a point than this (mm, along the path) no new one is made.
inline constexpr double kSamePlace = 1e-6;

/// A point on the chord from a to b: its frame is made orthonormal again; what belongs to the move
/// that ends there is that of b.
PathPoint pointBetween(const PathPoint& a, const PathPoint& b, double fraction);

/// Splits the move in which an arc length lies.
void splitAt(std::vector<PathPoint>& points, double length);

double lengthOf(const std::vector<PathPoint>& points);

}  // namespace wcam::toolpath
