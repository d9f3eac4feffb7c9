// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/cell/kinematics.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// What no motion of a two-axis positioner can do better: written from the geometry alone, sharing
/// nothing with the planner.
namespace wcam::test {

/// Ranges of the tilt for each turn of the table, as a list of cells of equal width.
class TiltRanges {
public:
  static constexpr int kCells = 2880;
  static constexpr double kWidth = 2.0 * std::numbers::pi / kCells;

  TiltRanges() : low(kCells, kNone), high(kCells, -kNone) {}

  [[nodiscard]] bool empty() const {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] <= high[i]) {
        return false;
      }
    }
    return true;
  }

  /// All that is at most `cells` cells and `tilt` away.
  [[nodiscard]] TiltRanges widened(int cells, double tilt) const {
    TiltRanges result;
    const int window = std::min(2 * cells + 1, kCells);
    // Extremes of windows of powers of two, then of two of them that overlap.
    std::vector<double> l = low;
    std::vector<double> h = high;
    int size = 1;
    for (; 2 * size <= window; size *= 2) {
      const std::vector<double> l0 = l;
      const std::vector<double> h0 = h;
      for (int i = 0; i < kCells; ++i) {
        l[at(i)] = std::min(l0[at(i)], l0[at(i + size)]);
        h[at(i)] = std::max(h0[at(i)], h0[at(i + size)]);
      }
    }
    for (int i = 0; i < kCells; ++i) {
      const int first = i - window / 2;
      const int last = first + window - size;
      result.low[at(i)] = std::min(l[at(first)], l[at(last)]) - tilt;
      result.high[at(i)] = std::max(h[at(first)], h[at(last)]) + tilt;
    }
    return result;
  }

  void intersect(const TiltRanges& other) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      low[i] = std::max(low[i], other.low[i]);
      high[i] = std::min(high[i], other.high[i]);
      if (low[i] > high[i]) {
        low[i] = kNone;
        high[i] = -kNone;
      }
    }
  }

  static std::size_t at(int i) { return static_cast<std::size_t>((i % kCells + kCells) % kCells); }

  static constexpr double kNone = 1e9;
  std::vector<double> low, high;
};

/// Positions of the positioner (both axes uncoupled turns) that hold a direction within `tolerance`
/// of the vertical, tilt per turn of the table.
inline TiltRanges uprightRanges(const cell::Cell& cell,
                                const geometry::Vec3& up,
                                double tolerance) {
  using geometry::Vec3;
  const double zero[2] = {};
  const cell::ChainAxes axes = cell::chainAxes(cell.positioner, zero);
  const Vec3 k1 = axes.directions[0];
  const Vec3 vertical = cell.verticalInBase();
  const Vec3 flat = vertical - k1 * k1.dot(vertical);
  const Vec3 start = axes.T_root_tip.linear() * cell.T_table_part.linear() * up;
  const cell::Joint& tilt = cell.joint(cell.robotJoints());
  TiltRanges ranges;
  for (int i = 0; i < TiltRanges::kCells; ++i) {
    const Vec3 v = Eigen::AngleAxisd(i * TiltRanges::kWidth, axes.directions[1]) * start;
    const Vec3 across = v - k1 * k1.dot(v);
    const double middle = std::atan2(k1.dot(across.cross(flat)), across.dot(flat));
    const double cosine =
        (std::cos(tolerance) - k1.dot(v) * k1.dot(vertical)) / (across.norm() * flat.norm());
    if (cosine <= 1.0) {
      const double half = std::acos(std::max(cosine, -1.0));
      const double low =
          std::max(middle - half, std::min(tilt.sign * tilt.min, tilt.sign * tilt.max));
      const double high =
          std::min(middle + half, std::max(tilt.sign * tilt.min, tilt.sign * tilt.max));
      if (low <= high) {
        ranges.low[TiltRanges::at(i)] = low;
        ranges.high[TiltRanges::at(i)] = high;
      }
    }
  }
  return ranges;
}

/// Could any motion of a two-axis positioner (endless table) keep every bead's build directions
/// within `tolerance` of the vertical at the path's travel speeds, with both axes at up to `ratio`
/// times their greatest speed? The set of all positions that can be reached is followed from point
/// to point. It is too large rather than too small: a cell stands for all turns in it (its own
/// directions may lean by half a cell more, and one cell more is in reach), and ranges of the tilt
/// are joined. So "no" is a proof, "yes" is none.
inline bool positionerMayFollow(const cell::Cell& cell,
                                const toolpath::Toolpath& path,
                                double tolerance,
                                double ratio) {
  const double tilting = cell.joint(cell.robotJoints()).maxSpeed * ratio;
  const double turning = cell.joint(cell.jointCount() - 1).maxSpeed * ratio;
  const double wide = tolerance + 0.5 * TiltRanges::kWidth;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      TiltRanges reached;
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        TiltRanges ranges = uprightRanges(cell, bead.points[i].up, wide);
        if (i > 0) {
          const double length = (bead.points[i].p - bead.points[i - 1].p).norm();
          const double time = length / bead.points[i].speed;
          const double cells = std::min(turning * time / TiltRanges::kWidth + 1.0,
                                        static_cast<double>(TiltRanges::kCells));
          ranges.intersect(reached.widened(static_cast<int>(cells), tilting * time));
        }
        if (ranges.empty()) {
          return false;
        }
        reached = std::move(ranges);
      }
    }
  }
  return true;
}

}  // namespace wcam::test
