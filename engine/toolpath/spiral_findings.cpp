// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spiral_findings.hpp"

#include "wcam/base/text.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>

namespace wcam::toolpath {

void SpiralHeights::add(double height, const SpiralTurn& turn) {
  if (!(turn.highest > 0.0)) {
    return;
  }
  ++points;
  least = std::min(least, height);
  greatest = std::max(greatest, height);
  const double over =
      std::max((turn.lowest - height) / turn.lowest, (height - turn.highest) / turn.highest);
  if (over > 0.0) {
    ++outside;
    if (over > excess) {
      excess = over;
      low = turn.lowest;
      high = turn.highest;
      worst = height;
    }
  }
}

void reportSpiralHeights(const SpiralHeights& heights, const JobContext& context) {
  if (heights.outside == 0) {
    return;
  }
  context.add(
      {Severity::Warning,
       "slicing.spiral_height",
       text(
           heights.outside == 1
               ? "%1 point has a deposit height outside of its range; the worst is %2 mm where %3 "
                 "to %4 mm are wanted"
               : "%1 points have a deposit height outside of their range; the worst is %2 mm where "
                 "%3 to %4 mm are wanted",
           {std::to_string(heights.outside), formatFixed(heights.worst, 3),
            formatFixed(heights.low, 3), formatFixed(heights.high, 3)}),
       "a wider modulation range or another decomposition may help",
       {{}, 0, -1, -1},
       {{"points", static_cast<double>(heights.outside)},
        {"height_mm", heights.worst},
        {"height_min_mm", heights.least},
        {"height_max_mm", heights.greatest}}});
}

std::vector<std::size_t> thinned(const std::vector<ContourPoint>& points,
                                 std::size_t from,
                                 std::size_t to,
                                 const Sampling& sampling) {
  std::vector<std::size_t> kept{from};
  std::size_t anchor = from;
  for (std::size_t i = from + 1; i < to; ++i) {
    bool keep = i + 1 == to || (points[i + 1].p - points[anchor].p).norm() > sampling.maxSpacing;
    for (std::size_t k = anchor + 1; k <= i && !keep; ++k) {
      keep = geometry::distanceToSegment(points[k].p, points[anchor].p, points[i + 1].p) >
             sampling.chordError;
    }
    if (keep) {
      kept.push_back(i);
      anchor = i;
    }
  }
  return kept;
}

void thinSpiral(Contour& spiral, const Sampling& sampling) {
  std::vector<ContourPoint> points;
  std::vector<std::size_t> turns;
  for (std::size_t k = 0; k < spiral.turns.size(); ++k) {
    turns.push_back(points.size());
    const bool last = k + 1 == spiral.turns.size();
    // Up to the next revolution's first point, which that one keeps.
    const std::size_t end = last ? spiral.points.size() : spiral.turns[k + 1] + 1;
    const std::vector<std::size_t> kept = thinned(spiral.points, spiral.turns[k], end, sampling);
    for (std::size_t i = 0; i + (last ? 0 : 1) < kept.size(); ++i) {
      points.push_back(spiral.points[kept[i]]);
    }
  }
  spiral.points = std::move(points);
  spiral.turns = std::move(turns);
}

}  // namespace wcam::toolpath
