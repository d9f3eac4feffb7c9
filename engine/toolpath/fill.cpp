// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/fill.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include "fill_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace wcam::toolpath {

using geometry::AxisBranch;
using geometry::CornerJoin;
using geometry::OffsetOptions;
using geometry::Polyline2;
using geometry::Region2;

namespace {

/// Medial axes of narrow places need no more precision than this part of the bead's spacing.
constexpr double kAxisTolerance = 0.02;
/// A narrow place is found by growing insets back; what rounding leaves is thinner than this part
/// of the spacing.
constexpr double kRounding = 1e-3;
/// An inset thinner than this part of the spacing is a sliver.
constexpr double kSliver = 0.05;
/// Longest bridge between zigzag cells that are joined, in spacings.
constexpr double kReach = 2.5;
/// Strokes for the coverage are round within this part of the bead's width.
constexpr double kStrokeTolerance = 0.01;

void check(const FillOptions& o) {
  const auto refuse = [](const Text& what, const Text& place, const Text& hint) {
    throw Error(ErrorCode::InvalidArgument, what, place, hint);
  };
  if (!(o.width > 0.0) || !std::isfinite(o.width)) {
    refuse("the bead width is not above 0", "bead width", "give the width of a single bead in mm");
  }
  if (!(o.overlap > 0.0) || !(o.overlap <= 1.0)) {
    refuse("the centre distance must be above 0 and at most 1 bead width", "overlap",
           "0.667 gives a level surface");
  }
  if (!(o.minWidth > 0.0) || !(o.minWidth <= o.maxWidth) || !std::isfinite(o.maxWidth)) {
    refuse("the least bead width is above the greatest one", "min_width",
           "give a range that holds the bead width");
  }
  if (o.walls < 0 || o.insets < 0) {
    refuse("the number of walls is negative", "walls", "give a number from 0");
  }
  if (!(o.tolerance > 0.0) || !std::isfinite(o.angle) || !(o.minLength >= 0.0)) {
    refuse("tolerance, angle or least length is out of range", "fill", "");
  }
}

bool isHatched(FillPattern pattern) {
  return pattern == FillPattern::Raster || pattern == FillPattern::Zigzag ||
         pattern == FillPattern::Hybrid || pattern == FillPattern::Continuous;
}

/// Beads share the area in cells: one spacing wide, along the centre lines. The first cell begins
/// half a spacing outside the first centre line.
class Filler {
public:
  Filler(const Region2& region, const FillOptions& options)
      : region_(region),
        o_(options),
        spacing_(options.spacing()),
        first_(options.firstCentreLine()),
        offset_{CornerJoin::Miter, 2.0, options.tolerance} {}

  FillResult run() {
    if (o_.pattern == FillPattern::Medial) {
      medial();
    } else {
      parallel();
    }
    order();
    return std::move(result_);
  }

private:
  [[nodiscard]] std::size_t contourLimit() const {
    switch (o_.pattern) {
      case FillPattern::Contour:
      case FillPattern::Spiral:
        return std::numeric_limits<std::size_t>::max();
      case FillPattern::Hybrid:
        return static_cast<std::size_t>(o_.walls + o_.insets);
      default:
        return static_cast<std::size_t>(o_.walls);
    }
  }

  void parallel() {
    const std::size_t limit = contourLimit();
    std::vector<Region2> loops = geometry::nestedInsets(region_, first_, spacing_, limit, offset_);
    for (Region2& level : loops) {
      level = withoutSlivers(level);
    }
    const bool hatched = isHatched(o_.pattern);
    const std::vector<Region2> cells = geometry::nestedInsets(
        region_, first_ - 0.5 * spacing_, spacing_,
        hatched && limit < std::numeric_limits<std::size_t>::max() ? limit + 1 : limit, offset_);
    const bool hatching = hatched && loops.size() == limit && cells.size() > limit;
    layContours(loops, hatching);
    for (std::size_t k = 0; k < cells.size() && k < limit; ++k) {
      fillNarrow(cells[k], k < loops.size() ? loops[k] : Region2{}, static_cast<int>(k));
    }
    if (hatching) {
      hatch(loops, cells[limit], static_cast<int>(limit));
    }
  }

