// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/geometry/polygon2d.hpp"

#include "polygon_clip.hpp"
#include <boost/polygon/polygon.hpp>
#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wcam::geometry {

namespace {

namespace bp = boost::polygon;
using Diagram = bp::voronoi_diagram<double>;
using IntPoint = bp::point_data<std::int32_t>;
using IntSegment = bp::segment_data<std::int32_t>;

/// Part of the tolerance that the border's simplification takes.
constexpr double kSimplifyShare = 0.5;

struct Site {
  Vec2 a, b;  ///< equal for a point

  [[nodiscard]] bool isPoint() const { return a == b; }
};

/// A Voronoi edge inside the region, between two nodes.
struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double turn = 0.0;              ///< greatest angle between the directions to the two sites, rad
  std::vector<AxisPoint> points;  ///< from one node to the other
  bool alive = true;
};

Vec2 footOn(const Site& site, const Vec2& p) {
  const Vec2 d = site.b - site.a;
  const double length2 = d.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((p - site.a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return site.a + s * d;
}

double turnAt(const Vec2& p, const Site& a, const Site& b) {
  const Vec2 da = footOn(a, p) - p;
  const Vec2 db = footOn(b, p) - p;
  return std::abs(std::atan2(da.x() * db.y() - da.y() * db.x(), da.dot(db)));
}

/// Points of the border between a point and a segment, both ends included: an arc of a parabola.
std::vector<Vec2> parabola(
    const Vec2& focus, const Site& line, const Vec2& from, const Vec2& to, double tolerance) {
  const Vec2 x = (line.b - line.a).normalized();
  Vec2 y(-x.y(), x.x());
  double height = (focus - line.a).dot(y);
  if (height < 0.0) {
    y = -y;
    height = -height;
  }
  const double x0 = (from - focus).dot(x);
  const double x1 = (to - focus).dot(x);
  const Vec2 origin = focus - height * y;
  // Sagitta of a chord over w of y = x²/(2h): w²/(8h).
  const double width = std::sqrt(8.0 * std::max(height, tolerance) * tolerance);
  constexpr double kMostPieces = 1000.0;
  const int n =
      static_cast<int>(std::clamp(std::ceil(std::abs(x1 - x0) / width), 1.0, kMostPieces));
  std::vector<Vec2> points{from};
  for (int k = 1; k < n; ++k) {
    const double s = x0 + (x1 - x0) * k / n;
    points.push_back(origin + s * x + (s * s / (2.0 * height) + 0.5 * height) * y);
  }
  points.push_back(to);
  return points;
}

class AxisBuilder {
public:
  AxisBuilder(const Region2& region, const MedialAxisOptions& options)
      : region_(region), options_(options) {}

  std::vector<AxisBranch> build() {
    makeEdges();
    prune();
    return branches();
  }

private:
  void makeEdges() {
    // Boost.Polygon works on 32-bit integers.
    const detail::IntegerFrame frame(region_.bounds(), detail::kClipperBits);
    std::vector<IntSegment> input;
    const auto toPoint = [&](const Vec2& p) {
      const ClipperLib::IntPoint q = frame.toInteger(p);
      return IntPoint(static_cast<std::int32_t>(q.X), static_cast<std::int32_t>(q.Y));
    };
    for (const Polyline2& loop : region_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const IntPoint a = toPoint(loop[i]);
        const IntPoint b = toPoint(loop[(i + 1) % loop.size()]);
        if (a != b) {
          input.emplace_back(a, b);
        }
      }
    }
    Diagram diagram;
    bp::construct_voronoi(input.begin(), input.end(), &diagram);
    const auto toVec = [&](const IntPoint& p) { return frame.point(p.x(), p.y()); };
    const auto siteOf = [&](const Diagram::cell_type& cell) {
      const IntSegment& s = input[cell.source_index()];
      if (!cell.contains_point()) {
        return Site{toVec(s.low()), toVec(s.high())};
      }
      const Vec2 p = toVec(
          cell.source_category() == bp::SOURCE_CATEGORY_SEGMENT_START_POINT ? s.low() : s.high());
      return Site{p, p};
    };
    constexpr std::uint32_t kNoNode = 0xFFFFFFFFU;
    std::vector<std::uint32_t> nodeOf(diagram.vertices().size(), kNoNode);
    const auto node = [&](const Diagram::vertex_type* v) {
      std::uint32_t& n = nodeOf[static_cast<std::size_t>(v - diagram.vertices().data())];
      if (n == kNoNode) {
        n = static_cast<std::uint32_t>(degree_.size());
        degree_.push_back(0);
      }
      return n;
    };
    for (const Diagram::edge_type& edge : diagram.edges()) {
      // Each edge once: the half whose cell comes first.
      if (!edge.is_primary() || !edge.is_finite() || edge.cell() > edge.twin()->cell()) {
        continue;
      }
      const Vec2 p0 = frame.point(edge.vertex0()->x(), edge.vertex0()->y());
      const Vec2 p1 = frame.point(edge.vertex1()->x(), edge.vertex1()->y());
      if (!region_.contains(0.5 * (p0 + p1))) {
        continue;
      }
      const Site a = siteOf(*edge.cell());
      const Site b = siteOf(*edge.twin()->cell());
      std::vector<Vec2> points{p0, p1};
      if (a.isPoint() != b.isPoint()) {
        points = parabola(a.isPoint() ? a.a : b.a, a.isPoint() ? b : a, p0, p1,
                          kSimplifyShare * options_.tolerance);
      }
      Edge result;
      result.from = node(edge.vertex0());
      result.to = node(edge.vertex1());
      result.turn = turnAt(0.5 * (p0 + p1), a, b);
      for (const Vec2& p : points) {
        result.points.push_back({p, (footOn(a, p) - p).norm()});
      }
      ++degree_[result.from];
      ++degree_[result.to];
      edges_.push_back(std::move(result));
    }
    at_.resize(degree_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      at_[edges_[e].from].push_back(e);
      at_[edges_[e].to].push_back(e);
    }
  }

  /// Removes free ends whose border turns too little, until none is left.
  void prune() {
    if (!(options_.leastTurn > 0.0)) {
      return;
    }
    findComponents();
    std::vector<std::uint32_t> open;
    for (std::uint32_t n = 0; n < degree_.size(); ++n) {
      if (degree_[n] == 1) {
        open.push_back(n);
      }
    }
    while (!open.empty()) {
      const std::uint32_t n = open.back();
      open.pop_back();
      for (const std::uint32_t e : at_[n]) {
        if (!edges_[e].alive || degree_[n] != 1) {
          continue;
        }
        const bool flat = edges_[e].turn < options_.leastTurn;
        if (!flat) {
          continue;
        }
        edges_[e].alive = false;
        --degree_[n];
        const std::uint32_t other = edges_[e].from == n ? edges_[e].to : edges_[e].from;
        if (--degree_[other] == 1) {
          open.push_back(other);
        }
      }
    }
  }

  /// Per connected piece the widest point: what is left where everything is pruned (a disc).
  void findComponents() {
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    component_.assign(edges_.size(), kNone);
    for (std::uint32_t first = 0; first < edges_.size(); ++first) {
      if (component_[first] != kNone) {
        continue;
      }
      const auto index = static_cast<std::uint32_t>(widest_.size());
      widest_.emplace_back();
      std::vector<std::uint32_t> members{first};
      component_[first] = index;
      for (std::size_t k = 0; k < members.size(); ++k) {
        const Edge& edge = edges_[members[k]];
        for (const AxisPoint& p : edge.points) {
          if (p.radius > widest_[index].radius) {
            widest_[index] = p;
          }
        }
        for (const std::uint32_t n : {edge.from, edge.to}) {
          for (const std::uint32_t e : at_[n]) {
            if (component_[e] == kNone) {
              component_[e] = index;
              members.push_back(e);
            }
          }
        }
      }
    }
  }

  std::vector<AxisBranch> branches() {
    std::vector<AxisBranch> result;
    std::vector<std::uint32_t> firstEdge;
    std::vector<char> used(edges_.size(), 0);
    for (int pass = 0; pass < 2; ++pass) {  // open branches, then rings without a junction
      for (std::uint32_t n = 0; n < degree_.size(); ++n) {
        if (pass == 0 && degree_[n] == 2) {
          continue;
        }
        for (const std::uint32_t e : at_[n]) {
          if (edges_[e].alive && used[e] == 0) {
            firstEdge.push_back(e);
            result.push_back(walk(n, e, used));
          }
        }
      }
    }
    std::vector<char> left(widest_.size(), 0);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const bool free = result[i].freeStart || result[i].freeEnd;
      if (free && lengthOf(result[i]) <= options_.tolerance) {
        continue;
      }
      if (!left.empty()) {
        left[component_[firstEdge[i]]] = 1;
      }
      std::swap(result[kept++], result[i]);
    }
    result.resize(kept);
    for (std::size_t c = 0; c < left.size(); ++c) {
      if (left[c] == 0) {
        result.push_back({{widest_[c]}, false, true, true});
      }
    }
    for (AxisBranch& branch : result) {
      finish(branch);
    }
    std::stable_sort(result.begin(), result.end(), [](const AxisBranch& a, const AxisBranch& b) {
      const AxisPoint& p = a.points.front();
      const AxisPoint& q = b.points.front();
      if (p.p != q.p) {
        return before(p.p, q.p);
      }
      return before(a.points.back().p, b.points.back().p);
    });
    return result;
  }

  AxisBranch walk(std::uint32_t start, std::uint32_t edge, std::vector<char>& used) const {
    AxisBranch branch;
    branch.freeStart = degree_[start] == 1;
    std::uint32_t n = start;
    for (;;) {
      used[edge] = 1;
      const Edge& e = edges_[edge];
      const bool forward = e.from == n;
      const std::size_t skip = branch.points.empty() ? 0 : 1;
      if (forward) {
        branch.points.insert(branch.points.end(), e.points.begin() + static_cast<long>(skip),
                             e.points.end());
      } else {
        branch.points.insert(branch.points.end(), e.points.rbegin() + static_cast<long>(skip),
                             e.points.rend());
      }
      n = forward ? e.to : e.from;
      if (n == start) {
        branch.points.pop_back();
        branch.closed = true;
        return branch;
      }
      if (degree_[n] != 2) {
        branch.freeEnd = degree_[n] == 1;
        return branch;
      }
      for (const std::uint32_t other : at_[n]) {
        if (edges_[other].alive && used[other] == 0) {
          edge = other;
        }
      }
    }
  }

  static bool before(const Vec2& a, const Vec2& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
  }

  static double lengthOf(const AxisBranch& branch) {
    double length = 0.0;
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      length += (branch.points[i].p - branch.points[i - 1].p).norm();
    }
    return length;
  }

  /// Start at the lower end, and no more points than the tolerance needs for place and radius.
  void finish(AxisBranch& branch) const {
    std::vector<AxisPoint>& points = branch.points;
    if (branch.closed) {
      std::rotate(
          points.begin(),
          std::min_element(points.begin(), points.end(),
                           [](const AxisPoint& a, const AxisPoint& b) { return before(a.p, b.p); }),
          points.end());
      if (points.size() > 2 && before(points.back().p, points[1].p)) {
        std::reverse(points.begin() + 1, points.end());
      }
      points.push_back(points.front());
    } else if (before(points.back().p, points.front().p)) {
      std::reverse(points.begin(), points.end());
      std::swap(branch.freeStart, branch.freeEnd);
    }
    std::vector<char> keep(points.size(), 0);
    keep.front() = keep.back() = 1;
    if (branch.closed) {
      // A ring's chord is a point: anchor it at the farthest point too.
      std::size_t farthest = 0;
      for (std::size_t i = 1; i < points.size(); ++i) {
        if ((points[i].p - points[0].p).squaredNorm() >
            (points[farthest].p - points[0].p).squaredNorm()) {
          farthest = i;
        }
      }
      keep[farthest] = 1;
      keepBetween(points, 0, farthest, keep);
      keepBetween(points, farthest, points.size() - 1, keep);
    } else {
      keepBetween(points, 0, points.size() - 1, keep);
    }
    std::vector<AxisPoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (keep[i] != 0) {
        kept.push_back(points[i]);
      }
    }
    if (branch.closed) {
      kept.pop_back();
    }
    points = std::move(kept);
  }

  void keepBetween(const std::vector<AxisPoint>& points,
                   std::size_t first,
                   std::size_t last,
                   std::vector<char>& keep) const {
    const auto lift = [&](std::size_t i) {
      return Vec3(points[i].p.x(), points[i].p.y(), points[i].radius);
    };
    const double tolerance = kSimplifyShare * options_.tolerance;
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      const Vec3 a = lift(from);
      const Vec3 d = lift(to) - a;
      double worst = tolerance * tolerance;
      std::size_t at = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        const Vec3 w = lift(i) - a;
        const double s =
            d.squaredNorm() > 0.0 ? std::clamp(w.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
        const double d2 = (w - s * d).squaredNorm();
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

  const Region2& region_;
  const MedialAxisOptions& options_;
  std::vector<Edge> edges_;
  std::vector<int> degree_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<std::uint32_t> component_;  ///< per edge
  std::vector<AxisPoint> widest_;         ///< per component
};

}  // namespace

std::vector<AxisBranch> medialAxis(const Region2& region, const MedialAxisOptions& options) {
  detail::checkFinite(region.loops, "loop %1, point %2");
  if (!(options.tolerance > 0.0) || !(options.leastTurn >= 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "tolerance or least turn is out of range",
                "medial axis", "give a tolerance above 0 mm and a turn from 0");
  }
  // The sweep removes what would cross on the integer grid.
  const Region2 simple = detail::cleaned(
      simplified(region, kSimplifyShare * options.tolerance).loops, ClipperLib::pftPositive);
  if (simple.empty()) {
    return {};
  }
  return AxisBuilder(simple, options).build();
}

}  // namespace wcam::geometry
