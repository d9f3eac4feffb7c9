// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/polygon2d.hpp"

#include "wcam/base/error.hpp"

#include "polygon_clip.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace wcam::geometry {

double signedArea(const Polyline2& loop) {
  if (loop.size() < 3) {
    return 0.0;
  }
  // Relative to the first point: far from the origin products would lose the digits that matter.
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec2 a = loop[i] - loop[0];
    const Vec2 b = loop[i + 1] - loop[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double polylineLength(const Polyline2& points, bool closed) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
  }
  return closed && points.size() > 1 ? length + (points.front() - points.back()).norm() : length;
}

double Region2::area() const {
  double sum = 0.0;
  for (const Polyline2& loop : loops) {
    sum += signedArea(loop);
  }
  return sum;
}

double Region2::perimeter() const {
  double sum = 0.0;
  for (const Polyline2& loop : loops) {
    sum += polylineLength(loop, true);
  }
  return sum;
}

Box2 Region2::bounds() const {
  return detail::boundsOf(loops);
}

std::size_t Region2::pointCount() const {
  std::size_t count = 0;
  for (const Polyline2& loop : loops) {
    count += loop.size();
  }
  return count;
}

bool Region2::contains(const Vec2& p) const {
  bool inside = false;
  for (const Polyline2& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2& a = loop[j];
      const Vec2& b = loop[i];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
  }
  return inside;
}

namespace detail {

namespace {

/// Lower, then left.
bool before(const Vec2& a, const Vec2& b) {
  return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

}  // namespace

IntegerFrame::IntegerFrame(const Box2& box, int bits) {
  if (box.empty()) {
    return;
  }
  origin_ = 0.5 * box.min + 0.5 * box.max;
  const double half = std::max((box.max - origin_).maxCoeff(), (origin_ - box.min).maxCoeff());
  if (half > 0.0) {
    int exponent = 0;
    std::frexp(half, &exponent);  // half <= 2^exponent
    scale_ = std::ldexp(1.0, std::clamp(bits - exponent, -1000, 1000));
  }
}

ClipperLib::IntPoint IntegerFrame::toInteger(const Vec2& p) const {
  const Vec2 q = scaled(p);
  return {std::llround(q.x()), std::llround(q.y())};
}

ClipperLib::Path IntegerFrame::toPath(const Polyline2& points) const {
  ClipperLib::Path path;
  path.reserve(points.size());
  for (const Vec2& p : points) {
    path.push_back(toInteger(p));
  }
  return path;
}

Polyline2 IntegerFrame::toPolyline(const ClipperLib::Path& path) const {
  Polyline2 points;
  points.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) {
    points.push_back(point(static_cast<double>(p.X), static_cast<double>(p.Y)));
  }
  return points;
}

void checkFinite(std::span<const Polyline2> loops, const char* place) {
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      if (!loops[l][i].allFinite()) {
        throw Error(ErrorCode::InvalidArgument, "a coordinate is no number",
                    text(place, {std::to_string(l), std::to_string(i)}),
                    "correct the geometry that the outline comes from");
      }
    }
  }
}

Box2 boundsOf(std::span<const Polyline2> loops) {
  Box2 box;
  for (const Polyline2& loop : loops) {
    for (const Vec2& p : loop) {
      box.add(p);
    }
  }
  return box;
}

void canonicalise(Region2& region) {
  for (Polyline2& loop : region.loops) {
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) {
      loop.pop_back();
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), before), loop.end());
  }
  std::erase_if(region.loops, [](const Polyline2& loop) { return loop.size() < 3; });
  std::stable_sort(region.loops.begin(), region.loops.end(),
                   [](const Polyline2& a, const Polyline2& b) {
                     if (a.front() != b.front()) {
                       return before(a.front(), b.front());
                     }
                     return signedArea(a) > signedArea(b);
                   });
}