  /// Where the section is as wide as a bead, insets are slivers around which a contour would run
  /// back along itself: one bead along the middle fills that place.
  [[nodiscard]] Region2 withoutSlivers(const Region2& loops) const {
    Region2 kept;
    for (const Region2& island : geometry::islandsOf(loops)) {
      if (2.0 * island.area() > kSliver * spacing_ * island.perimeter()) {
        kept.loops.insert(kept.loops.end(), island.loops.begin(), island.loops.end());
      }
    }
    return kept.loops.size() == loops.loops.size() ? loops : kept;
  }

  void layContours(const std::vector<Region2>& loops, bool hatching) {
    const auto walls = static_cast<std::size_t>(o_.walls);
    if (o_.pattern == FillPattern::Continuous && hatching) {
      return;  // joined with the hatching
    }
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (o_.pattern == FillPattern::Spiral && k >= walls) {
        const std::vector<Region2> inner(loops.begin() + static_cast<long>(k), loops.end());
        addOpen(detail::spirals(inner, spacing_), BeadFeature::Fill, static_cast<int>(k));
        return;
      }
      addLoops(loops[k], static_cast<int>(k));
    }
  }

  /// Lines may end on the border of this region: one spacing from the last contour.
  void hatch(const std::vector<Region2>& loops, const Region2& cell, int level) {
    // Grown by the tolerance, so that lines along its border count as inside.
    const Region2 area =
        geometry::offsetRegion(region_, -(first_ + level * spacing_) + o_.tolerance, offset_);
    std::vector<Polyline2> lines;
    if (o_.pattern == FillPattern::Raster) {
      lines = detail::rasterLines(area, o_.angle, spacing_);
    } else if (o_.pattern == FillPattern::Continuous) {
      lines = continuousLines(loops, area);
    } else {
      for (detail::ZigzagCell& cellPath : detail::zigzagCells(area, o_.angle, spacing_)) {
        lines.push_back(std::move(cellPath.forward));
      }
    }
    addOpen(lines, BeadFeature::Fill, level);
    fillRest(geometry::subtract(cell, reachedByLines(level)), level);
  }

  /// Contours and zigzag cells joined. Contours that end beside a cell join it more often, but not
  /// always: what gives fewer beads counts.
  [[nodiscard]] std::vector<Polyline2> continuousLines(const std::vector<Region2>& loops,
                                                       const Region2& area) const {
    std::vector<detail::Joinable> cells;
    std::vector<Vec2> ends;
    for (detail::ZigzagCell& cell : detail::zigzagCells(area, o_.angle, spacing_)) {
      for (const Polyline2& way : {cell.forward, cell.backward}) {
        ends.push_back(way.front());
        ends.push_back(way.back());
      }
      cells.push_back({{std::move(cell.forward), std::move(cell.backward)}});
    }
    const Region2 inside = geometry::offsetRegion(region_, -first_ + o_.tolerance, offset_);
    std::vector<Polyline2> best;
    for (const std::vector<Vec2>& goals : {ends, std::vector<Vec2>{}}) {
      std::vector<detail::Joinable> pieces;
      for (Polyline2& spiral : detail::spirals(loops, spacing_, goals)) {
        pieces.push_back({{std::move(spiral)}});
      }
      pieces.insert(pieces.end(), cells.begin(), cells.end());
      std::vector<Polyline2> joined = detail::joinPieces(pieces, inside, kReach * spacing_);
      if (best.empty() || joined.size() < best.size()) {
        best = std::move(joined);
      }
    }
    return best;
  }

  /// Cells of the open beads of a level. Lines at a fixed distance do not end at every border: what
  /// is left between the last line and the contour may take a bead of its own.
  [[nodiscard]] Region2 reachedByLines(int level) const {
    std::vector<geometry::Stroke2> strokes;
    for (const FillBead& bead : result_.beads) {
      if (bead.group == level && !bead.closed && bead.widths.empty()) {
        strokes.push_back({bead.points, {(1.0 + kRounding) * spacing_}, false});
      }
    }
    return geometry::strokeArea(strokes, kStrokeTolerance * spacing_);
  }

  /// Contours while the rest is wider than the widest bead; beads on the medial axis elsewhere.
  void medial() {
    OffsetOptions offset = offset_;
    // Offsets of offsets: each may use a part of the tolerance.
    constexpr double kShare = 0.25;
    offset.tolerance *= kShare;
    Region2 cell = geometry::offsetRegion(region_, -(first_ - 0.5 * spacing_), offset);
    for (int level = 0; !cell.empty(); ++level) {
      const double single = 0.5 * thicknessOf(o_.maxWidth, level);
      const Region2 core =
          geometry::offsetRegion(geometry::offsetRegion(cell, -single, offset), single, offset);
      const Region2 loops = geometry::offsetRegion(core, -0.5 * spacing_, offset);
      fillRest(geometry::subtract(cell, core), level);
      addLoops(loops, level);
      cell = geometry::offsetRegion(loops, -0.5 * spacing_, offset);
    }
  }

