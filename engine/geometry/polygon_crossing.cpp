// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/polygon2d.hpp"

#include "polygon_clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wcam::geometry {

namespace {

struct Segment {
  Vec2 a, b;
  std::uint32_t polyline = 0;
  std::uint32_t index = 0;
};

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double distanceTo(const Vec2& p, const Segment& s) {
  const Vec2 d = s.b - s.a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - s.a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - s.a - t * d).norm();
}

/// Place where two segments cross, or come nearer than the tolerance.
std::optional<Vec2> meeting(const Segment& s, const Segment& o, double tolerance) {
  if (std::max(s.a.x(), s.b.x()) + tolerance < std::min(o.a.x(), o.b.x()) ||
      std::max(o.a.x(), o.b.x()) + tolerance < std::min(s.a.x(), s.b.x()) ||
      std::max(s.a.y(), s.b.y()) + tolerance < std::min(o.a.y(), o.b.y()) ||
      std::max(o.a.y(), o.b.y()) + tolerance < std::min(s.a.y(), s.b.y())) {
    return std::nullopt;
  }
  const Vec2 d = s.b - s.a;
  const double a = cross(d, o.a - s.a);
  const double b = cross(d, o.b - s.a);
  const Vec2 e = o.b - o.a;
  const double c = cross(e, s.a - o.a);
  const double f = cross(e, s.b - o.a);
  if (((a > 0.0) != (b > 0.0)) && ((c > 0.0) != (f > 0.0))) {
    return Vec2(s.a + c / (c - f) * d);
  }
  for (const Vec2& p : {o.a, o.b}) {
    if (distanceTo(p, s) <= tolerance) {
      return p;
    }
  }
  for (const Vec2& p : {s.a, s.b}) {
    if (distanceTo(p, o) <= tolerance) {
      return p;
    }
  }
  return std::nullopt;
}

std::vector<Segment> segmentsOf(std::span<const Polyline2> polylines, bool closed) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < polylines.size(); ++l) {
    const Polyline2& points = polylines[l];
    const std::size_t n = points.size();
    const std::size_t count = closed && n > 2 ? n : (n > 0 ? n - 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      segments.push_back({points[i], points[(i + 1) % n], static_cast<std::uint32_t>(l),
                          static_cast<std::uint32_t>(i)});
    }
  }
  return segments;
}

/// Square cells about as large as the mean segment; each holds the segments that pass through it.
class SegmentGrid {
public:
  SegmentGrid(const std::vector<Segment>& segments, const Box2& box, double margin)
      : segments_(segments), origin_(box.min), margin_(margin) {
    double length = 0.0;
    for (const Segment& s : segments) {
      length += (s.b - s.a).norm();
    }
    const Vec2 size = box.max - box.min;
    const auto count = static_cast<double>(segments.size());
    // Not more cells than a few per segment, whatever the shape.
    constexpr double kCellsPerSegment = 2.0;
    cell_ = std::max({length / count, std::sqrt(size.x() * size.y() / (kCellsPerSegment * count)),
                      size.maxCoeff() / (kCellsPerSegment * count)});
    columns_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
    rows_ = static_cast<std::int64_t>(size.y() / cell_) + 1;
    first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    forEachCell([&](std::size_t cell, std::uint32_t) { ++first_[cell + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) {
      first_[c] += first_[c - 1];
    }
    items_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    forEachCell([&](std::size_t cell, std::uint32_t s) { items_[next[cell]++] = s; });
  }

  [[nodiscard]] std::size_t cellCount() const { return first_.size() - 1; }

  [[nodiscard]] std::span<const std::uint32_t> cell(std::size_t c) const {
    return std::span(items_).subspan(first_[c], first_[c + 1] - first_[c]);
  }

private:
  [[nodiscard]] std::int64_t column(double x) const {
    return std::clamp(static_cast<std::int64_t>((x - origin_.x()) / cell_), std::int64_t{0},
                      columns_ - 1);
  }

  [[nodiscard]] std::int64_t row(double y) const {
    return std::clamp(static_cast<std::int64_t>((y - origin_.y()) / cell_), std::int64_t{0},
                      rows_ - 1);
  }

  /// Row by row the columns that the segment passes, widened by the margin.
  template <class Visit>
  void forEachCell(const Visit& visit) const {
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      const Vec2& low = segments_[s].a.y() <= segments_[s].b.y() ? segments_[s].a : segments_[s].b;
      const Vec2& high = segments_[s].a.y() <= segments_[s].b.y() ? segments_[s].b : segments_[s].a;
      const std::int64_t from = row(low.y() - margin_);
      const std::int64_t to = row(high.y() + margin_);
      const double slope = high.y() > low.y() ? (high.x() - low.x()) / (high.y() - low.y()) : 0.0;
      for (std::int64_t r = from; r <= to; ++r) {
        double x0 = std::min(low.x(), high.x());
        double x1 = std::max(low.x(), high.x());
        if (from != to) {
          const double y0 = origin_.y() + static_cast<double>(r) * cell_ - margin_;
          const double y1 = y0 + cell_ + 2.0 * margin_;
          const double xa = low.x() + slope * (std::clamp(y0, low.y(), high.y()) - low.y());
          const double xb = low.x() + slope * (std::clamp(y1, low.y(), high.y()) - low.y());
          if (high.y() > low.y()) {
            x0 = std::min(xa, xb);
            x1 = std::max(xa, xb);
          }
        }
        // One rounding step of the row's borders may not lose a column.
        const double pad = margin_ + kRounding * cell_;
        for (std::int64_t c = column(x0 - pad); c <= column(x1 + pad); ++c) {
          visit(static_cast<std::size_t>(r * columns_ + c), s);
        }
      }
    }
  }

  static constexpr double kRounding = 1e-6;
  const std::vector<Segment>& segments_;
  Vec2 origin_;
  double margin_ = 0.0;
  double cell_ = 1.0;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> items_;
};

}  // namespace

std::optional<Crossing> findCrossing(std::span<const Polyline2> polylines,
                                     bool closed,
                                     double tolerance) {
  const std::vector<Segment> segments = segmentsOf(polylines, closed);
  const Box2 box = detail::boundsOf(polylines);
  if (segments.size() < 2 || !(box.diagonal() > 0.0)) {
    return std::nullopt;
  }
  const SegmentGrid grid(segments, box, tolerance);
  const auto neighbours = [&](const Segment& a, const Segment& b) {
    if (a.polyline != b.polyline) {
      return false;
    }
    const std::uint32_t apart = a.index > b.index ? a.index - b.index : b.index - a.index;
    return apart <= 1 || (closed && apart + 1 == polylines[a.polyline].size());
  };
  for (std::size_t c = 0; c < grid.cellCount(); ++c) {
    const auto items = grid.cell(c);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        const Segment& a = segments[items[i]];
        const Segment& b = segments[items[j]];
        if (neighbours(a, b)) {
          continue;
        }
        if (const auto p = meeting(a, b, tolerance)) {
          return Crossing{a.polyline, a.index, b.polyline, b.index, *p};
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace wcam::geometry