Region2 cleaned(std::span<const Polyline2> loops, ClipperLib::PolyFillType fill) {
  Region2 region;
  const Box2 box = boundsOf(loops);
  if (!(box.diagonal() > 0.0)) {
    return region;
  }
  const IntegerFrame frame(box, kClipperBits);
  ClipperLib::Clipper clipper;
  bool any = false;
  for (const Polyline2& loop : loops) {
    any = clipper.AddPath(frame.toPath(loop), ClipperLib::ptSubject, true) || any;
  }
  if (!any) {
    return region;
  }
  ClipperLib::Paths result;
  clipper.StrictlySimple(true);
  clipper.Execute(ClipperLib::ctUnion, result, fill, fill);
  for (const ClipperLib::Path& path : result) {
    region.loops.push_back(frame.toPolyline(path));
  }
  canonicalise(region);
  return region;
}

}  // namespace detail

namespace {

/// Part of the tolerance within which loops that touch count as crossing.
constexpr double kTouch = 1e-6;
/// A loop thinner than this on average is a rounding leftover, in units of the integer grid.
constexpr double kThinnest = 8.0;

double squaredDistance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * ab).squaredNorm();
}

/// Marks the points to keep between two kept ones.
void keepBetween(const Polyline2& points,
                 std::size_t first,
                 std::size_t last,
                 double squaredTolerance,
                 std::vector<char>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = squaredTolerance;
    std::size_t at = from;
    const Vec2& b = points[to % points.size()];
    for (std::size_t i = from + 1; i < to; ++i) {
      const double d2 = squaredDistance(points[i], points[from], b);
      if (d2 > worst) {
        worst = d2;
        at = i;
      }
    }
    if (at != from) {
      keep[at] = 1;
      open.emplace_back(from, at);
      open.emplace_back(at, to);
    }
  }
}

Polyline2 pick(const Polyline2& points, const std::vector<char>& keep) {
  Polyline2 result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i] != 0) {
      result.push_back(points[i]);
    }
  }
  return result;
}

}  // namespace

Polyline2 simplified(const Polyline2& points, bool closed, double tolerance) {
  const double squaredTolerance = tolerance * tolerance;
  if (points.size() < 3) {
    return points;
  }
  std::vector<char> keep(points.size(), 0);
  if (!closed) {
    keep.front() = keep.back() = 1;
    keepBetween(points, 0, points.size() - 1, squaredTolerance, keep);
    return pick(points, keep);
  }
  // Anchors that do not depend on where the loop starts.
  Polyline2 loop = points;
  std::rotate(loop.begin(),
              std::min_element(loop.begin(), loop.end(),
                               [](const Vec2& a, const Vec2& b) {
                                 return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
                               }),
              loop.end());
  std::size_t farthest = 0;
  double most = 0.0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const double d2 = (loop[i] - loop[0]).squaredNorm();
    if (d2 > most) {
      most = d2;
      farthest = i;
    }
  }
  keep[0] = keep[farthest] = 1;
  keepBetween(loop, 0, farthest, squaredTolerance, keep);
  keepBetween(loop, farthest, loop.size(), squaredTolerance, keep);
  return pick(loop, keep);
}

Region2 simplified(const Region2& region, double tolerance) {
  Region2 result;
  for (const Polyline2& loop : region.loops) {
    Polyline2 simple = simplified(loop, true, tolerance);
    // A thin loop collapses onto its chord; it has no direction any more.
    if (simple.size() >= 3 && signedArea(simple) * signedArea(loop) > 0.0) {
      result.loops.push_back(std::move(simple));
    }
  }
  if (findCrossing(result.loops, true, kTouch * tolerance)) {
    return detail::cleaned(result.loops, ClipperLib::pftPositive);
  }
  detail::canonicalise(result);
  return result;
}

