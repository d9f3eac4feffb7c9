// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/polygon2d.hpp"

#include "polygon_clip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::geometry {

namespace {

/// Turns up to this are taken as those of a curve: rounded even where corners stay sharp, since
/// mitres at the vertices of a polygonised arc would move it by more than the tolerance. Rad.
constexpr double kGentleTurn = 0.5;
/// Lines whose directions differ by less have no intersection that rounding leaves alone.
constexpr double kParallel = 1e-9;
/// Edges shorter than this part of the size have no direction of their own.
constexpr double kShortest = 1e-10;
/// Loops that come this near to each other, in parts of the size, are handed to the exact sweep.
constexpr double kTouch = 1e-9;
/// Clean-up after the integer sweep, in units of its grid: shorter edges have garbage directions.
constexpr double kGridUnits = 64.0;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// How corners that grow are made: no piece of a turn exceeds `gentle` on curves, `sharp` on
/// corners.
struct Turns {
  double gentle = 0.1;
  double sharp = 2.0;
  double corner = kPi;  ///< turns above this are corners

  [[nodiscard]] int pieces(double turn) const {
    const double size = std::abs(turn);
    return std::max(1, static_cast<int>(std::ceil(size / (size > corner ? sharp : gentle) - 1e-9)));
  }
};

/// @param distance the whole way that the border will go, mm
Turns turnsFor(const OffsetOptions& options, double distance) {
  // A polygon around an arc of radius d with the outer angle a leaves it by d·(1/cos(a/2) − 1).
  const double error = 0.5 * options.tolerance;
  Turns turns;
  turns.gentle = 2.0 * std::acos(1.0 / (1.0 + error / std::abs(distance)));
  turns.sharp = turns.gentle;
  if (options.join == CornerJoin::Miter) {
    turns.corner = kGentleTurn;
    turns.sharp = 2.0 * std::acos(1.0 / options.miterLimit);
  }
  return turns;
}

/// A moved edge: the line through p with unit direction u.
struct Line {
  Vec2 p = Vec2::Zero();
  Vec2 u = Vec2::UnitX();
  Vec2 vertex = Vec2::Zero();  ///< start of the edge before it moved
  bool grown = false;          ///< its start is a corner that grows
};

std::optional<Vec2> intersection(const Line& a, const Line& b) {
  const double det = cross(a.u, b.u);
  if (std::abs(det) < kParallel) {
    // One line goes on in the other: the foot of the shared vertex.
    return a.u.dot(b.u) > 0.0 ? std::optional(Vec2(b.p)) : std::nullopt;
  }
  return Vec2(a.p + cross(b.p - a.p, b.u) / det * a.u);
}

/// The moved edges of a loop, with extra lines around corners that grow.
std::vector<Line> movedLines(const Polyline2& loop, double distance, const Turns& turns) {
  double size = 0.0;
  for (const Vec2& p : loop) {
    size = std::max(size, (p - loop[0]).cwiseAbs().maxCoeff());
  }
  Polyline2 points;
  for (const Vec2& p : loop) {
    if (points.empty() || (p - points.back()).norm() > kShortest * size) {
      points.push_back(p);
    }
  }
  while (points.size() > 1 && (points.front() - points.back()).norm() <= kShortest * size) {
    points.pop_back();
  }
  std::vector<Line> lines;
  const std::size_t n = points.size();
  if (n < 3) {
    return lines;
  }
  lines.reserve(n + n / 2);
  const auto outward = [](const Vec2& u) { return Vec2(u.y(), -u.x()); };
  Vec2 before = (points[0] - points[n - 1]).normalized();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& v = points[i];
    const Vec2 u = (points[(i + 1) % n] - v).normalized();
    double turn = std::atan2(cross(before, u), before.dot(u));
    if (std::abs(turn) > kPi - kParallel) {
      turn = std::copysign(turn, distance);  // a spike grows on the side that moves out
    }
    const bool grows = turn * distance > 0.0;
    if (grows) {
      const int pieces = turns.pieces(turn);
      for (int k = 1; k < pieces; ++k) {
        const double a = turn * k / pieces;
        const Vec2 w(before.x() * std::cos(a) - before.y() * std::sin(a),
                     before.x() * std::sin(a) + before.y() * std::cos(a));
        lines.push_back({v + distance * outward(w), w, v, true});
      }
    }
    lines.push_back({v + distance * outward(u), u, v, grows});
    before = u;
  }
  return lines;
}

