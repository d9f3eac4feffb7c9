// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace wcam::geometry {

/// A polyline in a plane, mm. A closed one (a loop) does not repeat its first point.
using Polyline2 = std::vector<Vec2>;

/// Area inside a loop, mm²; negative when it runs clockwise.
double signedArea(const Polyline2& loop);
double polylineLength(const Polyline2& points, bool closed);

struct Box2 {
  Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 max = Vec2::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec2& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }

  [[nodiscard]] bool empty() const { return !(min.x() <= max.x()); }

  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : (max - min).norm(); }
};

/// An area in a plane: outer loops run counter-clockwise, holes clockwise, so that material lies on
/// the left. Loops do not cross. Each starts at its lowest point (then leftmost), and loops are
/// ordered by these, so that equal areas have equal loops.
struct Region2 {
  std::vector<Polyline2> loops;

  [[nodiscard]] bool empty() const noexcept { return loops.empty(); }

  [[nodiscard]] double area() const;
  [[nodiscard]] double perimeter() const;
  [[nodiscard]] Box2 bounds() const;
  [[nodiscard]] std::size_t pointCount() const;
  /// Even-odd; a point on the border may count as either. Cost: O(points).
  [[nodiscard]] bool contains(const Vec2& p) const;
};

/// How loops of unknown order make a region.
enum class LoopRule {
  Orientation,  ///< inside is what counter-clockwise loops wind around more often than clockwise
                ///< ones; overlapping bodies are united
  Nesting       ///< inside is what an odd number of loops surrounds; directions do not matter
};

/// The region of closed loops that may cross, touch or overlap, may come in any order and may hold
/// repeated points. Loops with fewer than three points, or of no area, vanish.
/// @param tolerance greatest distance that the border may move, mm; micrometre edges go
/// @throws Error(InvalidArgument) for a coordinate that is no number: names loop and point
/// Cost: O((n + k) log n) for k crossings.
Region2 makeRegion(std::span<const Polyline2> loops, LoopRule rule, double tolerance);

/// Each outer loop with its holes.
std::vector<Region2> islandsOf(const Region2& region);

/// The same polyline with fewer points: no point is farther than the tolerance from it
/// (Douglas-Peucker; ends are kept, of a loop its lowest point and the farthest from it).
Polyline2 simplified(const Polyline2& points, bool closed, double tolerance);
/// Every loop simplified; loops that would cross are cleaned, loops without area vanish.
Region2 simplified(const Region2& region, double tolerance);

/// Where two segments of polylines that are no neighbours cross or touch.
struct Crossing {
  std::size_t polyline = 0;
  std::size_t segment = 0;
  std::size_t otherPolyline = 0;
  std::size_t otherSegment = 0;
  Vec2 p = Vec2::Zero();
};

/// The first crossing in the order of a grid over the segments; nothing when there is none.
/// Touching within `tolerance` counts. Cost: O(n) for segments of like length.
std::optional<Crossing> findCrossing(std::span<const Polyline2> polylines,
                                     bool closed,
                                     double tolerance);

enum class CornerJoin {
  Miter,  ///< corners stay sharp up to the limit; gentle turns are rounded, as on curves
  Round   ///< exact distance everywhere
};

struct OffsetOptions {
  CornerJoin join = CornerJoin::Miter;
  /// Greatest distance of a corner from its vertex, in offsets.
  double miterLimit = 2.0;
  /// Greatest distance of the result from the exact one, mm: simplification and arcs together.
  double tolerance = 0.01;
};

/// The region grown (distance > 0) or shrunk (distance < 0), mm. The border is simplified to half
/// the tolerance first: edges of raw slices that are shorter than rounding have no direction of
/// their own. Own raw curve with collapsing edges, O(n); where curves meet, Clipper decides.
/// @throws Error(InvalidArgument) for numbers that are none, a tolerance or miter limit out of
/// range
Region2 offsetRegion(const Region2& region, double distance, const OffsetOptions& options);

/// Insets at first, first + step, …: at most `count`, ending before the first empty one. Errors do
/// not add up with the number of insets.
std::vector<Region2> nestedInsets(const Region2& region,
                                  double first,
                                  double step,
                                  std::size_t count,
                                  const OffsetOptions& options);

Region2 unite(const Region2& a, const Region2& b);
Region2 intersect(const Region2& a, const Region2& b);
Region2 subtract(const Region2& a, const Region2& b);

/// A polyline with a width at every point, as a bead has.
struct Stroke2 {
  Polyline2 points;
  std::vector<double> widths;  ///< one per point, or one for all
  bool closed = false;
};

/// Area that strokes with round ends cover. Where the width changes along a segment, its larger one
/// holds for circles at the ends and trapezoids between.
Region2 strokeArea(std::span<const Stroke2> strokes, double tolerance);

/// The parts of open polylines inside the region, in the order and direction of the polylines.
std::vector<Polyline2> clipPolyline(const Polyline2& line, const Region2& region);

/// A piece of a hatching line inside a region.
struct HatchSegment {
  Vec2 a = Vec2::Zero();  ///< towards the lesser coordinate along the line
  Vec2 b = Vec2::Zero();
  std::int64_t line = 0;  ///< the line's number, ascending across
  /// Border of the region at a and b: loop and edge (from point `edge` to the next one).
  std::uint32_t loopA = 0, edgeA = 0, loopB = 0, edgeB = 0;
};

/// Parallel lines through a region. Line k runs along (cos angle, sin angle) at signed distance
/// `phase + k·spacing` to the left of the origin. Crossings are counted into lines, not sorted over
/// the region; a point on a line counts as left of it, so every line has an even number of
/// crossings. Segments are ordered by line, then along it.
/// @throws Error(InvalidArgument) for a spacing that is not positive or gives over 10 million lines
/// Cost: O(points + crossings).
std::vector<HatchSegment> hatchRegion(const Region2& region,
                                      double angle,
                                      double spacing,
                                      double phase = 0.0);

/// A point of a medial axis and its distance from the border, mm.
struct AxisPoint {
  Vec2 p = Vec2::Zero();
  double radius = 0.0;
};

/// A piece of a medial axis between ends and junctions.
struct AxisBranch {
  std::vector<AxisPoint> points;
  bool closed = false;
  bool freeStart = false;  ///< no other branch there
  bool freeEnd = false;
};

struct MedialAxisOptions {
  /// Greatest distance of a branch from its polyline, and of the simplified border, mm.
  double tolerance = 0.01;
  /// Free ends along which the border turns by less are pruned: they come from the vertices of
  /// polygons that stand for curves. 0 keeps the full axis of the polygon. Rad.
  double leastTurn = 0.7;
};

/// The medial axis of a region with its local radius: Voronoi edges of the simplified border
/// (Boost.Polygon) inside the region. Branches are ordered by their lowest point.
/// Cost: about 15 µs per border segment.
std::vector<AxisBranch> medialAxis(const Region2& region, const MedialAxisOptions& options);

}  // namespace wcam::geometry