  /// Thickness of the cell that a bead of this width fills. On the border the bead reaches over its
  /// cell; inside it shares the overlap.
  [[nodiscard]] double thicknessOf(double width, int level) const {
    return level == 0 ? std::max(width - borderExtra(), 0.0) : o_.overlap * width;
  }

  [[nodiscard]] double widthOf(double thickness, int level) const {
    return level == 0 ? thickness + borderExtra() : thickness / o_.overlap;
  }

  [[nodiscard]] double borderExtra() const { return std::max(0.0, 2.0 * first_ - spacing_); }

  /// What a contour or the hatching does not reach, since it is narrower than a bead.
  void fillNarrow(const Region2& cell, const Region2& centreLines, int level) {
    if (centreLines.empty()) {
      fillRest(cell, level);
      return;
    }
    const Region2 reached =
        geometry::offsetRegion(centreLines, (0.5 + kRounding) * spacing_, offset_);
    fillRest(geometry::subtract(cell, reached), level);
  }

  /// Beads along the medial axis of places where no contour fits.
  void fillRest(const Region2& rest, int level) {
    // Leftovers of rounding are cheaper to recognise by their area than by their axis.
    for (const Region2& piece : geometry::islandsOf(rest)) {
      if (2.0 * piece.area() <= kRounding * spacing_ * piece.perimeter()) {
        continue;
      }
      const std::size_t before = result_.beads.size();
      // Most pieces are slivers beside curved borders, and a medial axis is dear: an area over its
      // border tells the mean thickness, which a place for a bead does not exceed many times.
      constexpr double kThickest = 3.0;
      const bool thin = level > 0 && kThickest * 2.0 * piece.area() <
                                         thicknessOf(o_.minWidth, level) * piece.perimeter();
      if (!thin && piece.bounds().diagonal() >= o_.minLength) {
        for (const AxisBranch& branch :
             geometry::medialAxis(piece, {kAxisTolerance * spacing_, kLeastTurn})) {
          layOnAxis(branch, level);
        }
      }
      if (!thin && result_.beads.size() == before) {
        // A square or round place has an axis too short for a bead, but may take a small contour.
        for (const Polyline2& loop :
             geometry::offsetRegion(piece, -0.5 * spacing_, offset_).loops) {
          if (geometry::polylineLength(loop, true) >= o_.minLength) {
            result_.beads.push_back({loop, {}, true, BeadFeature::Inset, level});
          }
        }
      }
    }
  }

  void layOnAxis(const AxisBranch& branch, int level) {
    FillBead bead;
    bead.feature = BeadFeature::Fill;
    bead.group = level;
    double thickest = 0.0;
    double axisLength = 0.0;
    Vec2 widest = branch.points.front().p;
    bool any = false;
    const auto finish = [&] {
      if (bead.points.size() > 1 && geometry::polylineLength(bead.points, false) >= o_.minLength) {
        any = true;
        result_.beads.push_back(bead);
      }
      bead.points.clear();
      bead.widths.clear();
    };
    std::vector<geometry::AxisPoint> points = branch.points;
    if (branch.closed) {
      points.push_back(points.front());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double width = widthOf(2.0 * points[i].radius, level);
      if (i > 0) {
        axisLength += (points[i].p - points[i - 1].p).norm();
      }
      if (width > thickest) {
        thickest = width;
        widest = points[i].p;
      }
      const bool wide = width >= o_.minWidth * (1.0 - kRounding);
      if (i > 0) {
        // The place between two points where the width is the least one begins or ends a bead.
        const double before = widthOf(2.0 * points[i - 1].radius, level);
        const bool wasWide = before >= o_.minWidth * (1.0 - kRounding);
        if (wide != wasWide) {
          const double s = std::clamp((o_.minWidth - before) / (width - before), 0.0, 1.0);
          push(bead, points[i - 1].p + s * (points[i].p - points[i - 1].p), o_.minWidth);
          if (!wide) {
            finish();
          }
        }
      }
      if (wide) {
        push(bead, points[i].p, width);
      }
    }
    if (branch.closed && bead.points.size() == points.size()) {
      bead.points.pop_back();
      bead.widths.pop_back();
      bead.closed = true;
      any = true;
      result_.beads.push_back(bead);
    } else {
      finish();
    }
    const double needed = o_.pattern == FillPattern::Medial ? o_.minWidth : o_.width;
    if (level == 0 && axisLength >= o_.minLength && thickest < needed * (1.0 - kRounding)) {
      result_.narrow.push_back({widest, thickest, any});
    }
  }

