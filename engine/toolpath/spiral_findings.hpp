// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/spiral_law.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace wcam::toolpath {

/// Deposit heights of a spiral against the ranges that its revolutions promise (Diourté Eq. 3.15).
struct SpiralHeights {
  std::size_t points = 0;                                  ///< of revolutions that promise a range
  std::size_t outside = 0;                                 ///< of these outside of their range
  double least = std::numeric_limits<double>::infinity();  ///< of all these points, mm
  double greatest = 0.0;
  double excess = 0.0;  ///< greatest excess over its range, relative to the end that is passed
  double low = 0.0;     ///< the range of that point, mm
  double high = 0.0;
  double worst = 0.0;  ///< its height, mm

  void add(double height, const SpiralTurn& turn);
};

/// Finding slicing.spiral_height where points lie outside of the range.
void reportSpiralHeights(const SpiralHeights& heights, const JobContext& context);

/// Drops points of a spiral whose removal keeps the chord error, as far as the spacing allows; the
/// first point of each revolution stays.
void thinSpiral(Contour& spiral, const Sampling& sampling);

/// The points of [from, to) that such a thinning keeps.
std::vector<std::size_t> thinned(const std::vector<ContourPoint>& points,
                                 std::size_t from,
                                 std::size_t to,
                                 const Sampling& sampling);

}  // namespace wcam::toolpath
