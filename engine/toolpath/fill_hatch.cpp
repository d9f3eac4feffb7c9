// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fill_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wcam::toolpath::detail {

using geometry::HatchSegment;

namespace {

/// A connection along the border may be this much longer than the straight one, and one spacing
/// more; a longer one would lay a bead where others lie.
constexpr double kDetour = 2.0;

/// Border from one crossing to another, without the crossings themselves.
Polyline2 borderPath(const Polyline2& loop,
                     std::uint32_t fromEdge,
                     const Vec2& from,
                     std::uint32_t toEdge,
                     const Vec2& to) {
  const std::size_t n = loop.size();
  Polyline2 ahead;
  Polyline2 back;
  if (fromEdge != toEdge) {
    for (std::size_t i = (fromEdge + 1) % n;; i = (i + 1) % n) {
      ahead.push_back(loop[i]);
      if (i == toEdge) {
        break;
      }
    }
    for (std::size_t i = fromEdge;; i = (i + n - 1) % n) {
      back.push_back(loop[i]);
      if (i == (toEdge + 1) % n) {
        break;
      }
    }
  }
  const auto length = [&](const Polyline2& path) {
    double sum = 0.0;
    Vec2 last = from;
    for (const Vec2& p : path) {
      sum += (p - last).norm();
      last = p;
    }
    return sum + (to - last).norm();
  };
  return length(ahead) <= length(back) ? ahead : back;
}

double pathLength(const Vec2& from, const Polyline2& between, const Vec2& to) {
  double sum = 0.0;
  Vec2 last = from;
  for (const Vec2& p : between) {
    sum += (p - last).norm();
    last = p;
  }
  return sum + (to - last).norm();
}

class CellBuilder {
public:
  CellBuilder(const Region2& island, double angle, double spacing)
      : island_(island),
        spacing_(spacing),
        along_(std::cos(angle), std::sin(angle)),
        segments_(
            geometry::hatchRegion(island, angle, spacing, centredPhase(island, angle, spacing))) {}

  std::vector<ZigzagCell> build() {
    link();
    std::vector<ZigzagCell> cells;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (!hasBelow_[i]) {
        addRun(i, cells);
      }
    }
    return cells;
  }

private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] bool overlap(const HatchSegment& s, const HatchSegment& o) const {
    return s.a.dot(along_) < o.b.dot(along_) && o.a.dot(along_) < s.b.dot(along_);
  }

  /// A segment goes on in the one above it when neither has another neighbour on that side.
  void link() {
    const std::size_t n = segments_.size();
    above_.assign(n, kNone);
    hasBelow_.assign(n, false);
    std::vector<int> up(n, 0), down(n, 0);
    std::vector<std::size_t> candidate(n, kNone);
    std::size_t nextLine = 0;
    for (std::size_t i = 0; i < n; ++i) {
      while (nextLine < n && segments_[nextLine].line <= segments_[i].line) {
        ++nextLine;
      }
      for (std::size_t j = nextLine; j < n && segments_[j].line == segments_[i].line + 1; ++j) {
        if (overlap(segments_[i], segments_[j])) {
          ++up[i];
          ++down[j];
          candidate[i] = j;
        }
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (up[i] == 1 && down[candidate[i]] == 1) {
        above_[i] = candidate[i];
        hasBelow_[candidate[i]] = true;
      }
    }
  }

  /// Appends segment j to a path that ends on segment i; false when the border between is too long.
  bool append(Polyline2& path, std::size_t i, std::size_t j, bool towardsB) const {
    const HatchSegment& s = segments_[i];
    const HatchSegment& t = segments_[j];
    const Vec2 from = towardsB ? s.b : s.a;
    const Vec2 to = towardsB ? t.b : t.a;
    const std::uint32_t loopFrom = towardsB ? s.loopB : s.loopA;
    const std::uint32_t loopTo = towardsB ? t.loopB : t.loopA;
    if (loopFrom != loopTo) {
      return false;
    }
    const Polyline2 border = borderPath(island_.loops[loopFrom], towardsB ? s.edgeB : s.edgeA, from,
                                        towardsB ? t.edgeB : t.edgeA, to);
    if (pathLength(from, border, to) > kDetour * (to - from).norm() + spacing_) {
      return false;
    }
    path.insert(path.end(), border.begin(), border.end());
    path.push_back(to);
    path.push_back(towardsB ? t.a : t.b);
    return true;
  }

  [[nodiscard]] Polyline2 zigzag(const std::vector<std::size_t>& run, bool towardsB) const {
    const HatchSegment& first = segments_[run[0]];
    Polyline2 path{towardsB ? first.a : first.b, towardsB ? first.b : first.a};
    for (std::size_t k = 1; k < run.size(); ++k) {
      if (!append(path, run[k - 1], run[k], towardsB)) {
        return {};
      }
      towardsB = !towardsB;
    }
    return path;
  }

  void addRun(std::size_t first, std::vector<ZigzagCell>& cells) const {
    // Cut where the border between two lines is too long on either side.
    std::vector<std::size_t> run{first};
    const auto finish = [&] { cells.push_back({zigzag(run, true), zigzag(run, false)}); };
    for (std::size_t i = above_[first]; i != kNone; i = above_[i]) {
      Polyline2 probe;
      if (!append(probe, run.back(), i, true) || !append(probe, run.back(), i, false)) {
        finish();
        run.clear();
      }
      run.push_back(i);
    }
    finish();
  }

  const Region2& island_;
  double spacing_;
  Vec2 along_;
  std::vector<HatchSegment> segments_;
  std::vector<std::size_t> above_;
  std::vector<bool> hasBelow_;
};

}  // namespace

double centredPhase(const Region2& region, double angle, double spacing) {
  const Vec2 across(-std::sin(angle), std::cos(angle));
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Polyline2& loop : region.loops) {
    for (const Vec2& p : loop) {
      low = std::min(low, across.dot(p));
      high = std::max(high, across.dot(p));
    }
  }
  const double left = high - low - std::floor((high - low) / spacing) * spacing;
  return low + 0.5 * left;
}

std::vector<Polyline2> rasterLines(const Region2& region, double angle, double spacing) {
  std::vector<Polyline2> lines;
  for (const Region2& island : geometry::islandsOf(region)) {
    for (const HatchSegment& s :
         geometry::hatchRegion(island, angle, spacing, centredPhase(island, angle, spacing))) {
      lines.push_back({s.a, s.b});
    }
  }
  return lines;
}

std::vector<ZigzagCell> zigzagCells(const Region2& region, double angle, double spacing) {
  std::vector<ZigzagCell> cells;
  for (const Region2& island : geometry::islandsOf(region)) {
    std::vector<ZigzagCell> own = CellBuilder(island, angle, spacing).build();
    cells.insert(cells.end(), std::make_move_iterator(own.begin()),
                 std::make_move_iterator(own.end()));
  }
  return cells;
}

}  // namespace wcam::toolpath::detail