Region2 makeRegion(std::span<const Polyline2> loops, LoopRule rule, double tolerance) {
  detail::checkFinite(loops, "loop %1, point %2");
  if (!(tolerance >= 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the tolerance is negative or no number", "region");
  }
  const double unit = detail::IntegerFrame(detail::boundsOf(loops), detail::kClipperBits).unit();
  Region2 region = detail::cleaned(
      loops, rule == LoopRule::Orientation ? ClipperLib::pftPositive : ClipperLib::pftEvenOdd);
  region = simplified(region, std::max(tolerance, unit));
  std::erase_if(region.loops, [&](const Polyline2& loop) {
    return std::abs(signedArea(loop)) <= kThinnest * unit * polylineLength(loop, true);
  });
  return region;
}

std::vector<Region2> islandsOf(const Region2& region) {
  std::vector<Region2> islands;
  std::vector<double> areas;
  for (const Polyline2& loop : region.loops) {
    if (const double area = signedArea(loop); area > 0.0) {
      islands.push_back({{loop}});
      areas.push_back(area);
    }
  }
  for (const Polyline2& loop : region.loops) {
    if (signedArea(loop) >= 0.0) {
      continue;
    }
    // The smallest outer loop that holds the hole. The middle of an edge: a vertex may touch.
    const Vec2 p = 0.5 * (loop[0] + loop[1]);
    std::size_t owner = islands.size();
    for (std::size_t i = 0; i < islands.size(); ++i) {
      if ((owner == islands.size() || areas[i] < areas[owner]) &&
          Region2{{islands[i].loops.front()}}.contains(p)) {
        owner = i;
      }
    }
    if (owner < islands.size()) {
      islands[owner].loops.push_back(loop);
    }
  }
  return islands;
}

namespace {

Region2 combine(const Region2& a, const Region2& b, ClipperLib::ClipType operation) {
  std::vector<Polyline2> all = a.loops;
  all.insert(all.end(), b.loops.begin(), b.loops.end());
  detail::checkFinite(all, "loop %1, point %2");
  const Box2 box = detail::boundsOf(all);
  Region2 region;
  if (!(box.diagonal() > 0.0)) {
    return region;
  }
  const detail::IntegerFrame frame(box, detail::kClipperBits);
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  for (std::size_t l = 0; l < all.size(); ++l) {
    clipper.AddPath(frame.toPath(all[l]),
                    l < a.loops.size() ? ClipperLib::ptSubject : ClipperLib::ptClip, true);
  }
  ClipperLib::Paths result;
  clipper.Execute(operation, result, ClipperLib::pftPositive, ClipperLib::pftPositive);
  for (const ClipperLib::Path& path : result) {
    if (std::abs(ClipperLib::Area(path)) > kThinnest) {
      region.loops.push_back(frame.toPolyline(path));
    }
  }
  detail::canonicalise(region);
  return region;
}

}  // namespace

Region2 unite(const Region2& a, const Region2& b) {
  return combine(a, b, ClipperLib::ctUnion);
}

Region2 intersect(const Region2& a, const Region2& b) {
  return combine(a, b, ClipperLib::ctIntersection);
}

Region2 subtract(const Region2& a, const Region2& b) {
  return combine(a, b, ClipperLib::ctDifference);
}

std::vector<Polyline2> clipPolyline(const Polyline2& line, const Region2& region) {
  // Cut at every crossing with the border, keep the pieces whose middle lies inside: exact, and the
  // pieces keep their order.
  std::vector<Polyline2> pieces;
  Polyline2 piece;
  const auto finish = [&] {
    if (piece.size() > 1) {
      pieces.push_back(std::move(piece));
    }
    piece.clear();
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2& a = line[i];
    const Vec2 d = line[i + 1] - a;
    std::vector<double> cuts{0.0, 1.0};
    for (const Polyline2& loop : region.loops) {
      for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) {
        const Vec2 e = loop[k] - loop[j];
        const double det = d.x() * e.y() - d.y() * e.x();
        if (det == 0.0) {
          continue;
        }
        const Vec2 w = loop[j] - a;
        const double s = (w.x() * e.y() - w.y() * e.x()) / det;
        const double t = (w.x() * d.y() - w.y() * d.x()) / det;
        if (s > 0.0 && s < 1.0 && t >= 0.0 && t <= 1.0) {
          cuts.push_back(s);
        }
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      if (cuts[c] == cuts[c + 1]) {
        continue;
      }
      if (!region.contains(a + 0.5 * (cuts[c] + cuts[c + 1]) * d)) {
        finish();
        continue;
      }
      if (piece.empty()) {
        piece.push_back(a + cuts[c] * d);
      }
      piece.push_back(cuts[c + 1] == 1.0 ? line[i + 1] : Vec2(a + cuts[c + 1] * d));
    }
  }
  finish();
  return pieces;
}

}  // namespace wcam::geometry