  void push(FillBead& bead, const Vec2& p, double width) const {
    if (!o_.fillNarrow) {
      return;
    }
    bead.points.push_back(p);
    bead.widths.push_back(std::clamp(width, o_.minWidth, o_.maxWidth));
  }

  void addLoops(const Region2& loops, int level) {
    for (const Polyline2& loop : loops.loops) {
      result_.beads.push_back({loop, {}, true, BeadFeature::Inset, level});
    }
  }

  void addOpen(const std::vector<Polyline2>& lines, BeadFeature feature, int level) {
    for (const Polyline2& joined : lines) {
      // Joints may repeat a point.
      std::vector<Polyline2> open{geometry::simplified(joined, false, kRounding * o_.tolerance)};
      while (!open.empty()) {
        Polyline2 line = std::move(open.back());
        open.pop_back();
        // Borders that wind between two lines can lead a joint over its own bead: it ends there.
        if (const auto crossing = geometry::findCrossing(std::span(&line, 1), false, 0.0)) {
          const auto cut = static_cast<long>(std::max(crossing->segment, crossing->otherSegment));
          open.emplace_back(line.begin() + cut, line.end());
          line.resize(static_cast<std::size_t>(cut) + 1);
          open.push_back(std::move(line));
          continue;
        }
        addLine(std::move(line), feature, level);
      }
    }
  }

  void addLine(Polyline2 line, BeadFeature feature, int level) {
    if (geometry::polylineLength(line, false) >= o_.minLength) {
      result_.beads.push_back({std::move(line), {}, false, feature, level});
    }
  }

  void order() {
    const bool insideFirst =
        o_.order == InsetOrder::InsideFirst ||
        (o_.order == InsetOrder::Automatic && o_.pattern == FillPattern::Medial);
    if (insideFirst) {
      int last = 0;
      for (const FillBead& bead : result_.beads) {
        last = std::max(last, bead.group);
      }
      for (FillBead& bead : result_.beads) {
        bead.group = last - bead.group;
      }
    }
    std::stable_sort(result_.beads.begin(), result_.beads.end(),
                     [](const FillBead& a, const FillBead& b) { return a.group < b.group; });
  }

  /// Axes of narrow places end where the border turns by less: beads do not run into the corners of
  /// polygons that stand for curves. Rad.
  static constexpr double kLeastTurn = 1.0;

  const Region2& region_;
  const FillOptions& o_;
  double spacing_;
  double first_;  ///< centre line of the first contour, inwards from the border
  OffsetOptions offset_;
  FillResult result_;
};

}  // namespace

double FillOptions::firstCentreLine() const {
  switch (reference) {
    case BeadReference::Inside:
      return 0.5 * width;
    case BeadReference::Centre:
      return 0.0;
    case BeadReference::Outside:
      return -0.5 * width;
  }
  return 0.0;
}

FillResult fillRegion(const Region2& region, const FillOptions& options) {
  check(options);
  return Filler(region, options).run();
}

FillCoverage fillCoverage(const Region2& region,
                          const std::vector<FillBead>& beads,
                          const FillOptions& options) {
  check(options);
  const double tolerance = kStrokeTolerance * options.width;
  FillCoverage coverage;
  coverage.area = region.area();
  std::vector<geometry::Stroke2> strokes;
  for (const FillBead& bead : beads) {
    if (bead.widths.empty()) {
      strokes.push_back({geometry::simplified(bead.points, bead.closed, tolerance),
                         {options.width},
                         bead.closed});
    } else {
      strokes.push_back({bead.points, bead.widths, bead.closed});
    }
  }
  const Region2 voids = geometry::subtract(region, geometry::strokeArea(strokes, tolerance));
  coverage.covered = coverage.area - voids.area();
  for (const Region2& piece : geometry::islandsOf(voids)) {
    const double area = piece.area();
    if (area > coverage.largestVoidArea) {
      coverage.largestVoidArea = area;
      coverage.largestVoid = 0.5 * (piece.bounds().min + piece.bounds().max);
    }
  }
  return coverage;
}

}  // namespace wcam::toolpath