/// The offset loop when edges only collapse and never meet others: lines that lose their length
/// leave, and their neighbours intersect instead. Nothing when this is not certain.
std::optional<Polyline2> collapsed(const std::vector<Line>& lines, double distance) {
  const std::size_t n = lines.size();
  std::vector<std::uint32_t> next(n), prev(n);
  std::vector<char> gone(n, 0);
  Polyline2 start(n);  // start of each line: intersection with the one before
  for (std::size_t i = 0; i < n; ++i) {
    next[i] = static_cast<std::uint32_t>((i + 1) % n);
    prev[i] = static_cast<std::uint32_t>((i + n - 1) % n);
    const auto p = intersection(lines[prev[i]], lines[i]);
    if (!p) {
      return std::nullopt;
    }
    start[i] = *p;
  }
  std::size_t left = n;
  std::vector<std::uint32_t> removed;
  std::size_t untouched = 0;
  for (std::uint32_t i = 0; untouched < left;) {
    if ((start[next[i]] - start[i]).dot(lines[i].u) > 0.0) {
      ++untouched;
      i = next[i];
      continue;
    }
    const std::uint32_t a = prev[i];
    const std::uint32_t b = next[i];
    if (--left < 3) {
      return std::nullopt;
    }
    gone[i] = 1;
    removed.push_back(i);
    next[a] = b;
    prev[b] = a;
    const auto p = intersection(lines[a], lines[b]);
    // A turn of the neighbours against that of the collapsed edge is no collapse.
    if (!p || lines[a].u.dot(lines[b].u) < -1.0 + kParallel) {
      return std::nullopt;
    }
    start[b] = *p;
    untouched = 0;
    i = a;
  }
  // What has gone may not lie inside the result: each new corner is beyond the lines it replaced.
  Polyline2 result;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (gone[i] == 0) {
      result.push_back(start[i]);
    }
  }
  const double slack = kShortest * (std::abs(distance) + (result[0] - lines[0].vertex).norm());
  for (const std::uint32_t i : removed) {
    std::uint32_t b = i;
    while (gone[b] != 0) {
      b = next[b];
    }
    // Inside is left of the direction: the corner must not lie right of the collapsed line when
    // the border moved in, nor left of it when it moved out.
    const double side = cross(lines[i].u, start[b] - lines[i].p);
    if (distance < 0.0 ? side < -slack : side > slack) {
      return std::nullopt;
    }
  }
  return result;
}

/// The raw curve for the sweep: where corners shrink it goes back over the vertex, so that what is
/// not on the border winds negatively.
Polyline2 rawLoop(const std::vector<Line>& lines) {
  Polyline2 result;
  const std::size_t n = lines.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Line& before = lines[(i + n - 1) % n];
    const Line& line = lines[i];
    if (line.grown) {
      if (const auto p = intersection(before, line)) {
        result.push_back(*p);
        continue;
      }
    }
    // The end of the line before: the foot of the vertex on it.
    result.push_back(before.p + before.u.dot(line.vertex - before.p) * before.u);
    if (cross(before.u, line.u) != 0.0) {
      result.push_back(line.vertex);
      result.push_back(line.p);
    }
  }
  return result;
}

/// Whether outer loops lie outside all others or in holes, and holes inside outer loops: loops that
/// move far enough pass through each other without crossing.
bool nested(const Region2& region) {
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    int winding = 0;
    for (std::size_t o = 0; o < region.loops.size(); ++o) {
      if (o != l && Region2{{region.loops[o]}}.contains(region.loops[l].front())) {
        winding += signedArea(region.loops[o]) > 0.0 ? 1 : -1;
      }
    }
    if (winding != (signedArea(region.loops[l]) > 0.0 ? 0 : 1)) {
      return false;
    }
  }
  return true;
}

/// One offset without any simplification. @param clean clean-up after the sweep, mm
Region2 moved(const Region2& region, double distance, const Turns& turns, double clean) {
  Region2 fast;
  std::vector<Polyline2> raw;
  bool sure = true;
  const double size = region.bounds().diagonal() + std::abs(distance);
  for (const Polyline2& loop : region.loops) {
    const std::vector<Line> lines = movedLines(loop, distance, turns);
    if (lines.size() < 3) {
      continue;
    }
    raw.push_back(rawLoop(lines));
    if (!sure) {
      continue;
    }
    std::optional<Polyline2> result = collapsed(lines, distance);
    sure = result && signedArea(*result) * signedArea(loop) > 0.0;
    if (sure) {
      fast.loops.push_back(std::move(*result));
    }
  }
  if (sure && !findCrossing(fast.loops, true, kTouch * size) &&
      (fast.loops.size() < 2 || nested(fast))) {
    detail::canonicalise(fast);
    return fast;
  }
  Region2 swept = detail::cleaned(raw, ClipperLib::pftPositive);
  const double unit = detail::IntegerFrame(detail::boundsOf(raw), detail::kClipperBits).unit();
  return simplified(swept, std::max(clean, kGridUnits * unit));
}

void checkOptions(double distance, const OffsetOptions& options) {
  const auto refuse = [](const Text& what, const Text& hint) {
    throw Error(ErrorCode::InvalidArgument, what, "offset", hint);
  };
  if (!std::isfinite(distance)) {
    refuse("the offset is no finite number", "give a distance in mm");
  }
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    refuse("the tolerance of an offset must be above 0", "give a tolerance such as 0.01 mm");
  }
  if (!(options.miterLimit > 1.0) || !std::isfinite(options.miterLimit)) {
    refuse("the limit of mitres must be above 1", "give a limit such as 2");
  }
}

/// Shares of the tolerance: the border's simplification, arcs (in turnsFor), clean-up.
constexpr double kSimplifyShare = 0.4;
constexpr double kCleanShare = 0.1;

}  // namespace

Region2 offsetRegion(const Region2& region, double distance, const OffsetOptions& options) {
  checkOptions(distance, options);
  detail::checkFinite(region.loops, "loop %1, point %2");
  const Region2 simple = simplified(region, kSimplifyShare * options.tolerance);
  if (distance == 0.0 || simple.empty()) {
    return simple;
  }
  return moved(simple, distance, turnsFor(options, distance), kCleanShare * options.tolerance);
}

std::vector<Region2> nestedInsets(const Region2& region,
                                  double first,
                                  double step,
                                  std::size_t count,
                                  const OffsetOptions& options) {
  checkOptions(first, options);
  checkOptions(step, options);
  if (!(step > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step between insets must be above 0", "insets",
                "give a step in mm");
  }
  detail::checkFinite(region.loops, "loop %1, point %2");
  std::vector<Region2> insets;
  Region2 current = simplified(region, kSimplifyShare * options.tolerance);
  // Nothing is left beyond half the smaller side of the bounds.
  const Box2 box = current.bounds();
  const double reach = box.empty() ? 0.0 : 0.5 * (box.max - box.min).minCoeff();
  const double levels =
      std::min(static_cast<double>(count), std::max(0.0, (reach - first) / step) + 1.0);
  const double farthest = std::max(std::abs(first), first + step * levels);
  const Turns turns = turnsFor(options, farthest);
  const double clean = kCleanShare * options.tolerance / std::max(levels, 1.0);
  for (std::size_t k = 0; k < count && !current.empty(); ++k) {
    const double distance = k == 0 ? first : step;
    if (distance != 0.0) {
      current = moved(current, -distance, turns, clean);
    }
    if (!current.empty()) {
      insets.push_back(current);
    }
  }
  return insets;
}

namespace {

/// The hull of two circles.
Polyline2 capsule(const Vec2& a, double ra, const Vec2& b, double rb, double tolerance) {
  const double r = std::max(ra, rb);
  const int n = std::max(
      8,
      static_cast<int>(std::ceil(kPi / std::acos(1.0 / (1.0 + std::min(tolerance, 0.1 * r) / r)))));
  Polyline2 points;
  for (int k = 0; k < n; ++k) {
    const Vec2 d(std::cos(2.0 * kPi * k / n), std::sin(2.0 * kPi * k / n));
    points.push_back(a + ra * d);
    points.push_back(b + rb * d);
  }
  // Convex hull (Andrew).
  std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  });
  Polyline2 hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

Region2 strokeArea(std::span<const Stroke2> strokes, double tolerance) {
  std::vector<Polyline2> all;
  for (const Stroke2& stroke : strokes) {
    all.push_back(stroke.points);
  }
  detail::checkFinite(all, "stroke %1, point %2");
  std::vector<Polyline2> pieces;
  for (const Stroke2& stroke : strokes) {
    for (const double width : stroke.widths) {
      if (!(width >= 0.0) || !std::isfinite(width)) {
        throw Error(ErrorCode::InvalidArgument, "the width of a stroke is negative or no number",
                    "stroke", "give a width in mm");
      }
    }
  }
  for (const Stroke2& stroke : strokes) {
    const std::size_t n = stroke.points.size();
    if (stroke.widths.empty() || n == 0) {
      continue;
    }
    const auto radius = [&](std::size_t i) {
      return 0.5 * (i < stroke.widths.size() ? stroke.widths[i] : stroke.widths.back());
    };
    if (stroke.widths.size() == 1) {
      // Clipper's own strokes: one call each.
      const double r = radius(0);
      Box2 own = detail::boundsOf(std::span(&stroke.points, 1));
      own.min -= Vec2::Constant(r);
      own.max += Vec2::Constant(r);
      const detail::IntegerFrame frame(own, detail::kClipperBits);
      ClipperLib::ClipperOffset offset(2.0, tolerance / frame.unit());
      offset.AddPath(frame.toPath(stroke.points), ClipperLib::jtRound,
                     stroke.closed && n > 2 ? ClipperLib::etClosedLine : ClipperLib::etOpenRound);
      ClipperLib::Paths result;
      offset.Execute(result, r / frame.unit());
      for (const ClipperLib::Path& path : result) {
        pieces.push_back(frame.toPolyline(path));
      }
      continue;
    }
    const std::size_t count = stroke.closed && n > 2 ? n : std::max<std::size_t>(n - 1, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = (i + 1) % n;
      pieces.push_back(
          capsule(stroke.points[i], radius(i), stroke.points[j], radius(j), tolerance));
    }
  }
  return detail::cleaned(pieces, ClipperLib::pftPositive);
}

}  // namespace wcam::geometry
